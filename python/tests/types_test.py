#!/usr/bin/env python3
"""The types in _morskin.pyi are those of the extension, and everything has a docstring; the slow
packages_test.py asks mypy. Usage: types_test.py folder-of-the-package"""

from support import BALLS, MOLECULES, ROOT, ModuleTest, main

import ast
import inspect
import re

import morskin
import numpy as np
from morskin import _morskin

STUBS = ast.parse((ROOT / "python" / "morskin" / "_morskin.pyi").read_text("utf-8"))


def functions(body):
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def public(names):
    return {name for name in names if not name.startswith("_")}


def keywords(function):
    """By name, the defaults of the keyword-only arguments, where the stub has them."""
    arguments = function.args
    return {a.arg: ast.literal_eval(default)
            for a, default in zip(arguments.kwonlyargs, arguments.kw_defaults)
            if ast.literal_eval(default) is not ...}


class Types(ModuleTest):
    def test_the_stub_has_the_names_of_the_extension_and_no_other(self):
        classes = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}
        known = public(classes) | public(functions(STUBS.body))
        self.assertEqual(known, public(vars(_morskin)))
        for name in public(classes):
            self.assertEqual(public(functions(classes[name].body)),
                             public(vars(getattr(_morskin, name))), name)

    def test_every_keyword_of_the_stub_is_one_and_takes_its_default(self):
        (skin_class,) = [n for n in STUBS.body if getattr(n, "name", "") == "Skin"]
        methods = functions(skin_class.body)
        skin = morskin.Skin(*BALLS, **keywords(methods["__init__"]))
        mesh = skin.mesh(**keywords(methods["mesh"]))
        self.assertEqual(mesh.vertices.tobytes(), skin.mesh().vertices.tobytes())
        skin.morse_smale(**keywords(methods["morse_smale"]))
        check = functions(STUBS.body)["check"]
        self.assertTrue(morskin.check(mesh.vertices, mesh.faces, skin, **keywords(check)).certified)

    def test_everything_public_says_what_it_is(self):
        for name in morskin.__all__:
            thing = getattr(morskin, name)
            self.assertTrue(isinstance(thing, str) or inspect.getdoc(thing), name)
            if inspect.isclass(thing) and thing.__module__ == "morskin._morskin":
                for member in public(vars(thing)):
                    self.assertTrue(getattr(thing, member).__doc__, f"{name}.{member}")

    def test_help_names_every_argument(self):
        with_help = [(morskin.check, functions(STUBS.body)["check"])]
        for node in STUBS.body:
            if not isinstance(node, ast.ClassDef) or node.name not in morskin.__all__:
                continue
            kind = getattr(morskin, node.name)
            for name, method in functions(node.body).items():
                with_help.append((kind if name == "__init__" else getattr(kind, name), method))
        named = [(thing, [a.arg for a in node.args.args + node.args.kwonlyargs])
                 for thing, node in with_help]
        named += [(thing, list(inspect.signature(thing).parameters)) for thing in (
            morskin.read, morskin.features, morskin.Molecule.mesh, morskin.Molecule.skin)]
        for thing, names in named:
            for name in set(names) - {"self"}:
                self.assertRegex(thing.__doc__, rf"\b{name}\b", thing)

    def test_a_call_with_arguments_that_are_none_of_a_function_is_a_type_error_of_one_line(self):
        skin = morskin.Skin(*BALLS)
        mesh = skin.mesh(C=0.3)
        for call, text in (
                (lambda: skin.mesh(densty=5), "mesh(): got an unexpected keyword argument "
                 "'densty'"),
                (lambda: skin.mesh(0.2), "mesh(): too many positional arguments"),
                (lambda: mesh.to_vtk(1), "to_vtk(): too many positional arguments"),
                (lambda: mesh.save(), "save(): missing a required argument: 'file'"),
                (lambda: morskin.Skin([[0, 0, 0]] * 99), "Skin(): missing a required argument: "
                 "'radii'"),
                (lambda: morskin.Skin(*BALLS, "vdw", model="sas"), "Skin(): multiple values for "
                 "argument 'model'"),
                (lambda: morskin.Skin.mesh(3), "mesh(): self is of another class"),
                (lambda: morskin.read_mesh(), "read_mesh(): missing a required argument: 'file'")):
            with self.subTest(text), self.assertRaises(TypeError) as caught:
                call()
            self.assertEqual(str(caught.exception), text)

    def test_every_array_s_text_has_its_shape_and_type(self):
        skin = morskin.read(MOLECULES / "ring12.xyzr").skin()
        for thing in (skin.mesh(C=0.3), skin.critical_points(), skin.morse_smale()):
            arrays = {name: getattr(thing, name) for name, member in vars(type(thing)).items()
                      if isinstance(getattr(thing, name), np.ndarray)}
            self.assertGreater(len(arrays), 2)
            for name, array in arrays.items():
                with self.subTest(type(thing).__name__, array=name):
                    text = getattr(type(thing), name).__doc__
                    shape, kind = re.match(r"\(([a-z][a-z0-9 +,]*)\) (\w+): ", text).groups()
                    self.assertEqual(kind, array.dtype.name)
                    sizes = [size.strip() for size in shape.rstrip(",").split(",")]
                    self.assertEqual(len(sizes), array.ndim)
                    for size, length in zip(sizes, array.shape):
                        if size.isdigit():
                            self.assertEqual(int(size), length)

    def test_the_version_is_the_project_s(self):
        text = (ROOT / "CMakeLists.txt").read_text("utf-8")
        self.assertIn(f"VERSION {morskin.__version__} ", text)


if __name__ == "__main__":
    main()

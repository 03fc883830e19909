#!/usr/bin/env python3
"""Skins, meshes and their arrays. Usage: mesh_test.py folder-of-the-package"""

from support import BALLS, COARSE, MOLECULES, ModuleTest, main

import gc
import math
import weakref

import morskin
import numpy as np

# [U] allows triangles as large as the balls, too large to be proved near the skin.
BAD = {"C": 0.9, "Q": 1.9, "angle_goal_deg": 0}


def areas(mesh):
    """By face, Angstrom^2, and the vectors along the normals."""
    a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    return np.linalg.norm(cross, axis=1) / 2, cross


class Meshes(ModuleTest):
    def test_a_bundled_molecule_is_read_meshed_certified_and_saved(self):
        molecule = morskin.read(MOLECULES / "caffeine.xyz")
        self.assertEqual(molecule.positions.shape, (24, 3))
        self.assertEqual(molecule.radii.shape, (24,))
        self.assertEqual(len(molecule), 24)
        mesh = molecule.mesh(density=5)
        self.assertTrue(mesh.certificate.certified)
        self.assertEqual(mesh.certificate.reason, "")
        self.assertGreaterEqual(mesh.certificate.min_angle_deg, 30)
        self.assertAlmostEqual(len(mesh.vertices) / mesh.certificate.area, 5, delta=0.5)
        self.assertEqual((mesh.certificate.components, mesh.certificate.genus),
                         (mesh.skin.components, mesh.skin.genus))
        for name in ("m.ply", "m.off", "m.obj"):
            path = mesh.save(self.folder / name)
            self.assertEqual(path, self.folder / name)
            vertices, faces = morskin.read_mesh(str(path))
            np.testing.assert_array_equal(vertices, mesh.vertices)
            np.testing.assert_array_equal(faces, mesh.faces)

    def test_a_saved_mesh_holds_the_data_that_are_asked_for(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        mesh.save(self.folder / "told.npz", vertex_data=["curvature", "atom", "atom"])
        told = np.load(self.folder / "told.npz")
        np.testing.assert_array_equal(told["vertices"], mesh.vertices)
        np.testing.assert_array_equal(told["atom"], mesh.atoms)
        np.testing.assert_allclose(np.column_stack([told["k1"], told["k2"]]), mesh.curvatures,
                                   rtol=1e-12)
        self.assertNotIn("share1", told)
        mesh.save(self.folder / "all.npz", vertex_data="all")
        self.assertIn("share1", np.load(self.folder / "all.npz"))
        mesh.save(self.folder / "plain.npz")
        normals = np.load(self.folder / "plain.npz")["normals"]
        np.testing.assert_allclose(normals, mesh.normals, atol=1e-14)
        for name in ("m.ply", "m.vtu", "m.msh"):
            plain = mesh.save(self.folder / name).stat().st_size
            told = mesh.save(self.folder / name, vertex_data=("normal",)).stat().st_size
            self.assertGreater(told, plain)
        vertices, _ = morskin.read_mesh(self.folder / "m.ply")
        np.testing.assert_array_equal(vertices, mesh.vertices)
        for name, data in (("m.off", "normal"), ("m.ply", "charges"), ("m.vert", "all"),
                           ("m.ply", ["normal", ""])):
            with self.assertRaises(morskin.RefusedInput):
                mesh.save(self.folder / name, vertex_data=data)

    def test_area_and_volume_of_the_arrays_are_the_certificate_s(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        face_areas, _ = areas(mesh)
        self.assertAlmostEqual(face_areas.sum() / mesh.certificate.area, 1, places=9)
        a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
        volume = (a * np.cross(b, c)).sum() / 6
        self.assertAlmostEqual(volume / mesh.certificate.volume, 1, places=9)

    def test_faces_and_normals_point_outwards(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        _, cross = areas(mesh)
        self.assertGreater((cross * mesh.normals[mesh.faces].sum(axis=1)).sum(axis=1).min(), 0)
        self.assertAlmostEqual(np.linalg.norm(mesh.normals, axis=1).max(), 1, places=12)

    def test_on_a_ball_everything_is_what_it_is_on_a_ball(self):
        mesh = morskin.Skin([[1, 2, 3]], [2.0]).mesh(**COARSE)
        out = mesh.vertices - [1, 2, 3]
        np.testing.assert_allclose(np.linalg.norm(out, axis=1), 2)
        np.testing.assert_allclose(mesh.normals, out / 2, atol=1e-12)
        np.testing.assert_allclose(mesh.curvatures, 0.5)
        np.testing.assert_allclose(mesh.length_scales, 2)
        np.testing.assert_array_equal(mesh.atoms, 0)
        np.testing.assert_array_equal(mesh.atom_ids, [[0, -1, -1, -1]] * len(out))
        np.testing.assert_array_equal(mesh.atom_weights, [[1, 0, 0, 0]] * len(out))
        np.testing.assert_array_equal(mesh.components, 0)

    def test_shares_add_up_and_belong_to_atoms(self):
        molecule = morskin.read(MOLECULES / "caffeine.xyz")
        mesh = molecule.mesh(**COARSE)
        self.assertEqual(mesh.atom_ids.shape, (len(mesh.vertices), 4))
        np.testing.assert_allclose(mesh.atom_weights.sum(axis=1), 1)
        self.assertTrue(((mesh.atom_ids >= 0) | (mesh.atom_weights == 0)).all())
        self.assertLess(mesh.atom_ids.max(), len(molecule))
        # x - N, with |N| the length scale, is the shares' mean of the atoms.
        is_outside = (mesh.curvatures > 0).all(axis=1)  # there N has the normal's direction
        mean = (mesh.atom_weights[..., None] * molecule.positions[mesh.atom_ids]).sum(axis=1)
        origin = mesh.vertices - mesh.length_scales[:, None] * mesh.normals
        np.testing.assert_allclose(mean[is_outside], origin[is_outside], atol=1e-9)

    def test_atoms_are_of_the_least_power_distance(self):
        molecule = morskin.read(MOLECULES / "5tmn_ligand.pdb")
        mesh = molecule.mesh(**COARSE)
        squared = ((mesh.vertices[:, None] - molecule.positions) ** 2).sum(axis=2)
        power = squared - 2 * molecule.radii ** 2
        own = power[np.arange(len(power)), mesh.atoms]
        self.assertLess((own - power.min(axis=1)).max(), 1e-9)

    def test_curvatures_go_with_their_directions(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        curvatures, directions = mesh.curvatures, mesh.directions
        self.assertEqual(directions.shape, (len(mesh.vertices), 2, 3))
        np.testing.assert_allclose(abs(curvatures).max(axis=1) * mesh.length_scales, 1)
        np.testing.assert_allclose((directions * mesh.normals[:, None]).sum(axis=2), 0, atol=1e-9)
        np.testing.assert_allclose(np.cross(directions[:, 0], directions[:, 1]), mesh.normals,
                                   atol=1e-9)
        # About the x axis the neck is as wide as its circle is round, along it hollow.
        is_neck = curvatures.min(axis=1) < 0
        self.assertTrue(is_neck.any())
        hollow = directions[is_neck, 1]
        np.testing.assert_allclose(np.cross(hollow, mesh.normals[is_neck])[:, 0], 0, atol=1e-9)

    def test_the_first_curvature_is_the_larger_in_pits_too(self):
        mesh = morskin.Skin([[0, 0, 0], [2, 0, 0], [1, 1.7, 0]], [1.5, 1.5, 1.5]).mesh(**COARSE)
        k1, k2 = mesh.curvatures.T
        self.assertTrue((k1 >= k2).all())
        self.assertTrue((k1 < -k2).any())

    def test_components_are_those_of_the_mesh(self):
        mesh = morskin.Skin([[0, 0, 0], [9, 0, 0]], [1, 2]).mesh(**COARSE)
        self.assertEqual(mesh.certificate.components, 2)
        self.assertEqual(set(mesh.components), {0, 1})
        for component in (0, 1):
            self.assertEqual(len(set(mesh.atoms[mesh.components == component])), 1)
        self.assertTrue((mesh.components[mesh.faces] == mesh.components[mesh.faces[:, :1]]).all())

    def test_any_number_of_threads_makes_the_same_bytes(self):
        meshes = [morskin.read(MOLECULES / "c60.xyz").mesh(C=0.2, threads=threads)
                  for threads in (1, 2, None)]
        for mesh in meshes[1:]:
            self.assertEqual(mesh.vertices.tobytes(), meshes[0].vertices.tobytes())
            self.assertEqual(mesh.faces.tobytes(), meshes[0].faces.tobytes())

    def test_every_model_and_option_of_a_skin_counts(self):
        shell = morskin.read(MOLECULES / "shell_hollow.xyzr")
        self.assertEqual(shell.skin().components, 2)
        self.assertEqual(shell.skin(drop_voids_below=math.inf).components, 1)
        areas_of = {model: morskin.Skin([[0, 0, 0]], [1.5], model).mesh().certificate.area
                    for model in ("vdw", "sas", "ses-like", "paper")}
        for model, radius in {"vdw": 1.5, "sas": 2.9, "ses-like": 1.75,
                              "paper": math.sqrt(2.9 / math.sqrt(2))}.items():
            ball = 4 * math.pi * radius**2
            self.assertLess(ball - areas_of[model], 0.01 * ball)
            self.assertGreater(ball, areas_of[model])
        wide = morskin.Skin([[0, 0, 0]], [1.5], model="sas", probe=0).mesh()
        self.assertEqual(wide.certificate.area, areas_of["vdw"])
        mesh = shell.mesh(model="sas", probe=0.5, drop_voids_below=math.inf, C=0.3)
        self.assertTrue(mesh.certificate.certified)

    def test_every_size_and_way_of_meshing_can_be_asked_for(self):
        skin = morskin.Skin(*BALLS)
        self.assertAlmostEqual(len(skin.mesh(triangles=2000).faces) / 2000, 1, delta=0.1)
        lengths = skin.mesh(edge_length=0.2)
        a, b, _ = lengths.vertices[lengths.faces].transpose(1, 0, 2)
        self.assertAlmostEqual(np.median(np.linalg.norm(a - b, axis=1)), 0.2, delta=0.04)
        for options in ({"method": "static", "C": 0.2}, {"fronts": 1, "C": 0.2},
                        {"direction": np.array([0.3, 1, 0.1]), "C": 0.2},
                        {"grading": 0.2, "C": 0.2}, {"angle_goal_deg": 30, "C": 0.2},
                        {"Q": 1.7, "C": 0.1}, {"max_length_scale": 1.0, "C": 0.2}):
            self.assertTrue(skin.mesh(**options).certificate.certified, options)

    def test_a_mesh_made_with_any_size_checks_with_its_own_sizing(self):
        skin = morskin.Skin(*BALLS)
        for options in ({}, {"C": 0.2}, {"density": 30}, {"edge_length": 0.2}, {"C": 0.35}):
            mesh = skin.mesh(**options)
            found = morskin.check(mesh.vertices, mesh.faces, skin, **mesh.sizing)
            self.assertTrue(found.certified, options)
            self.assertEqual(found.area, mesh.certificate.area)

    def test_check_says_what_is_wrong_with_a_mesh(self):
        skin = morskin.Skin(*BALLS)
        mesh = skin.mesh(C=0.2)
        for vertices, faces, reason in (
                (mesh.vertices, mesh.faces[1:], "manifold: edge .* has only one triangle"),
                (mesh.vertices, mesh.faces[:, ::-1], "does not face the way the skin does"),
                (mesh.vertices * 1.01, mesh.faces, "vertex .* lies .* off the skin"),
                (mesh.vertices * math.nan, mesh.faces, "vertex 0 is not known to lie on the skin"),
                (mesh.vertices * 1e300, mesh.faces, "vertex 0 is not known to lie on the skin"),
                (mesh.vertices, mesh.faces * 0, "manifold: triangle 0 repeats a corner"),
                (np.zeros((0, 3)), np.zeros((0, 3), int), "manifold: no triangles")):
            found = morskin.check(vertices, faces, skin, C=0.2)
            self.assertFalse(found.certified)
            self.assertRegex(found.reason, reason)
        self.assertTrue(morskin.check(mesh.vertices.tolist(), mesh.faces.astype("i8"), skin,
                                      C=0.2).certified)
        other = morskin.Skin([[0, 0, 0]], [1.5])
        self.assertFalse(morskin.check(mesh.vertices, mesh.faces, other, C=0.2).certified)


class Arrays(ModuleTest):
    NAMES = ["vertices", "faces", "normals", "length_scales", "curvatures", "directions", "atoms",
             "atom_ids", "atom_weights", "components"]

    def test_arrays_are_views_that_nobody_can_write_to(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        for name in self.NAMES:
            array = getattr(mesh, name)
            self.assertFalse(array.flags.owndata, name)
            self.assertTrue(np.shares_memory(array, getattr(mesh, name)), name)
            with self.assertRaises(ValueError):
                array[:] = 0
            with self.assertRaises(ValueError):
                array.setflags(write=True)
        molecule = morskin.read(MOLECULES / "benzene.pdb")
        self.assertTrue(np.shares_memory(molecule.positions, molecule.radii) or
                        not molecule.positions.flags.owndata)

    def test_arrays_outlive_their_mesh_and_let_go_of_it(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        kept = {name: getattr(mesh, name) for name in self.NAMES}
        copies = {name: array.copy() for name, array in kept.items()}
        gone = weakref.ref(mesh)
        del mesh
        gc.collect()
        others = [morskin.Skin(*BALLS).mesh(**COARSE) for _ in range(5)]
        for name, array in kept.items():
            np.testing.assert_array_equal(array, copies[name])
        del others, kept, array
        gc.collect()
        self.assertIsNone(gone())

    def test_a_run_keeps_no_hold_on_its_progress_function(self):
        class Watched:
            pass
        watched = Watched()
        gone = weakref.ref(watched)
        calls = []

        def progress(stage, share, _kept=watched):
            calls.append(stage)
        mesh = morskin.Skin(*BALLS).mesh(progress=progress, **COARSE)
        del progress, watched
        gc.collect()
        self.assertTrue(calls)
        self.assertIsNone(gone())
        del mesh

    def test_positions_may_have_any_layout_and_any_real_type(self):
        positions = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 1]], float)
        radii = np.array([1.5, 1.0, 1.25, 1.5])
        reference = morskin.Skin(positions, radii).mesh(**COARSE).vertices
        wide = np.zeros((8, 6))
        wide[::2, ::2] = positions
        for p, r in ((positions.tolist(), radii.tolist()), (np.asfortranarray(positions), radii),
                     (positions.astype("f4"), radii.astype("f4")), (positions.astype("i2"), radii),
                     (wide[::2, ::2], np.repeat(radii, 2)[::2]), (positions.astype(">f8"), radii)):
            np.testing.assert_array_equal(morskin.Skin(p, r).mesh(**COARSE).vertices, reference)


class Files(ModuleTest):
    def test_what_is_not_certified_is_raised_with_its_mesh_and_saved_as_unverified(self):
        skin = morskin.Skin(*BALLS)
        with self.assertRaises(morskin.NotCertified) as caught:
            skin.mesh(**BAD)
        mesh = caught.exception.mesh
        self.assertEqual(str(caught.exception), mesh.certificate.reason)
        allowed = skin.mesh(allow_uncertified=True, **BAD)
        np.testing.assert_array_equal(allowed.vertices, mesh.vertices)
        path = allowed.save(self.folder / "a.ply")
        self.assertEqual(path.name, "a.ply.unverified")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["a.ply.unverified"])
        vertices, _ = morskin.read_mesh(path)
        np.testing.assert_array_equal(vertices, mesh.vertices)
        self.assertIn("not certified", repr(allowed))

    def test_an_allowed_mesh_that_is_certified_is_saved_under_its_name(self):
        mesh = morskin.Skin(*BALLS).mesh(allow_uncertified=True, **COARSE)
        self.assertEqual(mesh.save(str(self.folder / "a.stl")).name, "a.stl")

    def test_a_file_that_cannot_be_written_leaves_nothing(self):
        mesh = morskin.Skin(*BALLS).mesh(**COARSE)
        for name in ("a.xyz", "a", "no/a.ply", "no/a.vert"):
            with self.assertRaises(morskin.UnwritableOutput):
                mesh.save(self.folder / name)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()

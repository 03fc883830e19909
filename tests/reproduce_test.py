#!/usr/bin/env python3
"""What bench/reproduce.py says of runs that were out of time, and when it lets them be."""

import argparse
import contextlib
import io
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "bench"))
import ablation  # noqa: E402
import molecule_runs  # noqa: E402
import reproduce  # noqa: E402
import reproduce_part  # noqa: E402
import reproduce_tables as tables  # noqa: E402

METHODS = ["sweep", "dynamic"]
RESULTS = Path(__file__).resolve().parent.parent / "papers" / "results"


def run(molecule, method, seconds, **more):
    return {"molecule": molecule, "method": method, "triangles": 10, "min_angle_deg": 30,
            "seconds": seconds, "cpu_seconds": seconds, "peak_memory_bytes": 2**20,
            "certified": True, "reason": ""} | more


def late(molecule, method, reason="still running after 20 s", **more):
    return {"molecule": molecule, "method": method, "certified": False, "reason": reason} | more


class Tables(unittest.TestCase):
    def line(self, text, *cells):
        """The one line of a table that begins with these cells."""
        found = [li for li in text.splitlines() if li.startswith("| " + " | ".join(cells) + " |")]
        self.assertEqual(len(found), 1, text)
        return found[0]

    def test_what_was_out_of_time_is_not_measured_and_what_failed_has_no_mesh(self):
        rows = [run("5TMN", "sweep", 2), late("5TMN", "dynamic"),
                run("9DNA", "sweep", 2), late("9DNA", "dynamic", "left out: no time was left"),
                run("1GRM", "sweep", 2), late("1GRM", "dynamic", "cannot be meshed")]
        text = tables.molecules_text(rows, METHODS)
        self.assertIn("not measured", self.line(text, "5TMN", "dynamic"))
        self.assertIn("not measured", self.line(text, "9DNA", "dynamic"))
        self.assertIn("no mesh", self.line(text, "1GRM", "dynamic"))
        self.assertIn("not measured", self.line(tables.ratios_text(rows, METHODS), "5TMN", "120"))

    def test_a_run_left_out_takes_nothing_from_those_that_were_measured(self):
        rows = [run("5TMN", "sweep", 2), run("5TMN", "dynamic", 80),
                late("5TMN", "dynamic", "left out: no time was left")]
        self.assertIn("| 40.00 | 40.00 |", tables.ratios_text(rows, METHODS))

    def test_too_few_meshes_for_an_exponent_are_not_measured(self):
        rows = [run("a", "sweep", 2, series="corpus", C=0.08, triangles=20000)]
        line = self.line(tables.scaling_text(rows, METHODS), "corpus", "sweep")
        self.assertEqual(line.count("not measured"), 2)
        self.assertIn("not measured", tables.asked_text({"scaling": rows}))

    def test_a_topology_that_was_not_measured_is_not_counted_as_wrong(self):
        right = {"euler_characteristic": 2, "components": 1, "genus": 0}
        right |= {"expected_" + name: value for name, value in right.items()}
        rows = [run("a", "sweep", 2, **right), late("b", "sweep"),
                run("c", "sweep", 2, **right | {"genus": 1})]
        self.assertIn("| sweep | 3 | 2 | 1 | 1 | 1 |", tables.agreement_text(rows, METHODS))

    def test_the_ablation_names_what_was_not_measured(self):
        row = dict.fromkeys(ablation.COLUMNS, "0") | {
            "as_printed": "guard", "runs": 5, "certified": 0, "out_of_time": 2,
            "triangles_ratio": "-", "triangles_1grm": "-"}
        self.assertIn("| 0 of 5, 2 not measured |", ablation.table([row]))


class Ablation(unittest.TestCase):
    def test_its_inputs_are_those_of_the_committed_run_whatever_else_is_bundled(self):
        committed = {int(r["runs"]) for r in molecule_runs.read_rows(RESULTS / "ablation.tsv")}
        with tempfile.TemporaryDirectory() as folder:
            pairs = ablation.inputs(Path(folder))
            self.assertTrue(all(path.exists() for path, _ in pairs))
        self.assertEqual(({len(pairs)}, committed), ({111}, {111}))

    def test_a_certified_run_counts_though_another_of_it_is_out_of_time_but_not_if_one_failed(self):
        late = {"outcome": "out_of_time", "reason": "still running after 60 s"}
        failed = {"outcome": "failed", "reason": "exit 1"}
        quick, slow = ({"outcome": "certified", "cpu_seconds": s} for s in (1, 2))
        for runs, counts in (((quick, late), quick), ((quick, slow), quick), ((slow, quick), quick),
                             ((quick, failed), failed), ((late,), late)):
            with (mock.patch.object(ablation, "run", side_effect=runs),
                  mock.patch.object(ablation, "ROWS", {ablation.NONE: ([], "")}),
                  contextlib.redirect_stdout(io.StringIO())):
                reports = ablation.run_in_turns(Path("x"), "vdw", 60, 2)
            self.assertEqual(reports, {ablation.NONE: counts})

    def test_no_run_of_it_takes_longer_than_asked_nor_than_its_own_limit(self):
        for timeout, is_quick, limit in ((1800, False, 60), (20, True, 10), (5, False, 5),
                                         (5, True, 5)):
            options = argparse.Namespace(results=Path("x"), timeout=timeout, quick=is_quick,
                                         repetitions=2)
            with (mock.patch.object(ablation, "run_in_turns", side_effect=InterruptedError) as run,
                  self.assertRaises(InterruptedError)):
                reproduce.ablated(options)
            self.assertEqual(run.call_args.args[2], limit)

    def test_a_row_whose_certified_runs_are_not_those_of_the_first_row_has_no_ratios(self):
        good = {"outcome": "certified", "input": "x"}
        failed = {"outcome": "failed", "reason": "exit 1"}
        row = ablation.row("guard", [good], [failed])
        line = ablation.table([row]).splitlines()[-1]
        self.assertTrue(line.endswith("| 1 of 1 | - | - | - | - | - | - |"), line)


class Arguments(unittest.TestCase):
    def test_parts_methods_and_models_that_there_are_not_are_refused_at_once(self):
        for option in ("--parts", "--methods", "--models"):
            said = io.StringIO()
            with (self.subTest(option), contextlib.redirect_stderr(said),
                  mock.patch.object(sys, "argv", ["reproduce.py", option, "vdw,ses-like"]),
                  self.assertRaises(SystemExit) as ended):
                reproduce.arguments()
            self.assertEqual(ended.exception.code, 2)
            wrong = "ses-like" if option == "--models" else "vdw"
            self.assertIn(f"there is no '{wrong}', only ", said.getvalue())


class Files(unittest.TestCase):
    def test_rows_are_there_when_all_are_and_an_interrupted_run_leaves_the_earlier_ones(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rows.tsv"

            def write(*values, error=None):
                with molecule_runs.Rows(path, ["n"], [4], 1) as rows:
                    for n in values:
                        rows.add({"n": n})
                    if error:
                        raise error
            write(1, 2)
            with self.assertRaises(KeyboardInterrupt):
                write(3, error=KeyboardInterrupt())
            self.assertEqual(molecule_runs.read_rows(path), [{"n": "1"}, {"n": "2"}])
            with self.assertRaises(SystemExit):
                write(4, error=SystemExit("an input is missing"))
            write()
            self.assertEqual(molecule_runs.read_rows(path), [{"n": "1"}, {"n": "2"}])
            write(5)
            self.assertEqual([p.name for p in Path(folder).iterdir()], [path.name])
            self.assertEqual(molecule_runs.read_rows(path), [{"n": "5"}])


    def test_a_cut_run_leaves_the_parts_that_it_did_not_end_with_what_they_were_made_on(self):
        def mesh(path, model, timeout, *words, keep=None):
            if "-C" in words:  # the scaling
                raise KeyboardInterrupt
            report = {"triangles": 10, "certified": True, "seconds": {"total": 10.0}}
            return molecule_runs.Run(0, report, "", 10.0, 10.0)
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder)
            earlier = {part: {"date": "earlier"} for part in reproduce.PARTS}
            (made / "environment.json").write_text(json.dumps(earlier), encoding="utf-8")
            for part in ("table1", "scaling"):
                (made / f"{part}.csv").write_text("earlier", encoding="utf-8")
            words = ["reproduce.py", "--results", folder, "--repetitions", "1",
                     "--molecules", str(molecule_runs.BUNDLED)]
            with (mock.patch.object(sys, "argv", words),
                  mock.patch.object(reproduce, "methods_there_are", lambda *_: METHODS),
                  mock.patch.object(reproduce, "sized_files", lambda *_: ([], [])),
                  mock.patch.object(reproduce_part, "mesh", mesh),
                  self.assertRaises(KeyboardInterrupt)):
                reproduce.main()
            known = json.loads((made / "environment.json").read_text(encoding="utf-8"))
            self.assertEqual((made / "scaling.csv").read_text(encoding="utf-8"), "earlier")
            self.assertEqual(known["scaling"], {"date": "earlier"})
            self.assertEqual(len(tables.read_rows(made / "table1.csv")),
                             len(METHODS) * len(reproduce.TABLE1))
            self.assertNotEqual(known["table1"], {"date": "earlier"})


class Order(unittest.TestCase):
    """Table 1 with a clock that each run moves by ten seconds."""

    def table1(self, is_quick):
        clock, limits = [0.0], []

        def mesh(path, model, timeout, *words, keep=None):
            limits.append(timeout)
            clock[0] += 10
            report = {"triangles": 10, "certified": True, "seconds": {"total": 10.0}}
            return molecule_runs.Run(0, report, "", 10.0, 10.0)
        with (tempfile.TemporaryDirectory() as folder,
              mock.patch.object(reproduce_part, "mesh", mesh),
              mock.patch.object(reproduce_part.time, "monotonic", lambda: clock[0])):
            options = argparse.Namespace(quick=is_quick, results=Path(folder), timeout=20,
                                         repetitions=5)
            part = reproduce.table1(options, METHODS, reproduce_part.Notes(), Path(folder))
        return limits, part.rows

    def test_a_quick_run_measures_every_method_once_without_limit_then_as_time_allows(self):
        limits, rows = self.table1(is_quick=True)
        first = len(METHODS) * len(reproduce.TABLE1)
        self.assertEqual(limits[:first], [math.inf] * first)
        self.assertEqual({(r["molecule"], r["method"]) for r in rows[:first]},
                         {(molecule, m) for molecule in reproduce.TABLE1 for m in METHODS})
        self.assertTrue(first < len(limits) < len(rows), limits)  # time for some more, not for all
        self.assertTrue(all(limit <= 20 for limit in limits[first:]), limits)
        self.assertTrue(all(tables.is_unmeasured(r) for r in rows[len(limits):]))
        self.assertEqual(len(rows), 5 * first)

    def test_a_whole_run_leaves_nothing_out(self):
        limits, rows = self.table1(is_quick=False)
        self.assertEqual((len(limits), set(limits)), (len(rows), {20}))

    def test_of_the_scaling_only_runs_out_of_time_keep_a_method_from_larger_inputs(self):
        for code, reason, count in ((-1, "still running after 30 s", 1), (4, "singular", 2)):
            def mesh(path, *words, code=code, reason=reason, **_):
                if "static" in words and path.name == "a.pdb":
                    return molecule_runs.Run(code, {}, reason, 1.0, 1.0)
                report = {"triangles": 10, "certified": True, "seconds": {"total": 1.0}}
                return molecule_runs.Run(0, report, "", 1.0, 1.0)
            files = [(20, Path("a.pdb")), (2000, Path("b.pdb"))]
            with (tempfile.TemporaryDirectory() as folder,
                  mock.patch.object(reproduce, "sized_files", lambda *_, files=files: (files, [])),
                  mock.patch.object(reproduce_part, "mesh", mesh)):
                options = argparse.Namespace(quick=False, results=Path(folder), timeout=20, only="",
                                             repetitions=1, largest=8000, finest=1,
                                             scaling_timeout=30)
                part = reproduce.scaling(options, ["sweep", "static"], reproduce_part.Notes(),
                                         Path(folder))
            tried = [r["molecule"] for r in part.rows if r["method"] == "static"]
            self.assertEqual(tried, ["a.pdb", "b.pdb"][:count])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""Voids, necks and tunnels on the command line. Usage: voids_command_test.py path/to/morskin"""

import json

from support.command import MOLECULES, CommandTest, main

SHELL = MOLECULES / "shell_hollow.xyzr"  # one void of some 875 cubic Angstrom


class Voids(CommandTest):
    def meshed(self, *words):
        return self.mesh_json(SHELL, "-o", "mesh.ply", "-C", "0.2", *words)

    def checked(self, *words, code=0):
        return self.check("mesh.ply", "--against", SHELL, "-C", "0.2", *words, code=code)

    def broken(self, report):
        return {v["name"]: v["reason"] for v in report["verdicts"] if not v["holds"]}

    def test_a_void_is_kept_or_dropped_as_asked_and_the_report_says_which(self):
        for words, is_dropped in (((), False), (("--voids", "keep"), False),
                                  (("--voids", "drop"), True), (("--voids", "500"), False),
                                  (("--voids", "1e3"), True)):
            with self.subTest(words=words):
                report = self.meshed(*words)
                self.assertTrue(report["certified"])
                void, = report["voids"]
                self.assertEqual(void["dropped"], is_dropped)
                self.assertEqual(report["components"], 1 if is_dropped else 2)
                if not is_dropped:  # what the mesh's wall encloses
                    self.assertTrue(840 < void["volume"][0] == void["volume"][1] < 900)

    def test_the_report_gives_the_volumes_of_the_voids_that_are_kept_as_theirs_alone(self):
        crambin = MOLECULES / "1crn.pdb"
        for limit, said in (("1", r"10; 9 dropped, the other of [\d.]+ A\^3; walls of "),
                            ("0.5", r"10; 7 dropped, the others of [\d.]+ to [\d.]+ A\^3; walls"),
                            ("drop", r"10; 10 dropped\n"), ("keep", r"10 of .* A\^3; walls of ")):
            text = self.run_morskin("mesh", crambin, "-o", "mesh.ply", "-C", "0.4",
                                    "--voids", limit).stdout.decode()
            self.assertRegex(text, "  voids       " + said)

    def test_dynamic_and_marching_cubes_leave_out_the_void_that_is_dropped(self):
        report = self.meshed("--voids", "drop", "--method", "dynamic")
        self.assertTrue(report["certified"])
        self.assertEqual((report["components"], report["euler_characteristic"]), (1, 2))
        report = self.mesh_json(SHELL, "-o", "cubes.ply", "-C", "0.2", "--voids", "drop",
                                "--method", "marching-cubes", code=5)
        self.assertEqual((report["components"], report["euler_characteristic"]), (1, 2))

    def test_check_compares_with_the_components_that_are_kept(self):
        name = "every component once"
        self.meshed("--voids", "drop")
        checked = self.checked("--voids", "drop")
        self.assertIsNone(checked["drop_voids_below"])
        self.assertIn("any volume", checked["drop_voids_below_reason"])
        broken = self.broken(self.checked("--voids", "keep", code=5))
        self.assertIn("wall of the void", broken[name])
        self.meshed()
        self.assertEqual(self.checked()["drop_voids_below"], 0)
        self.assertEqual(self.checked("--voids", "9.5")["drop_voids_below"], 9.5)
        reason = self.broken(self.checked("--voids", "drop", code=5))[name]
        self.assertRegex(reason, "wall of the void at .*, which is to be dropped, is covered by")

    def test_a_vertex_off_the_skin_makes_no_component_missing(self):
        self.run_morskin("mesh", SHELL, "-o", "good.off", "-q", "-C", "0.2")
        places, triangles = self.read_off("good.off")
        first = triangles[0][0]
        places[first] = [x / 2 for x in places[first]]  # near the inner wall
        self.write_off("mesh.ply", places, triangles)
        broken = self.broken(self.checked(code=5))
        self.assertIn(f"vertex {first} lies", broken["vertices on the skin"])
        self.assertNotIn("every component once", broken)
        self.assertIn("no surface ball of triangle 0 was found", broken["restricted Delaunay"])

    def test_a_volume_that_is_none_is_refused(self):
        for wrong in ("-1", "all", "nan", "inf", ""):
            words = ("mesh", SHELL, "-o", "mesh.ply", f"--voids={wrong}")
            done = self.run_morskin(*words, code=2)
            self.assertIn(b"--voids", done.stderr)

    def test_info_lists_voids_necks_and_tunnels_before_there_is_a_mesh(self):
        info = json.loads(self.run_morskin("info", SHELL, "--json").stdout)
        low, high = info["voids"][0]["volume"]
        self.assertTrue(840 < low < 875 < high < 900)
        self.assertEqual(len(info["voids"]), 1)
        self.assertEqual(info["tunnels"]["count"], 0)
        necks = info["necks"]
        self.assertEqual(len(necks["narrowest"]), min(necks["count"], 20))
        radii = [neck["radius"] for neck in necks["narrowest"]]
        self.assertEqual(radii, sorted(radii))
        self.assertGreater(necks["forced_triangles"], necks["narrowest"][0]["forced_triangles"])

    def test_necks_on_components_that_go_with_a_void_are_left_out(self):
        nested = self.folder / "nested.xyzr"  # two balls with a narrow neck in the void
        nested.write_text(SHELL.read_text() + "-0.7 0 0 0.5\n0.7 0 0 0.5\n")

        def told(*words):
            said = self.run_morskin("info", nested, "--json", *words).stdout
            return [json.loads(said)[kind] for kind in ("necks", "tunnels")]

        (necks, tunnels), (left, tunnels_left) = told(), told("--voids", "drop")
        self.assertLess(necks["narrowest"][0]["radius"], 0.1)
        self.assertEqual(left["count"], necks["count"] - 1)
        self.assertGreater(left["narrowest"][0]["radius"], 0.1)
        # The tunnels are triangles between the pair and the shell.
        self.assertGreater(tunnels["count"], 0)
        self.assertEqual(tunnels_left["count"], 0)

    def test_info_guesses_the_triangles_of_a_length_within_a_quarter(self):
        for size in ("0.3", "0.05"):
            words = (MOLECULES / "caffeine.xyz", "--size", size)
            info = json.loads(self.run_morskin("info", *words, "--json").stdout)
            made = json.loads(self.run_morskin("mesh", *words, "-o", "m.ply", "--json").stdout)
            guess = info["estimated_triangles"] / made["triangles"]
            self.assertLess(abs(guess - 1), 0.25)

    def test_info_tells_what_it_can_of_a_singular_skin(self):
        touching = self.input("touching.xyzw", "0 0 0 1\n2 0 0 1\n")
        self.run_morskin("mesh", touching, "-o", "mesh.ply", code=4)
        info = json.loads(self.run_morskin("info", touching, "--json").stdout)
        self.assertEqual(info["atoms"], 2)
        self.assertIn("singular", info["refused"])
        self.assertNotIn("voids", info)
        self.assertNotIn("estimated_triangles", info)


if __name__ == "__main__":
    main()

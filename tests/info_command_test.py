#!/usr/bin/env python3
"""What info tells of a molecule. Usage: info_command_test.py path/to/morskin"""

import json
import math
import resource
import subprocess

from support.command import MOLECULES, CommandTest, main, morskin


class Info(CommandTest):
    def test_info_counts_the_elements(self):
        info = json.loads(self.run_morskin("info", MOLECULES / "caffeine.xyz", "--json").stdout)
        self.assertEqual(info["elements"], {"C": 8, "H": 10, "N": 4, "O": 2})
        self.assertEqual(info["atoms"], 24)
        self.assertGreater(info["estimated_triangles"], 0)
        self.assertIn(b"about", self.run_morskin("info", MOLECULES / "caffeine.xyz").stdout)

    def test_a_report_that_its_file_has_no_room_for_gives_7(self):
        with open(self.folder / "report.json", "wb") as file:
            done = subprocess.run(
                [morskin(), "info", "ring.xyzr", "--json"], cwd=self.folder, check=False,
                stdout=file, stderr=subprocess.PIPE,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        self.assertEqual(done.returncode, 7)
        self.assertIn(b"standard output: cannot write", done.stderr)

    def test_one_neck_is_not_told_of_as_several(self):
        said = self.run_morskin("info", MOLECULES / "two_balls.xyzr").stdout.decode()
        self.assertRegex(said, r"  necks       1, of radius \S+ A; it forces \d+ triangles\n")

    def test_a_neck_s_and_a_tunnel_s_radius_and_place_are_those_of_two_and_of_three_balls(self):
        pair = self.input("pair.xyzr", "1 2 3 2\n3 2 3 2\n")
        ring = "".join("{} {} 5 2\n".format(*(3 * f(2 * math.pi * k / 3) for f in (
            math.cos, math.sin))) for k in range(3))
        for file, name, radius, place in (
                (pair, "necks", math.sqrt(2**2 - 2**2 / 8), [2, 2, 3]),
                (self.input("ring3.xyzr", ring), "tunnels", math.sqrt((3**2 - 2 * 2**2) / 2),
                 [0, 0, 5])):
            found = json.loads(self.run_morskin("info", file, "--json").stdout)[name]
            self.assertEqual(found["count"], 1)
            self.assertAlmostEqual(found["narrowest"][0]["radius"], radius, places=5)
            for told, expected in zip(found["narrowest"][0]["at"], place):
                self.assertAlmostEqual(told, expected, places=9)

    def test_radii_are_those_of_the_atoms_and_patch_radii_those_of_the_model(self):
        balls = self.input("balls.xyzr", "0 0 0 1.5\n9 0 0 1\n18 0 0 2\n18 0 0 2\n")
        words = ("info", balls, "--model", "sas", "--probe", "0.5")
        told = json.loads(self.run_morskin(*words, "--json").stdout)
        self.assertEqual([told[f"{radius}_{end}"] for radius in ("radius", "patch_radius")
                          for end in ("min", "max")], [1, 2, 1.5, 2.5])
        self.assertEqual((told["duplicates"], told["hidden"]), (1, 1))
        said = self.run_morskin(*words).stdout.decode()
        self.assertIn("radii       1 to 2 A, as in the file\n", said)
        self.assertIn("patches     1.5 to 2.5 A, model sas, probe 0.5 A\n", said)

    def test_waters_are_kept_when_asked(self):
        words = (MOLECULES / "9dna.pdb", "--json")
        dry = json.loads(self.run_morskin("info", *words).stdout)
        wet = json.loads(self.run_morskin("info", *words, "--waters").stdout)
        self.assertEqual(wet["atoms"], dry["atoms"] + dry["skipped_waters"])
        self.assertGreater(dry["skipped_waters"], 0)

    def test_a_ball_is_hidden_if_it_has_no_power_cell_not_if_it_only_has_no_patch(self):
        # The second ball has a cell, but its sphere does not go there; the third has none.
        balls = self.input("balls.xyzr", "0 0 0 2\n0.1 0 0 1\n0 0 0 1\n")
        self.assertIn("hidden      1 (no power cell, duplicates included)",
                      self.run_morskin("info", balls).stdout.decode())
        self.run_morskin("mesh", balls, "-o", "m.ply", "-q", "-C", "0.3", "--areas", "a.csv")
        rows = (self.folder / "a.csv").read_text().splitlines()
        self.assertEqual([row.split(",")[-1] for row in rows[2:4]], ["0", "0"])

    def test_triangles_are_told_within_a_quarter_with_every_model_also_of_cages(self):
        for name in ("1grm_model1.pdb", "9dna.pdb", "c60.xyz", "shell_hollow.xyzr"):
            for model in ("paper", "sas", "vdw", "ses-like"):
                with self.subTest(name, model=model):
                    words = (MOLECULES / name, "--model", model, "-C", "0.2")
                    told = json.loads(self.run_morskin("info", *words, "--json").stdout)
                    made = self.mesh_json(*words, "-o", "m.ply")["triangles"]
                    self.assertLess(abs(told["estimated_triangles"] / made - 1), 0.25)

    def test_the_memory_told_is_no_fifth_below_what_a_run_takes(self):
        for name in ("two_balls.xyzr", "benzene.pdb", "5tmn_ligand.pdb"):
            for C in ("0.08", "0.4"):
                with self.subTest(name, C=C):
                    words = (MOLECULES / name, "-C", C)
                    told = json.loads(self.run_morskin("info", *words, "--json").stdout)
                    taken = self.mesh_json(*words, "-o", "m.ply")["peak_memory_bytes"]
                    self.assertGreater(told["estimated_bytes"], 0.8 * taken)

    def test_of_a_mesh_named_without_its_option_the_error_tells_how_it_is_written(self):
        for command in ((), ("info",)):
            done = self.run_morskin(*command, self.ring, "a.ply", code=2)
            self.assertIn(b"expected: a.ply; to write it: morskin mesh INPUT -o a.ply", done.stderr)
        done = self.run_morskin("info", self.ring, "--a.ply", code=2)
        self.assertNotIn(b"to write it", done.stderr)


if __name__ == "__main__":
    main()

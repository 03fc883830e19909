#!/usr/bin/env python3
"""The balls that the command makes of atoms, and takes as they are given.
Usage: balls_command_test.py path/to/morskin"""

import json

from support.command import MOLECULES, CommandTest, main


class Balls(CommandTest):
    def test_the_balls_are_those_of_the_model(self):
        self.input("ball.xyzr", "1 2 3 1.5\n")
        for model, radius in (("vdw", 1.5), ("sas", 2.9), ("paper", (2 ** 0.5 * 2.9 / 2) ** 0.5)):
            self.run_morskin("balls", "ball.xyzr", "-o", "out.xyzr", "--model", model)
            numbers = [float(w) for w in (self.folder / "out.xyzr").read_text().split()]
            self.assertEqual(numbers[:3], [1, 2, 3])
            self.assertAlmostEqual(numbers[3], radius)

    def test_the_weights_written_give_the_very_same_mesh(self):
        self.run_morskin("balls", "--weights", MOLECULES / "caffeine.xyz", "-o", "out.xyzw")
        self.run_morskin("mesh", MOLECULES / "caffeine.xyz", "-o", "a.ply")
        mesh = self.without_origin("a.ply")
        report = self.mesh_json("out.xyzw", "-o", "b.ply")
        self.assertEqual(self.without_origin("b.ply"), mesh)
        self.assertEqual(report["model"], "given")
        self.run_morskin("mesh", "-", "-o", "c.ply", "--model", "given",
                         input=(self.folder / "out.xyzw").read_bytes())
        self.assertEqual(self.without_origin("c.ply"), mesh)
        self.run_morskin("balls", "--weights", "out.xyzw", "-o", "again.xyzw")
        self.assertEqual((self.folder / "again.xyzw").read_bytes(),
                         (self.folder / "out.xyzw").read_bytes())
        people = self.run_morskin("mesh", "out.xyzw", "-o", "b.ply")
        self.assertIn(b"weights as given", people.stdout)

    def test_the_model_and_the_fourth_column_must_agree(self):
        weights = b"# x y z w\n0 0 0 2\n"
        self.input("ball.xyzw", weights.decode())
        self.input("ball.xyzr", "0 0 0 1\n")
        for words in (("ball.xyzw", "--model", "vdw"), ("ball.xyzw", "--probe", "1"),
                      ("ball.xyzr", "--model", "given"), ("-",)):
            self.run_morskin("info", *words, input=weights, code=2)
        for numbers in (weights, weights.splitlines()[1]):
            done = self.run_morskin("info", "-", "--model", "given", input=numbers)
            self.assertIn(b"model given", done.stdout)
            self.assertIn(b"by the weights in the file", done.stdout)
        self.run_morskin("balls", "ball.xyzr", "-o", "out.xyzw", code=2)
        self.run_morskin("balls", "--weights", "ball.xyzr", "-o", "out.xyzr", code=2)

    def test_balls_get_no_ending_of_another_format(self):
        for name in ("out.pdb", "out.xyz", "out.cif.gz", "out.xyzr.gz", "out.PLY", "out.gz",
                     "out.npz"):
            said = self.run_morskin("balls", self.ring, "-o", name, code=2).stderr
            self.assertIn(b"written as .xyzr", said)
        self.run_morskin("balls", self.ring, "-o", "out.txt")
        self.assertEqual(self.names(), ["out.txt"])

    def test_noise_in_the_place_of_zero_is_rounded_and_told(self):
        self.input("noise.xyzr", "1e-25 0 0 1\n1 -3e-300 0 1\n")
        self.input("zero.xyzr", "0 0 0 1\n1 0 0 1\n")
        done = self.run_morskin("mesh", "noise.xyzr", "-o", "noise.ply", "--json")
        self.assertEqual(json.loads(done.stdout)["coordinates_rounded"], 2)
        self.assertIn(b"rounded to multiples of 2^-120: 2, the first of ball (line 1)", done.stderr)
        self.assertEqual(self.mesh_json("zero.xyzr", "-o", "zero.ply")["coordinates_rounded"], 0)
        for name, count in (("noise.xyzr", 2), ("zero.xyzr", 0)):
            told = json.loads(self.run_morskin("info", name, "--json").stdout)
            self.assertEqual(told["coordinates_rounded"], count)

    def test_rounding_is_told_once_and_not_to_who_asks_for_quiet(self):
        self.input("noise.xyzr", "1e-25 0 0 1\n1 0 0 1\n")
        self.run_morskin("mesh", self.ring, "-o", "ring.off", "-q")
        # Of another genus: the models are tried in turn.
        done = self.run_morskin("check", "ring.off", "--against", "noise.xyzr", code=5)
        self.assertEqual(done.stderr.count(b"rounded"), 1)
        for words in (("mesh", "-o", "a.ply"), ("balls", "-o", "a.xyzr"), ("morse", "-o", "a.json"),
                      ("view", "-o", "a.html"), ("features", "-o", "a.npz")):
            done = self.run_morskin(words[0], "noise.xyzr", *words[1:], "-q")
            self.assertEqual(done.stderr, b"")


if __name__ == "__main__":
    main()

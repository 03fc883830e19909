#!/usr/bin/env python3
"""What info tells of a molecule. Usage: info_command_test.py path/to/morskin"""

import json

from support.command import MOLECULES, CommandTest, main


class Info(CommandTest):
    def test_info_counts_the_elements(self):
        info = json.loads(self.run_morskin("info", MOLECULES / "caffeine.xyz", "--json").stdout)
        self.assertEqual(info["elements"], {"C": 8, "H": 10, "N": 4, "O": 2})
        self.assertEqual(info["atoms"], 24)
        self.assertGreater(info["estimated_triangles"], 0)
        self.assertIn(b"about", self.run_morskin("info", MOLECULES / "caffeine.xyz").stdout)

    def test_waters_are_kept_when_asked(self):
        words = (MOLECULES / "9dna.pdb", "--json")
        dry = json.loads(self.run_morskin("info", *words).stdout)
        wet = json.loads(self.run_morskin("info", *words, "--waters").stdout)
        self.assertEqual(wet["atoms"], dry["atoms"] + dry["skipped_waters"])
        self.assertGreater(dry["skipped_waters"], 0)

    def test_the_memory_told_is_no_fifth_below_what_a_run_takes(self):
        for name in ("two_balls.xyzr", "benzene.pdb", "5tmn_ligand.pdb"):
            for C in ("0.08", "0.4"):
                with self.subTest(name, C=C):
                    words = (MOLECULES / name, "-C", C)
                    told = json.loads(self.run_morskin("info", *words, "--json").stdout)
                    taken = self.mesh_json(*words, "-o", "m.ply")["peak_memory_bytes"]
                    self.assertGreater(told["estimated_bytes"], 0.8 * taken)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""The sweep in the pages of `morskin view`: births, operations, seams, with a size goal too.

Usage: view_sweep_test.py path/to/morskin
"""

import json
from collections import Counter

from support.command import MOLECULES, main
from support.viewer_case import ViewTest

OPERATIONS = ["creation", "creep", "wing", "bridge", "seal"]


class Sweeps(ViewTest):
    def test_the_sweep_of_the_page_is_the_sweep_of_the_run(self):
        page = self.view(MOLECULES / "caffeine.xyz")
        report = json.loads(self.run_morskin("mesh", MOLECULES / "caffeine.xyz", "-o", "c.ply",
                                             "--fronts", "1", "--json").stdout)
        done = {name: sum(page.array(f"sweep.done.{kind}"))
                for kind, name in enumerate(OPERATIONS)}
        self.assertEqual(done, {name: report["operations"][name] for name in OPERATIONS})
        _, corners, parents = page.mesh()
        birth = page.by_triangle("mesh.birth", parents)
        self.assertEqual(len(birth), len(corners))
        self.assertGreaterEqual(min(birth), 0)
        self.assertLess(max(birth), page.about["sweep"]["steps"])
        # Six triangles to a bowl; refinement may have turned or broken a few.
        bowls = Counter(page.array("mesh.operation"))[0]
        self.assertAlmostEqual(bowls / (6 * done["creation"]), 1, delta=0.25)

    def test_the_mesh_grows_from_bowls_and_stays_a_surface_with_a_front(self):
        """At every step each edge has one triangle or two, and few edges have one."""
        page = self.view(self.ring)
        _, corners, parents = page.mesh()
        birth = page.by_triangle("mesh.birth", parents)
        triangles = len(corners)
        for share in (0.1, 0.3, 0.5, 0.7, 0.9):
            step = share * page.about["sweep"]["steps"]
            there = [t for t, b in zip(corners, birth) if b < step]
            self.assertAlmostEqual(len(there) / triangles, share, delta=0.1)
            edges = Counter(frozenset((t[k], t[k - 1])) for t in there for k in range(3))
            self.assertLessEqual(max(edges.values()), 2)
            border = sum(1 for n in edges.values() if n == 1)
            self.assertGreater(border, 0)
            self.assertLess(border, 12 * triangles ** 0.5)

    def test_two_fronts_meet_on_a_seam_and_one_alone_meets_nothing(self):
        """Two balls side by side have a bowl each; one above the other have one."""
        balls = MOLECULES / "two_balls.xyzr"
        met = {}
        for direction in ("1,0.02,0.01", "0.02,1,0.01"):
            page = self.view(balls, "--function", f"height:{direction}")
            bowls = sum(page.array("sweep.done.0"))
            seams = Counter(page.array("mesh.seam"))
            self.assertEqual(sum(seams.values()), page.about["mesh"]["triangles"])
            met[bowls] = seams
        self.assertEqual(set(met), {1, 2})
        self.assertEqual(met[1][1], 0)
        self.assertGreater(met[2][1], 0)
        # A strip between two sides, not a region.
        self.assertLess(met[2][1], 0.05 * sum(met[2].values()))

    def test_no_two_fronts_meet_on_a_ball_and_two_must_on_a_ring(self):
        ball = self.folder / "ball.xyzr"
        ball.write_text("0 0 0 1.5\n")
        self.assertEqual(set(self.view(ball).array("mesh.seam")), {0})
        self.assertEqual(set(self.view(self.ring).array("mesh.seam")), {0, 1})

    def test_a_page_of_a_size_goal_shows_the_sweep_that_met_it_and_no_other(self):
        """The first trials miss the first three goals, so the mesh is made two to four times."""
        for goal in (("--triangles", "3000"), ("--density", "12"), ("--density", "1"),
                     ("--size", "0.4")):
            with self.subTest(goal=goal):
                page = self.view(MOLECULES / "caffeine.xyz", *goal)
                done = self.run_morskin("mesh", MOLECULES / "caffeine.xyz", *goal, "-o", "c.ply",
                                        "--fronts", "1", "--json")
                report = json.loads(done.stdout)
                self.assertEqual(page.about["mesh"]["triangles"], report["triangles"])
                self.assertEqual([sum(page.array(f"sweep.done.{k}")) for k in range(5)],
                                 [report["operations"][name] for name in OPERATIONS])
                self.assertEqual(page.about["C"], report["C"])
                _, _, parents = page.mesh()
                birth = page.by_triangle("mesh.birth", parents)
                self.assertLess(max(birth), page.about["sweep"]["steps"])
                self.assertIs(page.about["certified"], True)


if __name__ == "__main__":
    main()

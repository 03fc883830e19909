#!/usr/bin/env python3
"""Critical points and Morse-Smale complexes. Usage: morse_test.py folder-of-the-package"""

from support import MOLECULES, ModuleTest, main

import morskin
import numpy as np

CHARACTERISTICS = {"two_balls.xyzr": 2, "ring12.xyzr": 0, "shell_hollow.xyzr": 4}


class Morse(ModuleTest):
    def test_minima_less_saddles_plus_maxima_are_the_euler_characteristic(self):
        for name, characteristic in CHARACTERISTICS.items():
            skin = morskin.read(MOLECULES / name).skin()
            for direction in (None, [0.3, 0.9, 0.2], np.array([-1, 0.4, 0.05])):
                points = skin.critical_points(direction)
                minima, saddles, maxima = np.bincount(points.indices, minlength=3)
                self.assertEqual(minima - saddles + maxima, characteristic)
                self.assertEqual(len(points), minima + saddles + maxima)

    def test_values_are_heights_along_the_direction_at_points_of_the_skin(self):
        skin = morskin.read(MOLECULES / "caffeine.xyz").skin()
        direction = np.array([1, -2, 0.5])
        points = skin.critical_points(direction)
        np.testing.assert_allclose(points.values,
                                   points.positions @ direction / np.linalg.norm(direction))
        mesh = skin.mesh(C=0.1)
        heights = mesh.vertices @ direction / np.linalg.norm(direction)
        self.assertAlmostEqual(points.values.max(), heights.max(), delta=0.05)
        self.assertAlmostEqual(points.values.min(), heights.min(), delta=0.05)

    def test_arcs_lead_from_saddles_to_extrema_and_rise_or_fall_all_the_way(self):
        for name in CHARACTERISTICS:
            skin = morskin.read(MOLECULES / name).skin()
            direction = np.array([0.3, 0.9, 0.2])
            found = skin.morse_smale(direction)
            points = found.points
            saddles = (points.indices == 1).sum()
            self.assertEqual(found.arcs.shape, (4 * saddles, 2))
            self.assertEqual(found.regions.shape, (2 * saddles, 4))
            self.assertEqual(found.arc_offsets.tolist()[::len(found.arcs)],
                             [0, len(found.arc_points)])
            for i, (saddle, extremum) in enumerate(found.arcs):
                line = found.arc_points[found.arc_offsets[i]:found.arc_offsets[i + 1]]
                np.testing.assert_array_equal(line[0], points.positions[saddle])
                np.testing.assert_array_equal(line[-1], points.positions[extremum])
                rise = np.diff(line @ direction) * (points.indices[extremum] - 1)
                self.assertGreaterEqual(rise.min(), -1e-9)
            np.testing.assert_array_equal(points.indices[found.regions],
                                          [[0, 1, 2, 1]] * len(found.regions))

    def test_a_simplified_complex_has_the_characteristic_and_lines_from_point_to_point(self):
        skin = morskin.read(MOLECULES / "1crn.pdb").skin("paper")
        raw, simple = skin.morse_smale(), skin.morse_smale(simplify=True)
        self.assertLess(len(simple.points), len(raw.points))
        for found in (raw, simple):
            minima, saddles, maxima = np.bincount(found.points.indices, minlength=3)
            self.assertEqual(minima - saddles + maxima, 2 * (skin.components - skin.genus))
            self.assertEqual(found.arcs.shape, (4 * saddles, 2))
            self.assertEqual(found.regions.shape, (2 * saddles, 4))
            np.testing.assert_array_equal(found.points.indices[found.arcs[:, 0]], 1)
            np.testing.assert_array_equal(found.points.indices[found.arcs[:, 1]] % 2, 0)
            np.testing.assert_array_equal(found.points.indices[found.regions],
                                          [[0, 1, 2, 1]] * len(found.regions))
            ends = found.arc_offsets[1:] - 1
            np.testing.assert_array_equal(found.arc_points[found.arc_offsets[:-1]],
                                          found.points.positions[found.arcs[:, 0]])
            np.testing.assert_array_equal(found.arc_points[ends],
                                          found.points.positions[found.arcs[:, 1]])
        kept = {tuple(p) for p in raw.points.positions}
        self.assertTrue(all(tuple(p) in kept for p in simple.points.positions))

    def test_a_ball_has_two_critical_points_and_no_arcs(self):
        skin = morskin.Skin([[1, 2, 3]], [2])
        np.testing.assert_allclose(skin.critical_points([0, 0, 1]).values, [1, 5])
        found = skin.morse_smale([0, 0, 1])
        self.assertEqual(len(found.points), 2)
        self.assertEqual(found.arcs.shape, (0, 2))
        self.assertEqual(found.arc_offsets.tolist(), [0])
        self.assertEqual(found.arc_points.shape, (0, 3))
        self.assertEqual(found.regions.shape, (0, 4))

    def test_a_degenerate_direction_is_refused(self):
        # The middle of a side of a cube lies where cells meet.
        skin = morskin.read(MOLECULES / "cube8.xyzr").skin()
        for call in (skin.critical_points, skin.morse_smale):
            with self.assertRaises(morskin.RefusedInput):
                call([1, 0, 0])

    def test_arrays_outlive_their_complex(self):
        skin = morskin.read(MOLECULES / "ring12.xyzr").skin()
        lines = skin.morse_smale().arc_points
        positions = skin.morse_smale().points.positions
        again = skin.morse_smale()
        np.testing.assert_array_equal(lines, again.arc_points)
        np.testing.assert_array_equal(positions, again.points.positions)
        with self.assertRaises(ValueError):
            lines[:] = 0

    def test_points_and_complexes_say_how_much_they_hold(self):
        skin = morskin.read(MOLECULES / "ring12.xyzr").skin()
        self.assertRegex(repr(skin.critical_points()),
                         r"^<morskin\.CriticalPoints: minima \d+, saddles \d+, maxima \d+>$")
        found = skin.morse_smale([0.3, 0.9, 0.2])
        minima, saddles, maxima = np.bincount(found.points.indices, minlength=3)
        self.assertEqual(repr(found),
                         f"<morskin.MorseSmaleComplex: minima {minima}, saddles {saddles}, maxima "
                         f"{maxima}, arcs {len(found.arcs)}, regions {len(found.regions)}>")

    def test_what_the_progress_function_raises_ends_the_tracing(self):
        class Enough(Exception):
            pass

        def progress(stage, share):
            raise Enough
        with self.assertRaises(Enough):
            morskin.read(MOLECULES / "1crn.pdb").skin().morse_smale(progress=progress)


if __name__ == "__main__":
    main()

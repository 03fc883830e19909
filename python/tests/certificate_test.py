#!/usr/bin/env python3
"""The numbers of certificates, computed here from the arrays. Usage: certificate_test.py
folder-of-the-package"""

from support import BALLS, MOLECULES, ModuleTest, main

import morskin
import numpy as np


class Certificates(ModuleTest):
    def test_angles_are_those_of_the_triangles(self):
        mesh = morskin.Skin(*BALLS).mesh(C=0.2)
        corners = mesh.vertices[mesh.faces]
        ahead, behind = (np.roll(corners, step, axis=1) - corners for step in (-1, 1))
        lengths = np.linalg.norm(ahead, axis=2) * np.linalg.norm(behind, axis=2)
        angles = np.degrees(np.arccos((ahead * behind).sum(axis=2) / lengths))
        self.assertAlmostEqual(mesh.certificate.min_angle_deg, angles.min(), places=9)
        self.assertAlmostEqual(mesh.certificate.max_angle_deg, angles.max(), places=9)

    def test_size_violations_are_the_edges_that_break_L_and_the_triangles_that_break_U(self):
        skin = morskin.Skin(*BALLS)
        mesh = skin.mesh(C=0.2)
        a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
        sides = np.linalg.norm([b - a, c - b, a - c], axis=2)
        radii = sides.prod(axis=0) / (2 * np.linalg.norm(np.cross(b - a, c - a), axis=1))
        scales = mesh.length_scales[mesh.faces].T
        of_edges = np.maximum(scales, np.roll(scales, -1, axis=0))
        for C, Q in ((0.2, mesh.sizing["Q"]), (0.1, 1.3), (0.35, 1.5)):
            with self.subTest(C=C, Q=Q):
                L = np.count_nonzero(sides / 2 <= C / Q * of_edges) // 2  # each in two triangles
                U = np.count_nonzero(radii >= C * Q * scales.min(axis=0))
                self.assertEqual((L > 0, U > 0), (C > 0.2, C < 0.2))
                found = morskin.check(mesh.vertices, mesh.faces, skin, C=C, Q=Q)
                self.assertEqual(found.size_violations, L + U)
                # [L] is there for the angles, which are known.
                self.assertEqual((found.is_homeomorphic, found.certified), (True, U == 0))

    def test_the_distance_to_the_skin_is_that_of_the_farthest_vertex(self):
        ball = morskin.Skin([[1, 2, 3]], [2.0])
        mesh = ball.mesh(C=0.2)
        self.assertLess(mesh.certificate.max_distance_to_skin, 1e-12)
        vertices = mesh.vertices.copy()
        vertices[5] += 0.001 * mesh.normals[5]
        found = morskin.check(vertices, mesh.faces, ball, C=0.2)
        self.assertAlmostEqual(found.max_distance_to_skin, 0.001, places=8)

    def test_a_ring_has_a_tunnel_and_two_balls_apart_have_none(self):
        ring = morskin.read(MOLECULES / "ring12.xyzr").skin()
        apart = morskin.Skin([[0, 0, 0], [9, 0, 0]], [1, 2])
        for skin, expected in ((ring, (1, 1)), (apart, (2, 0))):
            mesh = skin.mesh(C=0.3)
            self.assertEqual((skin.components, skin.genus), expected)
            self.assertEqual((mesh.certificate.components, mesh.certificate.genus), expected)
            self.assertEqual(mesh.fallbacks, [])


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""render and figure from outside. Usage: picture_command_test.py path/to/morskin"""

import struct

from support.command import MOLECULES, CommandTest, main


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n", png[:20]
    return struct.unpack(">II", png[16:24])


class PictureCommand(CommandTest):
    def picture(self, *words):
        self.run_morskin(*words, "-o", "x.png")
        return (self.folder / "x.png").read_bytes()

    def mesh(self, *words, name="ring.ply"):
        self.run_morskin("mesh", MOLECULES / "ring12.xyzr", "-o", name, "-q", *words)
        return name

    def test_every_format_that_the_mesh_reader_reads_is_drawn_alike(self):
        self.run_morskin("mesh", MOLECULES / "two_balls.xyzr", "-q", *(
            word for end in ("ply", "off", "obj", "stl") for word in ("-o", "x." + end)))
        first = self.picture("render", "x.ply", "--size", "90")
        self.assertEqual(size_of(first), (90, 90))
        for end in ("off", "obj"):
            self.assertEqual(self.picture("render", "x." + end, "--size", "90"), first)
        self.assertEqual(size_of(self.picture("render", "x.stl", "--size", "90")), (90, 90))

    def test_the_same_mesh_gives_the_same_bytes(self):
        mesh = self.mesh()
        words = ("render", mesh, "--size", "120x80", "--view", "1,2,3")
        first = self.picture(*words)
        self.assertEqual(self.picture(*words), first)
        for factor in (2.0**-1070, 2.0**1022):  # a direction may have any length
            view = ",".join(repr(factor * x) for x in (1, 2, 3))
            self.assertEqual(self.picture(*words[:-1], view), first)

    def test_several_meshes_get_a_panel_each_and_an_inset_one_more(self):
        mesh = self.mesh()
        width, height = size_of(self.picture("render", mesh, mesh, mesh, mesh, "--size", "60"))
        self.assertEqual((width, height), (3 * 60 + 2 * 16, 2 * 60 + 16))
        words = ("render", mesh, "--size", "60x40", "--inset", "0.5,0.2,8")
        self.assertEqual(size_of(self.picture(*words)), (2 * 60 + 16, 40))

    def test_a_legend_stands_below_what_is_coloured(self):
        mesh = self.mesh()
        size = ("--size", "300")
        self.assertEqual(size_of(self.picture("render", mesh, *size)), (300, 300))
        for by in ("angle", "component"):
            width, height = size_of(self.picture("render", mesh, *size, "--by", by))
            self.assertEqual(width, 300)
            self.assertGreater(height, 320)
        (self.folder / "open.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assertGreater(size_of(self.picture("render", "open.off", *size))[1], 320)

    def test_the_legend_of_a_mesh_that_is_inside_out_tells_of_its_inner_side(self):
        heights = []
        outward, inward = "021013123032", "012031132023"
        for corners in (outward, inward):
            faces = "".join("3 {} {} {}\n".format(*corners[i:i + 3]) for i in range(0, 12, 3))
            (self.folder / "corner.off").write_text(
                "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces)
            heights.append(size_of(self.picture("render", "corner.off", "--size", "300"))[1])
        self.assertEqual(heights[0], 300)
        self.assertGreater(heights[1], 320)

    def test_options_change_the_picture(self):
        mesh = self.mesh()
        base = ("render", mesh, "--size", "80")
        seen = {self.picture(*base)}
        for words in (("--colour", "#cc2200"), ("--by", "angle"), ("--flat",), ("--zoom", "2"),
                      ("--edges", "always"), ("--view", "1,0,1"), ("--up", "1,0,0"),
                      ("--at", "1,1,0"), ("--no-shadows",), ("--by", "component")):
            picture = self.picture(*base, *words)
            self.assertNotIn(picture, seen, words)
            seen.add(picture)

    def test_a_picture_goes_to_standard_output(self):
        mesh = self.mesh()
        out = self.run_morskin("render", mesh, "--size", "50", "-o", "-").stdout
        self.assertEqual(size_of(out), (50, 50))

    def test_wrong_arguments_are_told(self):
        mesh = self.mesh()
        for words in (("--size", "0"), ("--size", "9x"), ("--size", "100000x100000"),
                      ("--view", "0,0,0"), ("--view", "1,2"), ("--up", "1,x,0"), ("--zoom", "0"),
                      ("--colour", "red"), ("--by", "mood"), ("--inset", "0.5,0.5"),
                      ("--inset", "0.5,0.5,-1"), ("--inset", "0.5,1.5,2"),
                      ("--inset", "-0.1,0.5,2"), ("--columns", "0"), ("--zoom", "nan"),
                      ("--zoom", "1e-300"), ("--at", "1e300,0,0")):
            said = self.run_morskin("render", mesh, "-o", "x.png", *words, code=2).stderr
            self.assertIn(words[0].encode(), said)
        self.assertIn(b"x.jpg", self.run_morskin("render", mesh, "-o", "x.jpg", code=2).stderr)
        self.run_morskin("render", mesh, "-o", "x.png", "--size", "2000000x1", code=2)
        self.run_morskin("figure", "12", "-o", "x.png", code=2)
        self.run_morskin("figure", "9", "-o", "x.png", "--scale", "9", code=2)
        (self.folder / "link.png").symlink_to(self.folder / mesh)
        self.run_morskin("render", mesh, "-o", "link.png", code=2)  # it would replace the mesh
        self.run_morskin("render", "missing.ply", "-o", "x.png", code=3)
        self.run_morskin("render", mesh, "-o", "missing/x.png", code=7)
        self.assertFalse((self.folder / "x.png").exists())

    def test_meshes_without_triangles_are_refused_but_not_beside_others(self):
        (self.folder / "empty.off").write_text("OFF\n0 0 0\n")
        (self.folder / "point.off").write_text("OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n")
        done = self.run_morskin("render", "empty.off", "-o", "x.png", code=4)
        self.assertIn(b"empty.off: has no triangles to draw", done.stderr)
        self.assertFalse((self.folder / "x.png").exists())
        self.assertEqual(size_of(self.picture("render", "point.off", "--size", "30")), (30, 30))
        both = self.picture("render", "empty.off", "point.off", "--size", "30")
        self.assertEqual(size_of(both), (76, 30))

    def test_coordinates_near_the_ends_of_the_doubles_are_refused(self):
        for size in ("1e300", "1e-300"):
            (self.folder / "far.off").write_text(
                f"OFF\n3 1 0\n0 0 0\n{size} 0 0\n0 {size} 0\n3 0 1 2\n")
            self.run_morskin("render", "far.off", "-o", "x.png", "--size", "30", code=4)

    def test_a_picture_too_large_for_a_limit_is_advised_to_be_smaller(self):
        done = self.run_morskin("render", self.mesh(), "-o", "x.png", "--size", "3000",
                                "--timeout", "0.05", code=6)
        self.assertIn(b"draw a smaller picture or a coarser mesh", done.stderr)

    def test_a_figure_needs_no_file(self):
        self.assertEqual(size_of(self.picture("figure", "6", "--scale", "0.25")),
                         size_of(self.picture("figure", "7", "--scale", "0.25")))


if __name__ == "__main__":
    main()

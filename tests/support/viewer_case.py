"""What the tests of `morskin view` share: pages made by it, and meshes to compare them with."""

from collections import Counter

from support.command import CommandTest
from support.viewer_page import Page, from_smallest


class ViewTest(CommandTest):
    def view(self, *words, code=0):
        self.run_morskin("view", *words, "-o", "page.html", "-q", code=code)
        return Page(self.folder / "page.html")

    def check_same_mesh(self, page, places, triangles, name="mesh"):
        """The page's triangles are these, each corner within half a step of its place."""
        grid = page.about[name]["grid"]
        found, corners, _ = page.mesh(name)

        def on_grid(place):
            return tuple((x - o) / grid["step"] for x, o in zip(place, grid["origin"]))

        def rounded(place):  # half steps are decided by the command alone; none falls on one
            return tuple(round(x) for x in on_grid(place))

        expected = Counter(from_smallest(tuple(rounded(places[v]) for v in t)) for t in triangles)
        shown = Counter(from_smallest(tuple(tuple(found[v]) for v in t)) for t in corners)
        self.assertEqual(shown, expected)
        used = {v for t in triangles for v in t}
        self.assertEqual(len(found), len(used))

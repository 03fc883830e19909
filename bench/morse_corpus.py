#!/usr/bin/env python3
"""Traces Morse-Smale complexes of molecules and checks their laws from the JSON, one line a run.

For every molecule and model: the default function, some random heights and, for small molecules,
some random squared distances; each raw and simplified (`morskin morse`). The laws:

  - minima - saddles + maxima is the Euler characteristic; the default height's is everyone's, and
    so is the number of components
  - a saddle has two arcs to minima and two to maxima; a region is a minimum, a saddle, a maximum, a
    saddle, neighbours joined by arcs; there are two regions for each saddle, and each arc borders
    two
  - a line starts at its saddle and ends at its extremum; raw ones rise or fall throughout
  - the hierarchy is that of sublevel and superlevel sets, found here anew; all that it leaves is
    one minimum and one maximum for each component and two saddles for each handle
  - simplified, the cancelled pairs belong to the hierarchy, and no two protecting spheres overlap

A function that is degenerate for a molecule (exit code 2) and a singular skin (4) are no failures,
but counted. The lines also go to results/morse_corpus.tsv, each at once.
"""

import collections
import concurrent.futures
import math
import random

from molecule_runs import Rows, argument_parser, end, molecule_folder, run_command, sized_files

COLUMNS = ["file", "model", "function", "atoms", "minima", "saddles", "maxima", "chi", "components",
           "cancelled", "overlaps", "shrunk", "seconds", "verdict"]
WIDTHS = [26, 6, 30, 7, 7, 8, 7, 6, 10, 9, 8, 7, 8, 0]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="results/morse_corpus.tsv", largest=2000)
    parser.add_argument("--directions", type=int, default=3, metavar="N",
                        help="random heights a molecule, beside the default (%(default)s)")
    parser.add_argument("--distances", type=int, default=2, metavar="M",
                        help="squared distances a small molecule (%(default)s)")
    parser.add_argument("--max-distance-atoms", type=int, default=500, metavar="N",
                        help="no squared distances for more atoms (%(default)s)")
    parser.add_argument("--seed", type=int, default=1,
                        help="of directions and points (%(default)s)")
    parser.add_argument("--jobs", type=int, choices=[1, 2], default=1, help="runs at a time")
    return parser.parse_args()


def functions(path, atoms, options):
    """None for the default, then the words after --function; the same for the same file's name."""
    stream = random.Random(f"{options.seed} {path.name}")

    def triple(scale):
        return ",".join(f"{stream.gauss(0, 1) * scale:.6f}" for _ in range(3))

    result = [None] + ["height:" + triple(1) for _ in range(options.directions)]
    if atoms <= options.max_distance_atoms:
        result += ["distance:" + triple(10) for _ in range(options.distances)]
    return result


def value_of(function, point):
    if function["kind"] == "height":
        return sum(a * b for a, b in zip(function["direction"], point))
    return sum((a - b) ** 2 for a, b in zip(function["origin"], point))


class Laws:
    """Collects the first few broken laws of one complex."""

    def __init__(self, complex_):
        self.complex = complex_
        self.points = complex_["critical_points"]
        self.broken = []

    def expect(self, condition, what):
        if not condition and len(self.broken) < 3:
            self.broken.append(what)

    def index(self, i):
        return self.points[i]["index"]

    def alive(self):
        return [p for p in self.points if p["survives"]]

    def check_counts(self):
        number = collections.Counter(p["index"] for p in self.alive())
        chi = number[0] - number[1] + number[2]
        self.expect(chi == self.complex["euler_characteristic"], "Euler characteristic")
        everything = collections.Counter(p["index"] for p in self.points)
        self.expect(everything[0] - everything[1] + everything[2] == chi, "chi changed")
        self.expect(len(self.complex["regions"]) == 2 * number[1], "two regions a saddle")
        self.expect([p["id"] for p in self.points] == list(range(len(self.points))), "ids")

    def check_arcs_and_regions(self):
        ends = collections.defaultdict(list)
        arcs = collections.Counter()
        for arc in self.complex["arcs"]:
            saddle, extremum = arc["saddle"], arc["extremum"]
            ends[saddle].append(self.index(extremum))
            arcs[saddle, extremum] += 1
            self.expect(self.points[saddle]["survives"] and self.points[extremum]["survives"],
                        "an arc with a lost end")
        for p in self.alive():
            if p["index"] == 1:
                self.expect(sorted(ends[p["id"]]) == [0, 0, 2, 2], f"arcs of saddle {p['id']}")
        sides = collections.Counter()
        for region in self.complex["regions"]:
            kinds = [self.index(i) for i in region]
            self.expect(kinds == [0, 1, 2, 1], f"kinds of region {region}")
            low, first, high, second = region
            sides.update([(first, low), (first, high), (second, low), (second, high)])
        self.expect(sides == collections.Counter({arc: 2 * n for arc, n in arcs.items()}),
                    "each arc borders two regions")

    def check_components(self):
        parent = list(range(len(self.points)))

        def root(i):
            while parent[i] != i:
                parent[i] = parent[parent[i]]
                i = parent[i]
            return i

        joined = set()
        for arc in self.complex["arcs"]:
            joined |= {arc["saddle"], arc["extremum"]}
            parent[root(arc["saddle"])] = root(arc["extremum"])
        alone = collections.Counter(p["index"] for p in self.alive() if p["id"] not in joined)
        self.expect(alone[0] == alone[2] and alone[1] == 0, "points without arcs")
        parts = len({root(i) for i in joined}) + alone[0]
        self.expect(parts == self.complex["components"], "components")

    def check_lines(self, is_monotone):
        function = self.complex["function"]
        for arc in self.complex["arcs"]:
            line = arc["points"]
            saddle, extremum = self.points[arc["saddle"]], self.points[arc["extremum"]]
            self.expect(line[0] == saddle["position"] and line[-1] == extremum["position"],
                        f"ends of the line from {arc['saddle']} to {arc['extremum']}")
            values = [value_of(function, p) for p in line]
            rise = 1 if extremum["index"] == 2 else -1
            # The rounding of a value: of the coordinates in it, and of their square.
            size = 1 + max(abs(x) for p in line for x in p)
            size *= size if function["kind"] == "distance" else 1
            self.expect(not is_monotone or all(rise * (b - a) > -1e-13 * size
                                               for a, b in zip(values, values[1:])),
                        f"a line from {arc['saddle']} to {arc['extremum']} that is not monotone")

    def check_hierarchy(self):
        """On a raw complex: pairs by filling from below and from above."""
        expected = set()
        for kind, sign in ((0, 1), (2, -1)):
            ends = collections.defaultdict(list)
            for arc in self.complex["arcs"]:
                if self.index(arc["extremum"]) == kind:
                    ends[arc["saddle"]].append(arc["extremum"])
            oldest = {p["id"]: p["id"] for p in self.points}

            def find(i, oldest=oldest):
                while oldest[i] != i:
                    i = oldest[i]
                return i

            def age(i, sign=sign):
                return (sign * self.points[i]["value"], sign * i)

            for saddle in sorted(ends, key=age):
                elder, younger = sorted((find(e) for e in ends[saddle]), key=age)
                if elder != younger:
                    expected.add((saddle, younger))
                    oldest[younger] = elder
        hierarchy = self.complex["hierarchy"]
        found = {(pair["saddle"], pair["extremum"]) for pair in hierarchy}
        self.expect(found == expected and len(hierarchy) == len(found), "hierarchy")
        persistences = [pair["persistence"] for pair in hierarchy]
        self.expect(persistences == sorted(persistences), "order of the hierarchy")
        left = collections.Counter(p["index"] for p in self.points)
        left.subtract(self.index(i) for pair in found for i in pair)
        components, chi = self.complex["components"], self.complex["euler_characteristic"]
        self.expect((left[0], left[1], left[2]) ==
                    (components, 2 * components - chi, components), "what the hierarchy leaves")

    def check_simplified(self, raw):
        self.expect(self.complex["hierarchy"] == raw["hierarchy"], "another hierarchy")
        hierarchy = {(p["saddle"], p["extremum"]) for p in raw["hierarchy"]}
        gone = [(c["saddle"], c["extremum"]) for c in self.complex["cancelled"]]
        self.expect(set(gone) <= hierarchy, "a cancelled pair not in the hierarchy")
        self.expect({i for pair in gone for i in pair} ==
                    {p["id"] for p in self.points if not p["survives"]}, "who survives")
        self.expect(self.complex["components"] == raw["components"], "components changed")

    def check_spheres(self):
        spheres = sorted((p["position"][0] - p["radius"], p["radius"], p["position"])
                         for p in self.alive())
        for i, (low, radius, centre) in enumerate(spheres):
            for other_low, other_radius, other in spheres[i + 1:]:
                if other_low > low + 2 * radius:
                    break
                radii = radius + other_radius
                self.expect(radii <= math.dist(centre, other) * (1 + 1e-12), "spheres overlap")


def broken_laws(raw, simplified, default):
    before, after = Laws(raw), Laws(simplified)
    for laws in (before, after):
        laws.check_counts()
        laws.check_arcs_and_regions()
        laws.check_components()
        laws.check_lines(is_monotone=laws is before)
    before.check_hierarchy()
    after.check_simplified(raw)
    for laws in (before, after):
        laws.check_spheres()
    for key in ("euler_characteristic", "components"):
        if default and raw[key] != default[key]:
            before.broken.append(f"another function has other {key}")
    return before.broken + ["simplified: " + what for what in after.broken]


def morse(path, model, function, more, timeout):
    """The run; its report is the complex."""
    words = ["morse", path, "-o", "-", "--model", model, "--progress", "never", "-q", *more]
    return run_command(words + (["--function", function] if function else []), timeout)


def run(path, model, function, atoms, default, options, folder):
    row = dict.fromkeys(COLUMNS, "")
    row.update(file=str(path.relative_to(folder)), model=model, function=function or "default",
               atoms=atoms)
    first = morse(path, model, function, ["--raw"], options.timeout)
    row["seconds"], raw = first.seconds, first.report if first.code == 0 else None
    if first.code == 2 and "degenerate" in first.complaint:
        row["verdict"] = "degenerate: " + first.complaint
    elif first.code == 4 and "singular" in first.complaint:
        row["verdict"] = "refused: " + first.complaint
    elif first.code != 0:
        row["verdict"] = f"FAILED: exit code {first.code}: {first.complaint}"
    else:
        second = morse(path, model, function, [], options.timeout)
        if second.code != 0:
            row["verdict"] = f"FAILED: simplified: exit code {second.code}: {second.complaint}"
            return row, raw
        broken = broken_laws(raw, second.report, default)
        row["verdict"] = "FAILED: " + "; ".join(broken) if broken else "good"
        row.update({key: raw["before"][key] for key in ("minima", "saddles", "maxima")})
        row.update(chi=raw["euler_characteristic"], components=raw["components"],
                   cancelled=second.report["cancelled_pairs"], overlaps=raw["overlaps_before"],
                   shrunk=second.report["shrunk_radii"])
    return row, raw


def runs_of(path, model, atoms, options, folder):
    """Every function of one molecule and model; the default first, the others held against it."""
    default = None
    for function in functions(path, atoms, options):
        row, raw = run(path, model, function, atoms, default, options, folder)
        default = default or raw
        yield row
        if row["verdict"].startswith("refused"):
            return


def print_totals(rows):
    verdicts = collections.Counter(r["verdict"].split(":")[0] for r in rows)
    good = [r for r in rows if r["verdict"] == "good"]
    print(f"\n{len(rows)} runs: {verdicts['good']} good, {verdicts['degenerate']} degenerate, "
          f"{verdicts['refused']} refused as singular, {verdicts['FAILED']} failed")
    if good:
        total = {key: sum(r[key] for r in good)
                 for key in ("saddles", "overlaps", "cancelled", "shrunk")}
        print(f"{total['saddles']:,} saddles, {total['overlaps']:,} overlaps of protecting "
              f"spheres, {total['cancelled']:,} pairs contracted, {total['shrunk']:,} radii "
              f"shrunk; {sum(r['seconds'] for r in good):.1f} s")
    for row in rows:
        if row["verdict"].startswith("FAILED"):
            print(f"  {row['file']} {row['model']} {row['function']}: {row['verdict']}")
    return verdicts["FAILED"]


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    files, unreadable = sized_files(folder, options.only, options.largest)
    plan = [(p, model, atoms) for atoms, p in files for model in options.models.split(",")]
    with Rows(options.results, COLUMNS, WIDTHS, 3) as rows, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for some in pool.map(lambda r: list(runs_of(*r, options, folder)), plan):
            for row in some:
                rows.add(row)
    failures = print_totals(rows.rows)
    end(failures, rows.rows, unreadable)


if __name__ == "__main__":
    main()

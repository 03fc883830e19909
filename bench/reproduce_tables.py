"""From the rows of bench/reproduce.py: medians, ratios, fits, histograms, and the page's table."""

import csv
import json
import math
import statistics
import struct

import ablation
import molecule_runs
from molecule_runs import markdown

STAGES = [stage for stages in molecule_runs.STAGES.values() for stage in stages]

# Table 1 as printed: name, triangles, smallest angle, seconds of the sweep, of the dynamic method.
PAPER = {"5TMN": ("pdb7tmn", 24336, 27.02, 5, 600),
         "9DNA": ("A-DNA", 114316, 24.12, 51, 2112),
         "1GRM": ("GramicidinA", 305186, 24.37, 202, 5723)}
ASKED_EXPONENT = (0.95, 1.05)
LEFT_OUT, NOT_MEASURED = "left out: ", "not measured"


def read_rows(path):
    """The rows of an earlier run, as they were when they were written; none without the file."""
    def value(text):
        if text in ("True", "False"):
            return text == "True"
        try:
            return float(text) if "." in text else int(text)
        except ValueError:
            return text

    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return [{k: value(v) for k, v in row.items()} for row in csv.DictReader(file)]


def earlier_rows(results, name):
    """The rows of a part that was run earlier."""
    table = results / f"{name}.tsv"
    return molecule_runs.read_rows(table) if table.exists() else read_rows(results / f"{name}.csv")


def measured(rows, **fixed):
    """The rows of runs that made a mesh and agree with what is fixed."""
    return [r for r in rows if r.get("triangles")
            and all(r[key] == value for key, value in fixed.items())]


def is_unmeasured(row):
    """Whether a run was out of time, or left out for lack of it."""
    return str(row["reason"]).startswith((LEFT_OUT, "still running"))


def numbers(rows, column):
    return [float(r[column]) for r in rows]


def spread(values, digits=3):
    """Median, and least to most behind it."""
    if not values:
        return "-"
    middle = f"{statistics.median(values):.{digits}g}"
    if len(values) == 1:
        return middle
    return f"{middle} ({min(values):.{digits}g} to {max(values):.{digits}g})"


def ratio(rows, molecule, method, column, base="sweep"):
    """Median over median."""
    above = numbers(measured(rows, molecule=molecule, method=method), column)
    below = numbers(measured(rows, molecule=molecule, method=base), column)
    return statistics.median(above) / statistics.median(below) if above and below else None


def power_law(points):
    """(exponent, its standard error, factor) of y = factor x^exponent, by least squares of the
    logarithms; nothing with fewer than three points."""
    if len(points) < 3:
        return None
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x = statistics.fmean(x for x, _ in logs)
    mean_y = statistics.fmean(y for _, y in logs)
    spread_x = sum((x - mean_x) ** 2 for x, _ in logs)
    if spread_x == 0:
        return None
    exponent = sum((x - mean_x) * (y - mean_y) for x, y in logs) / spread_x
    rest = sum((y - mean_y - exponent * (x - mean_x)) ** 2 for x, y in logs)
    error = math.sqrt(rest / (len(logs) - 2) / spread_x)
    return exponent, error, math.exp(mean_y - exponent * mean_x)


def medians(rows, column, **fixed):
    """(triangles, median) of each mesh, fewest triangles first. The mesh of a method, molecule and
    C is the same in every repetition."""
    groups = {}
    for row in measured(rows, **fixed):
        groups.setdefault((row["molecule"], str(row["C"])), []).append(row)
    return sorted((int(g[0]["triangles"]), statistics.median(numbers(g, column)))
                  for g in groups.values())


def fit(rows, column, least=1e4, **fixed):
    """power_law over the meshes of at least so many triangles, and those meshes."""
    points = [p for p in medians(rows, column, **fixed) if p[0] >= least]
    return power_law(points), points


def write_angles(path, meshes, molecules, methods):
    """Counts by whole degrees, of all angles of the meshes that were kept."""
    rows = [["molecule", "method", "degree", "count"]]
    for molecule in molecules:
        for method in methods:
            mesh = meshes / f"{molecule}.{method}.ply"
            if mesh.exists():
                rows += [[molecule, method, degree, count]
                         for degree, count in enumerate(angle_counts(*read_ply(mesh)))]
    with open(path, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


def read_ply(path):
    """Points (x, y, z) and triangles (a, b, c) of a binary PLY as morskin writes it."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    words = [line.split() for line in head.decode().splitlines()]
    vertices, faces = (int(line[2]) for line in words if line[0] == "element")
    triangles = struct.iter_unpack("<B3i", body[24 * vertices:24 * vertices + 13 * faces])
    return list(struct.iter_unpack("<3d", body[:24 * vertices])), [t[1:] for t in triangles]


def angle_counts(points, triangles):
    """How many angles lie in [d, d + 1) degrees, d from 0 to 179."""
    counts = [0] * 180
    for triangle in triangles:
        corners = [points[v] for v in triangle]
        squares = [math.dist(corners[k - 2], corners[k - 1]) ** 2 for k in range(3)]  # opposite k
        for k in range(3):
            a, b, c = squares[k], squares[k - 2], squares[k - 1]
            cosine = (b + c - a) / (2 * math.sqrt(b * c)) if b > 0 and c > 0 else 1.0
            degrees = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
            counts[min(179, int(degrees))] += 1
    return counts


def write_environment(path, started, ended, options, part):
    """The environment of this part; that of parts run earlier is kept. Returns both."""
    now = dict(started)
    now["load_at_start"], now["load_at_end"] = now.pop("load"), ended["load"]
    now["date_at_end"] = ended["date"]
    now["quick"], now["repetitions"] = options.quick, options.repetitions
    earlier = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    text = earlier | {part: now}
    path.write_text(json.dumps(text, indent=2) + "\n", encoding="utf-8")
    return text


def environments_text(known):
    """By part the run that its rows are of, from environment.json."""
    body = []
    for part, at in known.items():
        repetitions = 1 if part == "agreement" else at["repetitions"]  # a topology needs no more
        body.append([part, f"{at['cpu']}, {at['cores']} cores",
                     f"{at['date'][:10]}, {at['date'][11:16]} to {at['date_at_end'][11:16]}",
                     repetitions, f"{at['load_at_start'][0]:.1f}, {at['load_at_end'][0]:.1f}"])
    return markdown(["part", "machine", "its run, UTC", "repetitions", "load before and after"],
                    body)


def molecules_text(rows, methods):
    head = ["molecule", "method", "triangles", "smallest angle", "seconds, median (spread)",
            "CPU seconds", "MiB", "certified"]
    body = []
    for molecule, (name, triangles, angle, sweep, dynamic) in PAPER.items():
        body.append([f"{name}, the paper's", "sweep", f"{triangles:,}", angle, sweep, "", "", ""])
        body.append([f"{name}, the paper's", "dynamic", "", "", dynamic, "", "", ""])
        for method in methods:
            runs = measured(rows, molecule=molecule, method=method)
            if not runs:
                has_failed = any(not is_unmeasured(r) for r in rows
                                 if (r["molecule"], r["method"]) == (molecule, method))
                body.append([molecule, method, "no mesh" if has_failed else NOT_MEASURED,
                             "", "", "", "", ""])
                continue
            body.append([molecule, method, f"{int(runs[0]['triangles']):,}",
                         f"{float(runs[0]['min_angle_deg']):.2f}",
                         spread(numbers(runs, "seconds")), spread(numbers(runs, "cpu_seconds")),
                         f"{max(numbers(runs, 'peak_memory_bytes')) / 2**20:.0f}",
                         f"{sum(bool(r['certified']) for r in runs)} of {len(runs)}"])
    return markdown(head, body)


def ratios_text(rows, methods):
    others = [m for m in methods if m != "sweep"]
    head = ["molecule", "dynamic / sweep, the paper's",
            *(f"{m} / sweep, {unit}" for m in others for unit in ("time", "CPU time"))]
    body = []
    for molecule, (_, _, _, sweep, dynamic) in PAPER.items():
        found = [ratio(rows, molecule, m, column) for m in others
                 for column in ("seconds", "cpu_seconds")]
        body.append([molecule, f"{dynamic / sweep:.0f}",
                     *(NOT_MEASURED if value is None else f"{value:.2f}" for value in found)])
    return markdown(head, body)


def scaling_text(rows, methods):
    head = ["series", "method", "meshes", "triangles", "exponent of time", "exponent of CPU time"]
    body = []
    for series in ("corpus", "finer"):
        for method in methods:
            if not any((r["series"], r["method"]) == (series, method) for r in rows):
                continue
            found, points = fit(rows, "seconds", series=series, method=method)
            cpu, _ = fit(rows, "cpu_seconds", series=series, method=method)
            body.append([series, method, len(points),
                         f"{points[0][0]:,} to {points[-1][0]:,}" if points else "",
                         *(f"{f[0]:.3f} ± {f[1]:.3f}" if f else NOT_MEASURED
                           for f in (found, cpu))])
    return markdown(head, body)


def agreement_text(rows, methods):
    """How many sets and models each method has certified, and on how many its topology is right."""
    head = ["method", "runs", "certified", "right χ, components, genus", "wrong ones",
            NOT_MEASURED]
    body = []
    for method in methods:
        runs = [r for r in rows if r["method"] == method]
        right = [r for r in measured(runs)
                 if all(r[key] == r["expected_" + key]
                        for key in ("euler_characteristic", "components", "genus"))]
        unmeasured = sum(map(is_unmeasured, runs))
        body.append([method, len(runs), sum(bool(r["certified"]) for r in runs), len(right),
                     len(runs) - unmeasured - len(right), unmeasured])
    return markdown(head, body)


def verdict(value, error, low, high):
    """What was found, and whether it is in a range, as far as its error tells."""
    is_open = low <= value + error and value - error <= high
    met = "yes" if low <= value <= high else "perhaps" if is_open else "no"
    return [f"{value:.3f} ± {error:.3f}", met]


def asked_text(rows):
    """The requirements on the sweep, and whether they are met."""
    body = []
    for molecule, (name, _, angle, _, _) in PAPER.items():
        runs = measured(rows.get("table1", []), molecule=molecule, method="sweep")
        if runs:
            found = float(runs[0]["min_angle_deg"])
            body.append([f"smallest angle on {molecule} at least the paper's on {name}", angle,
                         f"{found:.2f}", "yes" if found >= angle else "no"])
    for series in ("corpus", "finer"):
        found, _ = fit(rows.get("scaling", []), "seconds", series=series, method="sweep")
        low, high = ASKED_EXPONENT
        body.append([f"exponent of the sweep's time, {series}", f"{low} to {high}",
                     *(verdict(*found[:2], low, high) if found else [NOT_MEASURED, ""])])
    return markdown(["asked of the sweep", "asked", "found", "met"], body)


def table1_text(rows, methods, notes, at):
    """The whole of table1.md; `at` is the environment of Table 1 itself."""
    date, cpu, load = at["date"][:10], at["cpu"], at["load_at_start"]
    text = f"# Table 1, run of {date}\n\n"
    text += (f"{cpu}, {at['cores']} cores, {at['compiler']}; load at the start "
             f"{load[0]:.1f}. Times are of whole runs, file in to certified file out, with as many "
             "threads as the method uses.\n\n")
    if "table1" in rows:
        text += "## Molecules\n\n" + molecules_text(rows["table1"], methods)
        text += "\n## Ratios\n\n" + ratios_text(rows["table1"], methods)
    if "scaling" in rows:
        text += "\n## Time against triangles\n\nMeshes of 10,000 triangles and more.\n\n"
        text += scaling_text(rows["scaling"], methods)
    if "agreement" in rows:
        text += "\n## Topology\n\n" + agreement_text(rows["agreement"], methods)
    if "ablation" in rows:
        text += "\n## As printed\n\n" + ablation.table(rows["ablation"])
    text += "\n## Asked and found\n\n" + asked_text(rows)
    text += "\n## Notes\n\n" + ("".join(f"- {note}\n" for note in notes) or "None.\n")
    return text

#!/usr/bin/env python3
"""Tables and sentences on pages are those that papers/results makes (papers/course/results.py), of
all the runs that the scripts in bench plan, and every run in them is good."""

import re
import statistics
import sys
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / folder) for folder in ("papers/course", "bench", "bench/solvers")]
import ablation  # noqa: E402
import balls  # noqa: E402
import batch  # noqa: E402
import complexes  # noqa: E402
import counts  # noqa: E402
import curved_errors  # noqa: E402
import densities  # noqa: E402
import features  # noqa: E402
import large  # noqa: E402
import methods  # noqa: E402
import molecule  # noqa: E402
import operations  # noqa: E402
import prediction  # noqa: E402
import replay  # noqa: E402
import results  # noqa: E402
import second_order  # noqa: E402
import ses_like  # noqa: E402
import subdomains  # noqa: E402
import tetrahedra  # noqa: E402
from measure import is_marching_cubes  # noqa: E402
from molecule_runs import MODELS, read_rows  # noqa: E402


def wrong_ablation(rows):
    """Each switch of the program must have a row of its own."""
    if [r["as_printed"] for r in rows] != list(ablation.ROWS):
        yield "not the rows of bench/ablation.py"
    header = (ROOT / "bench" / "ablation" / "as_printed.h").read_text(encoding="utf-8")
    switches = re.findall(r'\{"([\w-]+)", &AsPrinted::', header)
    alone = [row[0][0] for row in ablation.ROWS.values() if len(row[0]) == 1]
    if sorted(switches) != sorted(alone):
        yield "the rows of bench/ablation.py with one switch are not the program's switches"
    for r in rows:
        if int(r["certified"]) + int(r["failed"]) + int(r["out_of_time"]) != int(r["runs"]):
            yield f"{r['as_printed']}: the outcomes are not as many as the runs"
    if ablation.failures([{**r, "runs": int(r["runs"]), "certified": int(r["certified"])}
                          for r in rows]):
        yield "with nothing as printed not every run is certified"


def wrong_densities(rows):
    asked = [(r["molecule"], int(r["asked"])) for r in rows]
    if asked != [(m, d) for m in densities.MOLECULES for d in densities.DENSITIES]:
        yield "not the runs of bench/densities.py"
    for r in rows:
        if r["verdict"].startswith("FAILED") or float(r["min_angle"]) < 30:
            yield f"{r['molecule']} with {r['asked']}: {r['verdict']}, {r['min_angle']} degrees"
        if r["verdict"] == "made" and abs(float(r["made"]) / float(r["asked"]) - 1) > 0.1:
            yield f"{r['molecule']} with {r['asked']}: {r['made']} is off by more than a tenth"
    if max(densities.bent(rows)) > densities.MOST_OVER_FORCED:
        yield f"more than {densities.MOST_OVER_FORCED} times the triangles that are forced"


def wrong_offsets(rows):
    """The model ses-like must have the smallest 95 % distances."""
    if [(r["chain"], float(r["offset"])) for r in rows] != [(c, o) for c in ses_like.CHAINS
                                                            for o in ses_like.OFFSETS]:
        yield "not the runs of bench/ses_like.py"
    yield from (f"{r['chain']}: {r['verdict']}" for r in rows if r["verdict"] != "certified")

    def farthest(offset):
        return statistics.median(max(float(r["to_ses_95"]), float(r["from_ses_95"]))
                                 for r in rows if float(r["offset"]) == offset)
    code = (ROOT / "skin" / "model.h").read_text(encoding="utf-8")
    used = float(re.search(r"ses_like_offset = ([\d.]+);", code)[1])
    if used != min(ses_like.OFFSETS, key=farthest):
        yield f"the model's {used} is not the offset with the smallest distances"


def wrong_solvers(script, rows):
    """Every mesh of morskin's must be certified."""
    if [r["options"] for r in rows] != script.MESHES:
        yield f"not the meshes of bench/solvers/{script.__name__}.py"
    for r in rows:
        is_good = r["verdict"] == "certified" and float(r["min_angle"]) >= 30
        if not is_good and not is_marching_cubes(r["options"]):
            yield f"{r['options']}: {r['verdict']}, {r['min_angle']} degrees"


def wrong_subdomains(rows):
    if [(r["molecule"], r["model"], r["options"], int(r["subdomains"])) for r in rows] != [
            (name, model, " ".join(options), count)
            for name, model, options in subdomains.SURFACES for count in subdomains.COUNTS]:
        yield "not the runs of bench/subdomains.py"
    for r in rows:
        if r["verdict"] != "certified":
            yield f"{r['molecule']} in {r['subdomains']}: {r['verdict']}"


def wrong_batch(rows):
    """The goal's molecules; each row is what it says, and no other."""
    recipes = batch.RECIPES.read_text(encoding="utf-8").splitlines()
    if len(set(recipes)) != batch.COUNT:
        yield f"bench/batch_inputs.txt has not {batch.COUNT} distinct recipes"
    if not rows or [r["model"] for r in rows] != batch.MODELS[:len(rows)]:
        yield "not the models of bench/batch.py, in their order"
    for r in rows:
        if int(r["ok"]) + int(r["refused"]) != int(r["inputs"]):
            yield f"{r['model']}: {r['inputs']} molecules, of which {r['ok']} are certified"
        if float(r["median_atoms"]) < 2000 or float(r["least_angle"]) < 30:
            yield f"{r['model']}: {r['median_atoms']} atoms, {r['least_angle']} degrees"
        if float(r["most_mib"]) >= 200:
            yield f"{r['model']}: a worker of {r['most_mib']} MiB"
    if batch.sentence(rows) not in (ROOT / "papers" / "batch.md").read_text(encoding="utf-8"):
        yield f"batch.md does not say: {batch.sentence(rows)}"


def wrong_counts(rows):
    if [(r["file"], r["model"], float(r["C"])) for r in rows] != list(counts.runs()):
        yield "not the runs of bench/counts.py"
    yield from (f"{r['file']}, {r['model']}: {r['verdict']}" for r in rows
                if r["verdict"] != "certified")


def wrong_replay(rows):
    if [(r["molecule"], r["model"], int(r["workers"])) for r in rows] != [
            (name, model, w) for name, model in replay.SURFACES for w in replay.WORKERS]:
        yield "not the runs of bench/replay.py"
    for r in rows:
        if r["verdict"] != "certified":
            yield f"{r['molecule']} on {r['workers']}: {r['verdict']}"


def wrong_methods(rows):
    skins = [(name, model) for name in [*methods.BALLS, *methods.BUNDLED_BALLS, *methods.FILES]
             for model in MODELS]
    if [(r["input"], r["model"], r["method"]) for r in rows] != [
            (*skin, method) for skin in skins for method in ("sweep", "static", "dynamic")]:
        yield "not the runs of bench/methods.py with all three methods"
    yield from (f"{r['input']}, {r['model']}, {r['method']}: {r['verdict']}" for r in rows
                if r["verdict"] != "certified")


def wrong_prediction(rows):
    everywhere = prediction.of_guard(rows, prediction.GUARDS[0])
    yield from (f"{r['molecule']}, {r['model']}: not certified" for r in everywhere
                if not int(r["certified"]))
    for guard in prediction.GUARDS:
        if len(prediction.of_guard(rows, guard)) != len(everywhere):
            yield f"{guard}: not the runs of the others"


def wrong_functions(rows):
    yield from (f"{r['molecule']}: {r['certified']} of {r['functions']}, chi {r['chi']}"
                for r in rows if r["certified"] != r["functions"] or "," in r["chi"])


def wrong_complexes(rows):
    if [r["molecule"] for r in rows] != list(complexes.MOLECULES):
        yield "not the runs of bench/complexes.py"
    yield from (f"{r['molecule']}: {r['verdict']}" for r in rows if r["verdict"] != "good")


def wrong_operations(rows):
    if [(r["file"], r["options"]) for r in rows] != list(operations.runs()):
        yield "not the runs of bench/operations.py"
    yield from (f"{r['file']}: {r['verdict']}" for r in rows if r["verdict"] != "certified")


def wrong_large(rows):
    if [(r["molecule"], r["model"], float(r["C"])) for r in rows] != [
            (name, model, c) for model, c, names in large.SURFACES for name in names]:
        yield "not the runs of bench/large.py"
    yield from (f"{r['molecule']}, {r['model']}: {r['verdict']}" for r in rows
                if r["verdict"] != "certified")


def wrong_corpus(rows):
    """Every molecule is certified at once, with the angles that the goal of its C promises."""
    for r in rows:
        least = 35 if float(r["C"]) <= 0.2 else 30
        if r["certified"] != r["molecules"] or float(r["min_angle"]) < min(
                least, 30 if int(r["missed"]) else least):
            yield f"C = {r['C']}, {r['model']}: {r['certified']} of {r['molecules']}"


def wrong_second_order(rows):
    if [(r["molecule"], float(r["C"])) for r in rows] != [
            (m, C) for m in second_order.MOLECULES for C in second_order.SIZES]:
        yield "not the runs of bench/second_order.py"
    for r in rows:
        if r["verdict"] != "certified" and (r["verdict"] != "refused" or float(r["C"]) < 0.4):
            yield f"{r['molecule']} with {r['C']}: {r['verdict']}"


def wrong_curved_errors(rows):
    """Kinds of triangles add up, and the parabola's nodes are the better ones but on a ball."""
    known = {(r["surface"], float(r["C"]), r["nodes"], r["patches"]): r for r in rows}
    for surface in curved_errors.SURFACES:
        for C in curved_errors.SIZES:
            for nodes in curved_errors.CHOICES:
                kinds = [known[surface, C, nodes, k] for k in curved_errors.KINDS
                         if (surface, C, nodes, k) in known]
                for column in ("triangles", "area", "flat_lacks", "curved_lacks"):
                    *parts, whole = (float(r[column]) for r in kinds)
                    if abs(sum(parts) - whole) > 1e-6 * float(kinds[-1]["area"]):
                        yield f"{surface} with {C}: {column} do not add up"
            for column in ("curved_lacks", "distance", "angle_deg"):
                middle, parabola = (float(known[surface, C, nodes, "all"][column])
                                    for nodes in curved_errors.CHOICES)
                if not (parabola < middle or surface == "ball"):
                    yield f"{surface} with {C}: nodes of the parabola do not lower {column}"


def wrong_features(rows):
    if [r["molecule"] for r in rows] != features.MOLECULES:
        yield "not the runs of bench/features.py"
    for r in rows:
        if r["verdict"] != "certified" or abs(float(r["density"]) / features.GOAL - 1) > 0.1:
            yield f"{r['molecule']}: {r['verdict']}, {r['density']} vertices per square Angstrom"


def wrong_replacement():
    """A stale number is found, and put right without touching anything else."""
    head = "| a | b |\n|---|---|\n"
    page = f"On 3,500 runs it takes 1.5 to 2.0 times the time.\n\n{head}| 1 | 2 |\nx"
    for text in ("takes 1.5 to 2.5 times", "On 12 runs", head + "| 1 | 3 |\n| 4 | 5 |\n"):
        new = results.renewed(page, text, "a page")
        if results.has(page, text) or not results.has(new, text) or not new.endswith("|\nx"):
            yield f"not put right: {text}"
    try:
        results.renewed(page, "it takes 1 day", "a page")
        yield "a sentence that is not there has a place"
    except ValueError:
        pass


FILES = [("ablation", wrong_ablation), ("densities", wrong_densities), ("ses-like", wrong_offsets),
         ("subdomains", wrong_subdomains), ("counts", wrong_counts), ("batch", wrong_batch),
         ("replay", wrong_replay), ("large", wrong_large), ("corpus", wrong_corpus),
         ("operations", wrong_operations), ("complexes", wrong_complexes),
         ("methods", wrong_methods), ("prediction", wrong_prediction),
         ("functions", wrong_functions), ("second-order", wrong_second_order),
         ("curved-errors", wrong_curved_errors),
         ("features", wrong_features),
         *((f"solvers-{script.__name__}", partial(wrong_solvers, script))
           for script in (balls, molecule, tetrahedra))]


def complaints():
    yield from wrong_replacement()
    yield from results.stale()
    for name, wrong in FILES:
        rows = read_rows(ROOT / "papers" / "results" / f"{name}.tsv")
        yield from (f"{name}.tsv: {complaint}" for complaint in wrong(rows))


def main():
    found = list(complaints())
    for complaint in found:
        print(complaint)
    print(f"{len(list(results.texts()))} tables and sentences, {len(found)} complaints")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()

"""Which density is enough? Flat triangles are off by about 1 / density, so that one mesh says where
an error is 1 % and where a tenth of that."""

import balls
from measure import is_marching_cubes
from molecule import limit, uniform_meshes
from molecule_runs import ROOT, markdown, read_rows

SHARES = (0.01, 0.001)
BEM = 5  # vertices per square Angstrom, of `--for bem` (app/presets.cpp)


def densities(molecule_rows, ball_rows):
    """By case and share the vertices per square Angstrom, from the finest mesh of each."""
    finest = [r for r in ball_rows if not is_marching_cubes(r["options"])][-1]
    for name, words in (("born", "a charge in the centre"), ("kirkwood", "charges off the centre")):
        error = float(finest[f"{name}_error"])
        yield f"ball of {balls.RADIUS:g} Å, {words}", float(finest["density"]), error
    for model in ("vdw", "ses-like"):
        finest = uniform_meshes(molecule_rows, model)[-1]
        error = float(finest["energy"]) / limit(molecule_rows, model) - 1
        yield f"1L2Y, model {model}", float(finest["density"]), error


def sentence(rows):
    """What the page says of `--for bem`. @param rows  of the molecule"""
    ball_rows = read_rows(ROOT / "papers" / "results" / "solvers-balls.tsv")
    _, _, vdw, ses_like = (100 * density * abs(error) / BEM
                           for _, density, error in densities(rows, ball_rows))
    return f"about {vdw:.1f} % with vdw and {ses_like:.1f} % with ses-like"


def table(rows):
    """The rows of the page. @param rows  of the molecule"""
    ball_rows = read_rows(ROOT / "papers" / "results" / "solvers-balls.tsv")
    return markdown(
        ["", "finest mesh, vertices per Å²", "off by", "1 % needs", "a tenth of it needs"],
        ([case, f"{density:.1f}", f"{error:+.2%}",
          *(f"{density * abs(error) / share:.0f}" for share in SHARES)]
         for case, density, error in densities(rows, ball_rows)))

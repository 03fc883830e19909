#!/usr/bin/env python3
"""Same input, same bytes: two builds of the command write the same files for the bundled molecules.

usage: same_bytes.py MORSKIN MORSKIN2     prints "N passed, N failed" at the end
"""
import pathlib
import subprocess
import sys
import tempfile

MOLECULES = pathlib.Path(__file__).resolve().parent.parent / "bench" / "molecules"
SMALL = ("one_ball", "two_balls", "cube8", "ring12", "shell_hollow", "benzene", "caffeine", "c60",
         "5tmn_ligand")


def mesh(program, molecule, folder, *options):
    out = pathlib.Path(folder) / "mesh.ply"
    subprocess.run([program, "mesh", molecule, "-o", out, "-q", *options], check=True)
    return out.read_bytes()


def main():
    first, second = sys.argv[1:3]
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for molecule in sorted(MOLECULES.iterdir()):
            if molecule.name.split(".")[0] not in SMALL:
                continue
            for model in ("paper", "sas", "vdw"):
                options = ("--model", model)
                bytes_ = mesh(first, molecule, folder, *options)
                same = (bytes_ == mesh(second, molecule, folder, *options)
                        and bytes_ == mesh(first, molecule, folder, "--threads", "1", *options))
                passed, failed = passed + same, failed + (not same)
                if not same:
                    print(f"{molecule.name} {model}: the builds differ")
    print(f"{passed} passed, {failed} failed")
    return failed > 0 or passed == 0


if __name__ == "__main__":
    sys.exit(main())

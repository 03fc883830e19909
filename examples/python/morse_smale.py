"""The critical points of a height on a skin, and the arcs that join them."""

from pathlib import Path

import morskin
import numpy as np

MOLECULES = Path(__file__).resolve().parent.parent / "molecules"

skin = morskin.read(MOLECULES / "ring12.xyzr").skin()

# [excerpt: python-morse]
found = skin.morse_smale(direction=[0.3, 0.9, 0.2])
minima, saddles, maxima = np.bincount(found.points.indices, minlength=3)
print(f"{minima} minima - {saddles} saddles + {maxima} maxima = {minima - saddles + maxima}")
saddle, extremum = found.arcs[0]
line = found.arc_points[found.arc_offsets[0]:found.arc_offsets[1]]
length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
print(f"arc 0 joins {saddle} and {extremum}, {length:.2f} A in {len(line)} points")
# [/excerpt]

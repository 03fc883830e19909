"""Area and volume along an MDAnalysis trajectory: two atoms that part. Needs MDAnalysis."""

import MDAnalysis
import morskin
import numpy as np

# [excerpt: python-trajectory]
universe = MDAnalysis.Universe.empty(2, trajectory=True)
universe.add_TopologyAttr("elements", ["C", "O"])
universe.load_new(np.array([[[0, 0, 0], [d, 0, 0]] for d in (1.2, 3.0, 9.0)]), dt=2.0)
for row in morskin.adapters.over_time(universe, C=0.1):
    print(f"{row['time']:.0f} ps: {row['area']:.1f} A^2, {row['volume']:.1f} A^3, "
          f"in {row['components']}")
# [/excerpt]

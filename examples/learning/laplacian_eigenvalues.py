"""The first eigenvalues of the Laplacian of a surface that `morskin features` has written.
Usage: laplacian_eigenvalues.py x.npz"""

import sys

# [excerpt: features-load]
import numpy as np
from scipy.sparse import csr_matrix, diags
from scipy.sparse.linalg import eigsh

with np.load(sys.argv[1], allow_pickle=False) as file:
    x = dict(file)

features = np.stack([x["shape_index"], x["mean_curvature"], x["hphob"] / 4.5], axis=1)
print(features.shape[1], "features at", len(x["vertices"]), "vertices")

residues = x["atom_residue"][x["atom"]]  # by vertex, of the nearest atom
print(f"arginine has {100 * x['mass'][residues == 'ARG'].sum() / x['mass'].sum():.0f}% of the area")
# [/excerpt]

# [excerpt: features-eigenvalues]
L = csr_matrix((x["laplacian_data"], x["laplacian_indices"], x["laplacian_indptr"]),
               shape=x["laplacian_shape"])
M = diags(x["mass"])  # square Angstrom
values, functions = eigsh(L, k=6, M=M, sigma=-0.01)  # L u = lambda M u, the smallest six
print("eigenvalues, 1/A^2:", np.array2string(abs(values), precision=4, suppress_small=True))

energy = functions[:, 1] @ (L @ functions[:, 1])  # of one that has unit norm with M
print("Dirichlet energy over eigenvalue: %.6f" % (energy / values[1]))
# [/excerpt]

"""How hard the equations are for an iterative solver."""

from inspect import signature

import numpy as np
from scipy.linalg import lu_solve
from scipy.sparse.linalg import LinearOperator, gmres, svds


class VertexBlocks:
    """Each vertex's two equations for its two unknowns, as a preconditioner. It takes away what is
    only the size of a vertex's triangles."""

    def __init__(self, matrix):
        n = len(matrix) // 2
        rows = np.arange(n)
        self.blocks = np.array([[matrix[rows, rows], matrix[rows, n + rows]],
                                [matrix[n + rows, rows], matrix[n + rows, n + rows]]])
        self.inverse = np.moveaxis(np.linalg.inv(np.moveaxis(self.blocks, 2, 0)), 0, 2)

    def solve(self, x):
        return np.einsum("ijn,jn->in", self.inverse, x.reshape(2, -1)).ravel()

    def solve_transposed(self, x):
        return np.einsum("jin,jn->in", self.inverse, x.reshape(2, -1)).ravel()

    def times(self, x):
        return np.einsum("ijn,jn->in", self.blocks, x.reshape(2, -1)).ravel()

    def times_transposed(self, x):
        return np.einsum("jin,jn->in", self.blocks, x.reshape(2, -1)).ravel()


def gmres_steps(matrix, right, blocks, tolerance=1e-6):
    """Of GMRES to a residual of this share of the right side's; infinite if 500 do not do."""
    steps = []
    # SciPy has renamed the tolerance.
    name = "rtol" if "rtol" in signature(gmres).parameters else "tol"
    _, info = gmres(matrix, right, M=LinearOperator(matrix.shape, blocks.solve), restart=250,
                    maxiter=2, atol=0, callback=steps.append, callback_type="pr_norm",
                    **{name: tolerance})
    return len(steps) if info == 0 else float("inf")


def norm(apply, transposed, size):
    """The largest singular value of a linear map, by Lanczos' method to three digits."""
    operator = LinearOperator((size, size), apply, transposed)
    return svds(operator, k=1, v0=np.ones(size), tol=1e-3, return_singular_vectors=False)[0]


def condition_numbers(matrix, factors, blocks):
    """The largest singular value over the smallest, as the matrix is and with the blocks solved.

    @param factors  scipy.linalg.lu_factor's"""
    size = len(matrix)

    def solve(x):
        return lu_solve(factors, x)

    def solve_transposed(x):
        return lu_solve(factors, x, trans=1)
    plain = (norm(lambda x: matrix @ x, lambda x: x @ matrix, size) *
             norm(solve, solve_transposed, size))
    scaled = (norm(lambda x: blocks.solve(matrix @ x),
                   lambda x: blocks.solve_transposed(x) @ matrix, size) *
              norm(lambda x: solve(blocks.times(x)),
                   lambda x: blocks.times_transposed(solve_transposed(x)), size))
    return plain, scaled

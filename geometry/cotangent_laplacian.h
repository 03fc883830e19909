#pragma once

/// The Laplacian of piecewise linear functions on a triangle mesh, as a sparse matrix.

#include <cstdint>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

/// A square matrix in compressed sparse rows, as SciPy stores it. The entries of row i are at
/// offsets[i] to offsets[i + 1] - 1, by ascending column.
struct SparseMatrix {
  std::vector<double> values;
  std::vector<std::int32_t> columns, offsets;
};

/// The stiffness matrix L, vertices by vertices, without unit: L_ij = -(cot a + cot b) / 2, with a
/// and b the angles opposite to the edge ij, and L_ii such that rows add up to 0. It is symmetric
/// to the last bit and positive semidefinite, and x^T L x is the integral of |grad x|^2, the
/// Dirichlet energy of the function that is x at the vertices and linear on each triangle.
/// @pre no triangle is degenerate; vertices and twice the edges, some 7 for each vertex, are fewer
///      than 2^31
/// Source: Pinkall & Polthier 1993.
SparseMatrix cotangent_laplacian(const IndexedMesh& mesh);

/// By vertex, a third of the area of its triangles, Angstrom^2: the mass matrix, lumped.
std::vector<double> lumped_mass(const IndexedMesh& mesh);

}  // namespace morskin::geometry

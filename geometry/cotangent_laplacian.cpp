#include "geometry/cotangent_laplacian.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

namespace morskin::geometry {

namespace {

/// What one triangle adds to an entry of a row.
struct Part {
  std::uint32_t column, triangle;
  double value;
};

/// All parts, row by row; those of row i begin at first[i].
struct Parts {
  std::vector<Part> parts;
  std::vector<std::size_t> first;
};

Parts parts_of(const IndexedMesh& mesh) {
  Parts result;
  result.first.assign(mesh.positions.size() + 1, 0);
  for (const TriangleCorners& t : mesh.triangles) {
    for (const std::uint32_t v : t) result.first[v + 1] += 2;
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) result.first[v + 1] += result.first[v];
  result.parts.resize(result.first.back());
  std::vector<std::size_t> next = result.first;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleCorners& corners = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t apex = corners[k], i = corners[(k + 1) % 3], j = corners[(k + 2) % 3];
      const Vector to_i = mesh.positions[i] - mesh.positions[apex];
      const Vector to_j = mesh.positions[j] - mesh.positions[apex];
      const double value = -to_i.dot(to_j) / to_i.cross(to_j).norm() / 2;
      const auto triangle = static_cast<std::uint32_t>(t);
      result.parts[next[i]++] = {j, triangle, value};
      result.parts[next[j]++] = {i, triangle, value};
    }
  }
  return result;
}

/// Appends the row i, whose parts are sorted by column.
void append_row(SparseMatrix& matrix, std::uint32_t i, std::span<const Part> parts) {
  const std::size_t begin = matrix.values.size();
  const auto append = [&](std::uint32_t column, double value) {
    matrix.columns.push_back(static_cast<std::int32_t>(column));
    matrix.values.push_back(value);
  };
  double sum = 0;
  std::size_t diagonal = begin;
  for (std::size_t k = 0; k < parts.size();) {
    const std::uint32_t column = parts[k].column;
    double value = 0;
    for (; k < parts.size() && parts[k].column == column; ++k) value += parts[k].value;
    if (column < i) diagonal = matrix.values.size() + 1;
    append(column, value);
    sum += value;
  }
  const auto place = static_cast<std::ptrdiff_t>(diagonal);
  matrix.columns.insert(matrix.columns.begin() + place, static_cast<std::int32_t>(i));
  matrix.values.insert(matrix.values.begin() + place, -sum);
  matrix.offsets.push_back(static_cast<std::int32_t>(matrix.values.size()));
}

}  // namespace

SparseMatrix cotangent_laplacian(const IndexedMesh& mesh) {
  auto [parts, first] = parts_of(mesh);
  SparseMatrix matrix;
  matrix.offsets.push_back(0);
  matrix.values.reserve(parts.size() / 2 + mesh.positions.size());
  matrix.columns.reserve(matrix.values.capacity());
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const std::span<Part> row = std::span(parts).subspan(first[i], first[i + 1] - first[i]);
    // By triangle too, so that L_ij and L_ji are added up in the same order.
    std::ranges::sort(row, {}, [](const Part& p) { return std::tuple(p.column, p.triangle); });
    append_row(matrix, i, row);
  }
  return matrix;
}

std::vector<double> lumped_mass(const IndexedMesh& mesh) {
  std::vector<double> mass(mesh.positions.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point& p = mesh.positions[a];
    const double area = (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm() / 2;
    for (const std::uint32_t v : {a, b, c}) mass[v] += area / 3;
  }
  return mass;
}

}  // namespace morskin::geometry

#include "geometry/cotangent_laplacian.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/mesh_shape.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using geometry::IndexedMesh;
using geometry::Point;
using geometry::SparseMatrix;
using geometry::Vector;

namespace {

double entry(const SparseMatrix& matrix, std::int32_t row, std::int32_t column) {
  const auto at = [&](std::int32_t r) {
    return matrix.columns.begin() + matrix.offsets[static_cast<std::size_t>(r)];
  };
  const auto found = std::lower_bound(at(row), at(row + 1), column);
  if (found == at(row + 1) || *found != column) return 0;
  return matrix.values[static_cast<std::size_t>(found - matrix.columns.begin())];
}

double energy_by_gradients(const IndexedMesh& mesh, const std::vector<double>& x) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector p = mesh.positions[b] - mesh.positions[a];
    const Vector q = mesh.positions[c] - mesh.positions[a], n = p.cross(q);
    // The gradient g lies in the plane, with g . p and g . q the differences of x.
    const Vector g = ((x[b] - x[a]) * q.cross(n) + (x[c] - x[a]) * n.cross(p)) / n.squaredNorm();
    sum += g.squaredNorm() * n.norm() / 2;
  }
  return sum;
}

double energy_by_matrix(const SparseMatrix& matrix, const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < matrix.offsets.size(); ++i) {
    for (auto k = static_cast<std::size_t>(matrix.offsets[i]);
         k < static_cast<std::size_t>(matrix.offsets[i + 1]); ++k) {
      sum += x[i] * matrix.values[k] * x[static_cast<std::size_t>(matrix.columns[k])];
    }
  }
  return sum;
}

template <class Check>
void for_meshes(const Check& check) {
  for_skins(20, [&](const PreparedSkin& skin) {
    check(make_mesh(skin, {.sizing = sizing_for(0.2), .has_safety_net = false}).mesh);
  });
}

}  // namespace

TEST_CASE("rows of the Laplacian are sorted, add up to nothing, and it is symmetric to the bit") {
  for_meshes([](const IndexedMesh& mesh) {
    const SparseMatrix matrix = geometry::cotangent_laplacian(mesh);
    REQUIRE(matrix.offsets.size() == mesh.positions.size() + 1);
    REQUIRE(matrix.offsets.back() == static_cast<std::int32_t>(matrix.values.size()));
    CHECK(matrix.values.size() == mesh.positions.size() + 3 * mesh.triangles.size());
    for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(matrix.offsets.size()); ++i) {
      const auto begin = static_cast<std::size_t>(matrix.offsets[static_cast<std::size_t>(i)]);
      const auto end = static_cast<std::size_t>(matrix.offsets[static_cast<std::size_t>(i) + 1]);
      double sum = 0;
      bool is_sorted = true, is_symmetric = true;
      for (std::size_t k = begin; k < end; ++k) {
        sum += matrix.values[k];
        is_sorted &= k == begin || matrix.columns[k - 1] < matrix.columns[k];
        is_symmetric &= entry(matrix, matrix.columns[k], i) == matrix.values[k];
      }
      CHECK(std::abs(sum) <= 1e-14 * entry(matrix, i, i));
      CHECK(is_sorted);
      CHECK(is_symmetric);
    }
  });
}

TEST_CASE("x^T L x is the Dirichlet energy, triangle by triangle") {
  Random random(7);
  for_meshes([&](const IndexedMesh& mesh) {
    std::vector<double> x(mesh.positions.size());
    std::ranges::generate(x, [&] { return random.between(-1, 1); });
    const double energy = energy_by_gradients(mesh, x);
    CHECK(energy_by_matrix(geometry::cotangent_laplacian(mesh), x) ==
          doctest::Approx(energy).epsilon(1e-12));
  });
}

TEST_CASE("a coordinate's energy on a plane is the plane's area, whatever the triangles") {
  const IndexedMesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {1, 2, 0}},
                         {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  const SparseMatrix matrix = geometry::cotangent_laplacian(mesh);
  CHECK(energy_by_matrix(matrix, {0, 4, 4, 0, 1}) == doctest::Approx(12));
  CHECK(energy_by_matrix(matrix, {1, 1, 1, 1, 1}) == doctest::Approx(0));
}

TEST_CASE("lumped masses add up to the area") {
  for_meshes([](const IndexedMesh& mesh) {
    const std::vector<double> mass = geometry::lumped_mass(mesh);
    CHECK(std::accumulate(mass.begin(), mass.end(), 0.0) ==
          doctest::Approx(geometry::measure_shape(mesh).area).epsilon(1e-12));
    CHECK(std::ranges::min(mass) > 0);
  });
}

TEST_CASE("a mesh without triangles has a Laplacian of zeros, one without vertices none") {
  const SparseMatrix lonely = geometry::cotangent_laplacian({{Point(1, 2, 3)}, {}});
  CHECK(lonely.offsets == std::vector<std::int32_t>{0, 1});
  CHECK(lonely.values == std::vector<double>{0});
  CHECK(geometry::cotangent_laplacian({}).offsets == std::vector<std::int32_t>{0});
}

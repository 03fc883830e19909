#pragma once

#include "geometry/regular_triangulation.h"
#include "tests/support/test.h"

namespace morskin::support {

using namespace geometry;

using Points = std::vector<WeightedPoint>;

inline WeightedPoint unweighted(double x, double y, double z) { return {{x, y, z}, 0}; }

inline Points random_points(unsigned seed, std::size_t count, double largest_weight) {
  Random random(seed);
  Points points(count);
  for (WeightedPoint& p : points) {
    for (int k = 0; k < 3; ++k) p.position[k] = random.uniform();
    p.weight = largest_weight * random.uniform();
  }
  return points;
}

/// Whole coordinates up to `range`: full of ties, duplicates and flat subsets.
inline Points whole_points(unsigned seed, std::size_t count, int range) {
  Random random(seed);
  Points points(count);
  for (WeightedPoint& p : points) {
    for (int k = 0; k < 3; ++k) p.position[k] = random.whole(0, range);
    p.weight = random.whole(0, range);
  }
  return points;
}

inline Points lattice(int nx, int ny, int nz, double step = 1) {
  Points points;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) points.push_back(unweighted(step * i, step * j, step * k));
    }
  }
  return points;
}

template <std::size_t Size>
std::array<AtomId, Size - 1> without(const std::array<AtomId, Size>& simplex, std::size_t corner) {
  std::array<AtomId, Size - 1> rest;
  std::copy_if(simplex.begin(), simplex.end(), rest.begin(),
               [&](AtomId id) { return id != simplex[corner]; });
  return rest;
}

template <std::size_t Size>
bool is_sorted_complex(const std::vector<std::array<AtomId, Size>>& simplices) {
  const auto ascends = [](const auto& simplex) {
    return std::adjacent_find(simplex.begin(), simplex.end(), std::greater_equal<>()) ==
           simplex.end();
  };
  return std::all_of(simplices.begin(), simplices.end(), ascends) &&
         std::adjacent_find(simplices.begin(), simplices.end(), std::greater_equal<>()) ==
             simplices.end();
}

/// What holds for every input: arrays sorted, faces found where they are said to be, every face of
/// lower dimension a face of one above, Euler characteristic 1, no atom lost.
inline void check_complex(const Points& points, const RegularTriangulation& t) {
  CHECK(std::is_sorted(t.vertices.begin(), t.vertices.end()));
  CHECK(std::is_sorted(t.hidden.begin(), t.hidden.end()));
  CHECK(is_sorted_complex(t.edges));
  CHECK(is_sorted_complex(t.triangles));
  CHECK(is_sorted_complex(t.tetrahedra));
  REQUIRE(t.triangle_edges.size() == t.triangles.size());
  REQUIRE(t.tetrahedron_triangles.size() == t.tetrahedra.size());
  std::vector<int> edge_uses(t.edges.size(), 0);
  std::vector<int> triangle_uses(t.triangles.size(), 0);
  bool places_are_right = true;
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      places_are_right &= t.edges[t.triangle_edges[i][k]] == without(t.triangles[i], k);
      ++edge_uses[t.triangle_edges[i][k]];
    }
  }
  for (std::size_t i = 0; i < t.tetrahedra.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      places_are_right &= t.triangles[t.tetrahedron_triangles[i][k]] == without(t.tetrahedra[i], k);
      ++triangle_uses[t.tetrahedron_triangles[i][k]];
    }
  }
  CHECK(places_are_right);
  if (t.dimension >= 2) CHECK(std::count(edge_uses.begin(), edge_uses.end(), 0) == 0);
  if (t.dimension == 3) {
    CHECK(std::all_of(triangle_uses.begin(), triangle_uses.end(),
                      [](int uses) { return uses == 1 || uses == 2; }));
  }
  std::vector<AtomId> atoms = t.vertices;
  atoms.insert(atoms.end(), t.hidden.begin(), t.hidden.end());
  std::sort(atoms.begin(), atoms.end());
  CHECK(atoms.size() == points.size());
  CHECK(std::adjacent_find(atoms.begin(), atoms.end()) == atoms.end());
  const auto count = [](const auto& simplices) { return static_cast<long>(simplices.size()); };
  CHECK(count(t.vertices) - count(t.edges) + count(t.triangles) - count(t.tetrahedra) ==
        (points.empty() ? 0 : 1));
}

inline RegularTriangulation checked_triangulation(const Points& points) {
  RegularTriangulation t = regular_triangulation(points);
  check_complex(points, t);
  return t;
}

}  // namespace morskin::support

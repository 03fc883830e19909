#include "skin/mixed_complex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "geometry/error.h"
#include "skin/exact_vectors.h"

namespace morskin::skin {

namespace {

using geometry::RegularTriangulation;

constexpr std::size_t most_walls = 0xFFFFFFFFU;  // places in them have 32 bits

/// A product of vectors that is this much smaller than the product of their lengths has lost too
/// many bits to cancellation, and is computed again exactly. Doubles keep 53 - 6 bits above it,
/// long doubles 64 - 10; a few more go into rounding each factor.
constexpr double flat_for_double = 0x1p-6;
constexpr long double flat_for_wide = 0x1p-10L;

Wide wide(const Vector& v) { return v.cast<long double>(); }

/// Half the difference of powers that the orthocentre must make up along the edge from a to b.
long double edge_load(const WeightedPoint& a, const WeightedPoint& b) {
  const Wide e = wide(b.position) - wide(a.position);
  return (e.squaredNorm() + static_cast<long double>(a.weight) - b.weight) / 2;
}

/// A patch about the orthocentre a + offset: w = w_a - |offset|^2.
Patch patch_about(const WeightedPoint& a, const Wide& offset, const Vector& axis, double sign) {
  Patch patch;
  patch.centre = (wide(a.position) + offset).cast<double>();
  patch.axis = axis;
  patch.sign = sign;
  patch.half_weight =
      static_cast<double>((static_cast<long double>(a.weight) - offset.squaredNorm()) / 2);
  return patch;
}

Patch edge_patch(const WeightedPoint& a, const WeightedPoint& b) {
  const Wide e = wide(b.position) - wide(a.position);
  return patch_about(a, e * (edge_load(a, b) / e.squaredNorm()), e.normalized().cast<double>(), +1);
}

/// Twice edge_load.
Expansion exact_load(const WeightedPoint& a, const WeightedPoint& b) {
  const ExactVector e(a.position, b.position);
  return e.dot(e) + Expansion::difference(a.weight, b.weight);
}

Patch flat_triangle_patch(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  const ExactVector e(a.position, b.position), f(a.position, c.position);
  const ExactVector n = e.cross(f);
  const ExactVector sum = exact_load(a, b) * f.cross(n) + exact_load(a, c) * n.cross(e);
  const Wide offset = sum.rounded() / (2 * rounded(n.dot(n)));
  return patch_about(a, offset, n.rounded().normalized().cast<double>(), -1);
}

Patch flat_tetrahedron_patch(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                             const WeightedPoint& d) {
  const ExactVector e(a.position, b.position), f(a.position, c.position), g(a.position, d.position);
  const ExactVector sum =
      exact_load(a, b) * f.cross(g) + exact_load(a, c) * g.cross(e) + exact_load(a, d) * e.cross(f);
  const Wide offset = sum.rounded() / (2 * rounded(e.dot(f.cross(g))));
  return patch_about(a, offset, Vector::Zero(), -1);
}

Patch triangle_patch(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  const Wide e = wide(b.position) - wide(a.position), f = wide(c.position) - wide(a.position);
  const Wide n = e.cross(f);
  if (n.norm() < flat_for_wide * e.norm() * f.norm()) return flat_triangle_patch(a, b, c);
  const long double p = edge_load(a, b), q = edge_load(a, c);
  const Wide offset = (p * f.cross(n) + q * n.cross(e)) / n.squaredNorm();
  return patch_about(a, offset, n.normalized().cast<double>(), -1);
}

Patch tetrahedron_patch(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                        const WeightedPoint& d) {
  const Wide e = wide(b.position) - wide(a.position), f = wide(c.position) - wide(a.position),
             g = wide(d.position) - wide(a.position);
  const long double volume = e.dot(f.cross(g));
  if (std::abs(volume) < flat_for_wide * e.norm() * f.norm() * g.norm()) {
    return flat_tetrahedron_patch(a, b, c, d);
  }
  const Wide offset =
      (edge_load(a, b) * f.cross(g) + edge_load(a, c) * g.cross(e) + edge_load(a, d) * e.cross(f)) /
      volume;
  return patch_about(a, offset, Vector::Zero(), -1);
}

/// The vertex of a simplex that its k-th facet lacks, seen from that facet: the unit direction
/// orthogonal to the facet.
template <std::size_t N>
Vector direction_off_facet(std::span<const WeightedPoint> points,
                           const std::array<AtomId, N>& simplex, std::size_t k) {
  std::array<Vector, N> p;
  for (std::size_t i = 0; i < N; ++i) p[i] = points[simplex[(k + 1 + i) % N].index()].position;
  const Vector& apex = p[N - 1];
  if constexpr (N == 2) {
    return (apex - p[0]).normalized();
  } else if constexpr (N == 3) {
    const Vector e = (p[1] - p[0]).normalized();
    const Vector n = e.cross(apex - p[0]);
    if (n.norm() < flat_for_double * (apex - p[0]).norm()) {
      const ExactVector exact_e(p[0], p[1]);
      const Wide exact_n = exact_e.cross(ExactVector(p[0], apex)).rounded();
      return exact_n.cross(exact_e.rounded()).normalized().template cast<double>();
    }
    return n.cross(e).normalized();
  } else {
    const Vector e = p[1] - p[0], f = p[2] - p[0];
    const Vector n = e.cross(f);
    const double height = n.dot(apex - p[0]);
    const bool is_flat = n.norm() < flat_for_double * e.norm() * f.norm() ||
                         std::abs(height) < flat_for_double * n.norm() * (apex - p[0]).norm();
    if (is_flat) {
      const ExactVector exact_n = ExactVector(p[0], p[1]).cross(ExactVector(p[0], p[2]));
      const Vector unit = exact_n.rounded().normalized().template cast<double>();
      const bool is_behind =
          exact_n.dot(ExactVector(p[0], apex)).sign() == geometry::Sign::Negative;
      return is_behind ? Vector(-unit) : unit;
    }
    return height < 0 ? Vector(-n.normalized()) : Vector(n.normalized());
  }
}

}  // namespace

MixedComplex::MixedComplex(std::span<const WeightedPoint> points,
                           const RegularTriangulation& triangulation) {
  const std::array sizes{triangulation.vertices.size(), triangulation.edges.size(),
                         triangulation.triangles.size(), triangulation.tetrahedra.size()};
  // A wall of either cell for each simplex and facet of it; there are always more walls than cells.
  const std::size_t walls = 2 * (2 * sizes[1] + 3 * sizes[2] + 4 * sizes[3]);
  geometry::require_room(walls, most_walls, "walls of the mixed complex");
  for (std::size_t d = 0; d < 4; ++d) {
    first_cell_[d + 1] = first_cell_[d] + static_cast<std::uint32_t>(sizes[d]);
  }
  double largest = 0;
  for (const AtomId a : triangulation.vertices) {
    const WeightedPoint& p = points[a.index()];
    largest = std::max(largest, p.position.cwiseAbs().maxCoeff() + std::sqrt(std::abs(p.weight)));
  }
  wall_tolerance_ = std::ldexp(largest, -42);
  build_patches(points, triangulation);
  build_walls(points, triangulation);
}

int MixedComplex::dimension(CellId cell) const {
  int d = 0;
  while (cell.value >= first_cell_[static_cast<std::size_t>(d) + 1]) ++d;
  return d;
}

void MixedComplex::build_patches(std::span<const WeightedPoint> points,
                                 const RegularTriangulation& triangulation) {
  const auto at = [&](AtomId a) -> const WeightedPoint& { return points[a.index()]; };
  patches_.reserve(first_cell_[4]);
  for (const AtomId a : triangulation.vertices) {
    patches_.push_back(patch_about(at(a), Wide::Zero(), Vector::Zero(), +1));
  }
  for (const auto& s : triangulation.edges) patches_.push_back(edge_patch(at(s[0]), at(s[1])));
  for (const auto& s : triangulation.triangles) {
    patches_.push_back(triangle_patch(at(s[0]), at(s[1]), at(s[2])));
  }
  for (const auto& s : triangulation.tetrahedra) {
    patches_.push_back(tetrahedron_patch(at(s[0]), at(s[1]), at(s[2]), at(s[3])));
  }
}

void MixedComplex::build_walls(std::span<const WeightedPoint> points,
                               const RegularTriangulation& triangulation) {
  std::vector<std::uint32_t> vertex_of_atom(points.size(), 0);
  for (std::uint32_t v = 0; v < triangulation.vertices.size(); ++v) {
    vertex_of_atom[triangulation.vertices[v].index()] = v;
  }
  // Visits each pair (facet cell, simplex cell, unit direction from one to the other).
  const auto for_each_incidence = [&](auto visit) {
    for (std::size_t s = 0; s < triangulation.edges.size(); ++s) {
      const auto& simplex = triangulation.edges[s];
      for (std::size_t k = 0; k < 2; ++k) {
        visit(cell(0, vertex_of_atom[simplex[1 - k].index()]), cell(1, s),
              [&] { return direction_off_facet(points, simplex, k); });
      }
    }
    for (std::size_t s = 0; s < triangulation.triangles.size(); ++s) {
      for (std::size_t k = 0; k < 3; ++k) {
        visit(cell(1, triangulation.triangle_edges[s][k]), cell(2, s),
              [&] { return direction_off_facet(points, triangulation.triangles[s], k); });
      }
    }
    for (std::size_t s = 0; s < triangulation.tetrahedra.size(); ++s) {
      for (std::size_t k = 0; k < 4; ++k) {
        visit(cell(2, triangulation.tetrahedron_triangles[s][k]), cell(3, s),
              [&] { return direction_off_facet(points, triangulation.tetrahedra[s], k); });
      }
    }
  };
  first_wall_.assign(patches_.size() + 1, 0);
  for_each_incidence([&](CellId facet, CellId simplex, auto) {
    ++first_wall_[facet.index() + 1];
    ++first_wall_[simplex.index() + 1];
  });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  std::vector<std::uint32_t> filled(first_wall_.begin(), first_wall_.end() - 1);
  for_each_incidence([&](CellId facet, CellId simplex, auto direction) {
    const Vector normal = direction();
    const Point middle = (patch(facet).centre + patch(simplex).centre) / 2;
    const double offset = normal.dot(middle);
    walls_[filled[facet.index()]++] = {normal, offset, simplex};
    walls_[filled[simplex.index()]++] = {-normal, -offset, facet};
  });
}

}  // namespace morskin::skin

#include "refine/certificate.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/mesh_shape.h"
#include "geometry/parallel.h"
#include "refine/candidate_grid.h"
#include "refine/located_vertices.h"
#include "refine/restricted_delaunay.h"
#include "refine/triangle_geometry.h"
#include "refine/tube.h"

namespace morskin::refine {

namespace {

using geometry::IndexedMesh;
using skin::CellId;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

bool is_single_precision(const IndexedMesh& mesh) {
  return std::ranges::all_of(mesh.positions, [](const Point& p) {
    return std::abs(p.x()) <= FLT_MAX && std::abs(p.y()) <= FLT_MAX && std::abs(p.z()) <= FLT_MAX &&
           is_float(p.x()) && is_float(p.y()) && is_float(p.z());
  });
}

/// The work of certify(), one claim after the other; the first that breaks is the reason.
class Certifier {
 public:
  Certifier(const IndexedMesh& mesh, std::span<const SurfacePoint> points,
            const skin::SkinSurface& skin, const Sizing& sizing, Certificate& certificate)
      : mesh_(mesh), skin_(skin), sizing_(sizing), out_(certificate), points_(points) {}

  void run(const skin::DualComplex& expected, unsigned threads) {
    out_.vertices = mesh_.positions.size();
    out_.triangles = mesh_.triangles.size();
    out_.expected_euler_characteristic = expected.skin_euler_characteristic();
    out_.expected_components = expected.skin_components();
    out_.expected_genus = static_cast<long>(expected.skin_genus());
    prove(threads);
  }

 private:
  void prove(unsigned threads) {
    if (mesh_.triangles.empty()) return fail(Claim::Manifold, "the mesh has no triangles");
    geometry::MeshOrDefect built;
    // Where the vertices lie needs no connectivity, and the other way round.
    const auto look_at_places = [&] {
      if (points_.empty()) points_ = located_ = locate_vertices(mesh_, skin_);
      out_.is_single_precision = is_single_precision(mesh_);
      check_vertices();
      check_triangles();
    };
    const auto look_at_connectivity = [&] {
      built = geometry::closed_mesh(mesh_.positions.size(), mesh_.triangles);
      if (!built.defect) parts_ = geometry::components(built.mesh);
      measure_shape();
    };
    geometry::do_both(threads, look_at_places, look_at_connectivity);
    surface_ = std::move(built.mesh);
    if (built.defect) {
      out_.reason.clear();  // the first claim is the first reason
      fail(Claim::Manifold, "not a closed oriented 2-manifold: " + *built.defect);
    } else {
      const auto look_at_covering = [&] {
        check_covering_degree();
        compare_counts();
      };
      const auto look_at_balls = [&] {
        out_.restricted_delaunay_violations =
            local_delaunay_violations(mesh_, surface_, skin_, points_);
      };
      geometry::do_both(threads, look_at_covering, look_at_balls);
    }
    out_.is_homeomorphic = out_.reason.empty();
    if (out_.reason.empty() && out_.violations_L + out_.violations_U > 0) {
      out_.reason = std::to_string(out_.violations_L) + " edges break [L], " +
                    std::to_string(out_.violations_U) + " triangles break [U]";
    }
    out_.certified = out_.reason.empty();
  }

  void fail(Claim claim, const std::string& reason) {
    std::string& first = out_.broken[static_cast<std::size_t>(claim)];
    if (first.empty()) first = reason;
    if (out_.reason.empty()) out_.reason = reason;
  }
  /// The first element that breaks [L] or [U]; no reason against the homeomorphism.
  void note(Claim claim, const std::string& element, double ratio) {
    out_.broken[static_cast<std::size_t>(claim)] =
        element + " has " + number(ratio) + " times its bound";
  }
  const Point& position(std::uint32_t v) const { return mesh_.positions[v]; }

  /// Angles, area and volume need no connectivity.
  void measure_shape();
  /// Each vertex's distance to the skin.
  void check_vertices();
  /// [L], [U], and the conditions c1 and c2 of the theorem.
  void check_triangles();
  /// c3: at one vertex of every component, one sheet of mesh over the skin.
  void check_covering_degree();
  void fail_to_show_degree(std::size_t component);
  void compare_counts();

  bool turns_once(VertexId v) const;
  bool may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const;
  /// (c1) and (c2) of a triangle with these corners, whose |G| is at most a share of rho^2.
  TubeProof prove(const std::array<const SurfacePoint*, 3>& p, const Circumcircle& circle) const {
    const double most_rho = std::max({p[0]->length_scale, p[1]->length_scale, p[2]->length_scale});
    return prove_tube(skin_, p, circle, largest_residual_ * most_rho * most_rho);
  }

  const IndexedMesh& mesh_;
  const skin::SkinSurface& skin_;
  const Sizing sizing_;
  Certificate& out_;
  geometry::SurfaceMesh surface_;
  geometry::Components parts_;
  std::vector<SurfacePoint> located_;  ///< unless they were given
  std::span<const SurfacePoint> points_;
  double largest_residual_ = 0;  ///< of |G| over rho^2 at a vertex
  /// From a corner to all that the flow makes of its triangle, at most, over the length scale
  /// there; but for the triangles listed apart, for which it is more than `most_reach`.
  double reach_ = 0;
  static constexpr double most_reach = 0.8;
  struct FarReaching {
    std::uint32_t triangle;
    double from_first_corner;  ///< Angstrom
  };
  std::vector<FarReaching> far_reaching_;
};

void Certifier::measure_shape() {
  const geometry::MeshShape shape = geometry::measure_shape(mesh_);
  out_.area = shape.area;
  out_.volume = shape.volume;
  out_.min_angle_deg = shape.min_angle_deg;
  out_.max_angle_deg = shape.max_angle_deg;
}

void Certifier::check_vertices() {
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const double rho = points_[v].length_scale;
    // |G| / 2 rho is the distance to first order; off by G / rho^2 of itself.
    const double g = std::abs(skin_.complex().patch(points_[v].cell).value(mesh_.positions[v]));
    out_.max_distance_to_skin = std::max(out_.max_distance_to_skin, g / (2 * rho));
    out_.max_relative_distance_to_skin =
        std::max(out_.max_relative_distance_to_skin, g / (2 * rho * rho));
    // A hundred times what the mesher leaves: room for another program's last digits, far below
    // what the theorem needs. Rounding to floats moves a vertex by at most 2^-24 of its distance d
    // from the origin, and G by 2 rho d + d^2.
    const double moved = out_.is_single_precision ? std::ldexp(mesh_.positions[v].norm(), -24) : 0;
    largest_residual_ = std::max(largest_residual_, g / (rho * rho));
    if (!(g <= 100 * skin_.residual_bound(rho) + (2 * rho + moved) * moved)) {
      fail(Claim::OnSkin, "vertex " + std::to_string(v) + " lies " + number(g / (2 * rho)) +
                              " Angstrom off the skin");
    }
  }
}

void Certifier::check_triangles() {
  out_.worst_L = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& corner = mesh_.triangles[t];
    const std::array p{&points_[corner[0]], &points_[corner[1]], &points_[corner[2]]};
    const Circumcircle circle = circumcircle(p[0]->position, p[1]->position, p[2]->position);
    const double rho = std::min({p[0]->length_scale, p[1]->length_scale, p[2]->length_scale});
    const double u = sizing_.triangle_ratio(circle.radius, rho);
    out_.worst_U = std::max(out_.worst_U, u);
    if (!(u < 1) && out_.violations_U++ == 0) {
      note(Claim::U, "triangle " + std::to_string(t), u);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const SurfacePoint &a = *p[(k + 1) % 3], &b = *p[(k + 2) % 3];
      if (corner[(k + 1) % 3] > corner[(k + 2) % 3]) continue;  // each edge from one side
      const double l = sizing_.edge_ratio(a, b);
      out_.worst_L = std::min(out_.worst_L, l);
      if (!(l > 1) && out_.violations_L++ == 0) {
        note(Claim::L,
             "edge " + std::to_string(corner[(k + 1) % 3]) + "-" +
                 std::to_string(corner[(k + 2) % 3]),
             l);
      }
    }
    const TubeProof proof = prove(p, circle);
    if (!proof.is_upright) {
      fail(Claim::Upright,
           "triangle " + std::to_string(t) + " does not face the way the skin does");
    }
    if (!proof.is_in_tube) {
      fail(Claim::Tube, "triangle " + std::to_string(t) +
                            " is too big for its length scale to be proved near the skin");
    }
    // A point of the triangle lies within R of a corner.
    const double reach = (circle.radius + proof.way) / rho;
    if (reach > most_reach) {
      far_reaching_.push_back({static_cast<std::uint32_t>(t), 2 * circle.radius + proof.way});
    } else {
      reach_ = std::max(reach_, reach);
    }
  }
}

/// Whether the triangles round v, seen along its normal, go round it once and all the same way.
bool Certifier::turns_once(VertexId v) const {
  const SurfacePoint& p = points_[v.index()];
  double sum = 0;
  bool is_forward = true;
  surface_.for_each_outgoing(v, [&](HalfEdgeId h) {
    Vector e = position(surface_.target(h).value) - p.position;
    Vector f = position(surface_.apex(h).value) - p.position;
    e -= e.dot(p.normal) * p.normal;
    f -= f.dot(p.normal) * p.normal;
    const double angle = std::atan2(e.cross(f).dot(p.normal), e.dot(f));
    is_forward = is_forward && angle > 0;
    sum += angle;
  });
  return is_forward && std::abs(sum - 2 * M_PI) < 1;  // a whole number of turns, so 1 is apart
}

double squared_distance_to_triangle(const Point& x, const Point& a, const Point& b,
                                    const Point& c) {
  const Vector n = (b - a).cross(c - a);
  const std::array corner{&a, &b, &c};
  bool is_over = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = *corner[k], &q = *corner[(k + 1) % 3];
    const Vector e = q - p, d = x - p;
    is_over = is_over && e.cross(d).dot(n) >= 0;
    const double s = std::clamp(e.dot(d) / e.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (d - s * e).squaredNorm());
  }
  const double height = n.dot(x - a);
  return is_over ? height * height / n.squaredNorm() : least;
}

/// Whether the flow may carry a point p of a triangle to the vertex v, which is not among its
/// corners. |G(p)| is at most R^2, and |N| is rho at v. Where the way from v has become s long, N
/// has changed by s at most, so the way's direction differs from v's normal by a sine of s / rho:
/// it ends no farther than s^2 / (2 rho) off the line along that normal.
bool Certifier::may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const {
  const auto& [a, b, c] = triangle;
  const std::array corners{&points_[a], &points_[b], &points_[c]};
  const Circumcircle circle = circumcircle(position(a), position(b), position(c));
  const double most_rho =
      std::max({points_[a].length_scale, points_[b].length_scale, points_[c].length_scale});
  const double g = circle.radius * circle.radius + largest_residual_ * most_rho * most_rho;
  const SurfacePoint& at = points_[v.index()];
  constexpr double room = 1 + 1e-6;  // well above the rounding of either side
  double way = longest_way(at.length_scale, g);
  const double d2 =
      squared_distance_to_triangle(position(v.value), position(a), position(b), position(c));
  if (d2 > way * way * room) return false;
  way = std::min(way, prove(corners, circle).way);
  if (d2 > way * way * room) return false;
  const double aside = way * way / (2 * at.length_scale);
  const auto along_skin = [&](std::uint32_t corner) -> Point {
    const Vector d = position(corner) - position(v.value);
    return d - d.dot(at.normal) * at.normal;
  };
  const double d2_aside =
      squared_distance_to_triangle(Point::Zero(), along_skin(a), along_skin(b), along_skin(c));
  return !(d2_aside > aside * aside * room);
}

void Certifier::check_covering_degree() {
  out_.components = parts_.count;
  // A few candidates per component, from all over it: where the mesh is thin beside its length
  // scale a neighbour's triangle may pass through the ball, and another vertex shows the degree.
  constexpr std::size_t most_candidates = 16;
  std::vector<std::vector<VertexId>> candidates(parts_.count);
  std::vector<std::uint32_t> size(parts_.count, 0), seen(parts_.count, 0);
  for (const auto part : parts_.of_triangle) ++size[part];
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto part = parts_.of_triangle[t];
    auto& list = candidates[part];
    const VertexId v{mesh_.triangles[t][0]};
    if (seen[part]++ % (size[part] / most_candidates + 1) != 0) continue;
    if (std::find(list.begin(), list.end(), v) == list.end() && turns_once(v)) list.push_back(v);
  }
  std::vector<char> is_free(mesh_.positions.size(), 0);
  CandidateGrid grid(std::max(reach_, 1e-3));
  std::size_t count = 0;
  for (const auto& list : candidates) {
    for (const VertexId v : list) {
      is_free[v.index()] = 1;
      grid.add(position(v.value), points_[v.index()].length_scale, v);
    }
    count += list.size();
  }
  const auto look_at = [&](const std::array<std::uint32_t, 3>& t, VertexId v) {
    const bool is_own = t[0] == v.value || t[1] == v.value || t[2] == v.value;
    if (!is_own && is_free[v.index()] && may_cover(t, v)) is_free[v.index()] = 0;
  };
  // Few, if any: each is held against every candidate.
  constexpr std::size_t most_looks = 1'000'000'000;
  if (far_reaching_.size() > most_looks / std::max<std::size_t>(count, 1)) {
    return fail_to_show_degree(0);
  }
  for (const auto& [t, from_first_corner] : far_reaching_) {
    const Point& corner = position(mesh_.triangles[t][0]);
    const double farthest = 1.01 * from_first_corner;
    for (const auto& list : candidates) {
      for (const VertexId v : list) {
        if (!((position(v.value) - corner).squaredNorm() > farthest * farthest)) {
          look_at(mesh_.triangles[t], v);
        }
      }
    }
  }
  for (std::uint32_t a = 0; a < mesh_.positions.size(); ++a) {
    grid.for_each_near(position(a), points_[a].length_scale, [&](VertexId v) {
      const double farthest = 1.01 * reach_ * points_[a].length_scale;
      if ((position(a) - position(v.value)).squaredNorm() > farthest * farthest) return;
      surface_.for_each_outgoing(VertexId{a}, [&](HalfEdgeId h) {
        look_at({a, surface_.target(h).value, surface_.apex(h).value}, v);
      });
    });
  }
  out_.covering_degree_ok = true;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool shown = std::any_of(candidates[i].begin(), candidates[i].end(),
                                   [&](VertexId v) { return is_free[v.index()] != 0; });
    if (!shown) return fail_to_show_degree(i);
  }
}

void Certifier::fail_to_show_degree(std::size_t component) {
  out_.covering_degree_ok = false;
  fail(Claim::Degree,
       "component " + std::to_string(component) + " could not be shown to cover the skin once");
}

void Certifier::compare_counts() {
  const long v = static_cast<long>(out_.vertices), t = static_cast<long>(out_.triangles);
  out_.euler_characteristic = v - t / 2;
  out_.genus = static_cast<long>(out_.components) - out_.euler_characteristic / 2;
  std::string differences;
  const auto compare = [&](const char* what, long is, long should) {
    if (is == should) return;
    differences += (differences.empty() ? "" : "; ") + std::string(what) + " is " +
                   std::to_string(is) + ", the skin's is " + std::to_string(should);
  };
  compare("the number of components", static_cast<long>(out_.components),
          static_cast<long>(out_.expected_components));
  compare("the Euler characteristic", out_.euler_characteristic,
          out_.expected_euler_characteristic);
  compare("the genus", out_.genus, out_.expected_genus);
  if (!differences.empty()) fail(Claim::Counts, differences);
}

}  // namespace

Certificate certify(const IndexedMesh& mesh, const skin::SkinSurface& skin,
                    const skin::DualComplex& expected, const Sizing& sizing, unsigned threads) {
  return certify(mesh, {}, skin, expected, sizing, threads);
}

Certificate certify(const IndexedMesh& mesh, std::span<const SurfacePoint> points,
                    const skin::SkinSurface& skin, const skin::DualComplex& expected,
                    const Sizing& sizing, unsigned threads) {
  Certificate certificate;
  Certifier(mesh, points, skin, sizing, certificate).run(expected, threads);
  return certificate;
}

}  // namespace morskin::refine

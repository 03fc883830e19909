#include "refine/restricted_delaunay.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <thread>

#include "geometry/kd_tree.h"

namespace morskin::refine {

namespace {

using geometry::IndexedMesh;

/// What is known of a triangle's surface ball without looking for its centre x = o + s n on the
/// line through the circumcentre o: that |s| <= reach. For p at height h over the triangle's plane
///
///     (squared radius) - |p - x|^2 = R^2 - |p - o|^2 + 2 s h,
///
/// linear in s, so that only vertices with |R^2 - |p - o|^2| <= 2 reach |h| need x itself.
struct Pencil {
  Circumcircle circle;
  Vector normal;  ///< unit
  double reach;   ///< Angstrom
};

/// With N = grad G / 2, which is 1-Lipschitz, and a corner a on the skin to within |G(a)| = g:
///
///     |G(o)| <= g + 2 |N(a).(o - a)| + R^2 <= g + 2 t R + R^2,     t^2 = |N(a)|^2 - (N(a).n)^2,
///     N(o).n >= N(a).n - R =: m,      |G(o + s n) - G(o) - 2 s N(o).n| <= s^2,
///
/// so G changes its sign on |s| <= m - sqrt(m^2 - |G(o)|) if m^2 > |G(o)|, and once, since N.n > 0
/// as long as |s| < m. The corner whose normal is nearest to n gives the best bound.
/// @return nothing where the bound does not hold.
std::optional<Pencil> pencil(const skin::SkinSurface& skin,
                             const std::array<const SurfacePoint*, 3>& at,
                             const Circumcircle& circle) {
  Pencil result{circle, {}, 0};
  const double R = result.circle.radius;
  result.normal = result.circle.doubled_area / result.circle.doubled_area.norm();
  const SurfacePoint* a = at[0];
  double upright = -1;
  for (const SurfacePoint* p : at) {
    const double cosine = p->normal.dot(result.normal);
    if (!(cosine > upright)) continue;
    upright = cosine;
    a = p;
  }
  const double rho = a->length_scale;
  const double g = std::abs(skin.complex().patch(a->cell).value(a->position));
  const double tilt = rho * std::sqrt(std::max(0.0, 1 - upright * upright));
  const double most = g + (2 * tilt + R) * R;
  const double m = rho * upright - R;
  if (!(m > 0) || !(m * m > most)) return std::nullopt;
  result.reach = most / (m + std::sqrt(m * m - most));
  return result;
}

/// Whether the bound leaves it open that a vertex at d from the circumcentre lies in the ball.
bool may_contain(const Pencil& pencil, const Vector& d) {
  const double R = pencil.circle.radius;
  return R * R - d.squaredNorm() > -2 * pencil.reach * std::abs(d.dot(pencil.normal));
}

/// A squared distance of about r^2 between points with coordinates up to L is off by a few times
/// 2 r u L: a corner's, which defines the ball, and the vertex's. This is 16 u L, Angstrom.
double rounding_of(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Point& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return 16 * std::ldexp(largest, -53);
}

/// How deep p lies in the ball, over its squared radius, if that is beyond rounding.
std::optional<double> depth_in(const SurfaceBall& ball, const Point& p, double rounding) {
  const double intrusion = ball.intrusion(p);
  const double margin =
      least_intrusion * ball.squared_radius + rounding * std::sqrt(ball.squared_radius);
  if (!(intrusion > margin)) return std::nullopt;
  return intrusion / ball.squared_radius;
}

class DelaunayCheck {
 public:
  DelaunayCheck(const IndexedMesh& mesh, const skin::SkinSurface& skin,
                std::span<const SurfacePoint> points, const geometry::KdTree<VertexId>& tree)
      : mesh_(mesh), skin_(skin), points_(points), tree_(tree), rounding_(rounding_of(mesh)) {}

  /// Looks at triangles [begin, end).
  RestrictedDelaunay run(std::size_t begin, std::size_t end, std::size_t listed) const {
    RestrictedDelaunay result;
    for (std::size_t t = begin; t < end; ++t) {
      const auto worst = check(static_cast<std::uint32_t>(t), result);
      if (!worst) continue;
      ++result.violations;
      result.deepest.push_back(*worst);
      if (result.deepest.size() > 2 * listed + 64) keep_deepest(result, listed);
    }
    keep_deepest(result, listed);
    return result;
  }

  static void keep_deepest(RestrictedDelaunay& result, std::size_t listed) {
    std::sort(result.deepest.begin(), result.deepest.end(), [](const auto& a, const auto& b) {
      return a.depth != b.depth ? a.depth > b.depth : a.triangle < b.triangle;
    });
    if (result.deepest.size() > listed) result.deepest.resize(listed);
    if (result.first_undecided.size() > listed) result.first_undecided.resize(listed);
  }

 private:
  std::optional<DelaunayViolation> check(std::uint32_t t, RestrictedDelaunay& result) const;
  const IndexedMesh& mesh_;
  const skin::SkinSurface& skin_;
  std::span<const SurfacePoint> points_;
  const geometry::KdTree<VertexId>& tree_;
  double rounding_;  ///< Angstrom
};

std::optional<DelaunayViolation> DelaunayCheck::check(std::uint32_t t,
                                                      RestrictedDelaunay& result) const {
  const auto& corner = mesh_.triangles[t];
  const auto is_corner = [&](std::uint32_t v) {
    return std::ranges::find(corner, v) != corner.end();
  };
  const std::array at{&points_[corner[0]], &points_[corner[1]], &points_[corner[2]]};
  const Circumcircle circle = circumcircle(at[0]->position, at[1]->position, at[2]->position);
  std::optional<SurfaceBall> ball;
  const auto find_ball = [&] {
    ball = exact_surface_ball(skin_, *at[0], at[1]->position, at[2]->position);
    ++result.exact_balls;
  };
  std::optional<DelaunayViolation> worst;
  const auto ask = [&](std::uint32_t v) {
    if (!ball) find_ball();
    const std::optional<double> d = depth_in(*ball, mesh_.positions[v], rounding_);
    if (d && (!worst || *d > worst->depth)) worst = DelaunayViolation{t, v, *d};
  };
  if (const std::optional<Pencil> p = pencil(skin_, at, circle)) {
    // The ball about o that holds every ball of the pencil.
    const double R = p->circle.radius;
    const double most = p->reach + std::sqrt(R * R + p->reach * p->reach);
    tree_.for_each_within(p->circle.centre, most, [&](const auto& near) {
      const std::uint32_t v = near.id.value;
      if (is_corner(v) || !may_contain(*p, mesh_.positions[v] - p->circle.centre)) return;
      ask(v);
    });
    if (!ball || ball->is_exact) return worst;
  } else {
    find_ball();
    if (ball->is_exact) {
      tree_.for_each_within(ball->centre, std::sqrt(ball->squared_radius), [&](const auto& near) {
        if (!is_corner(near.id.value)) ask(near.id.value);
      });
      return worst;
    }
  }
  ++result.undecided;
  result.first_undecided.push_back(t);
  return std::nullopt;
}

}  // namespace

RestrictedDelaunay restricted_delaunay(const IndexedMesh& mesh, const skin::SkinSurface& skin,
                                       std::span<const SurfacePoint> points, std::size_t listed,
                                       unsigned threads) {
  const geometry::KdTree<VertexId> tree(mesh.positions);
  const DelaunayCheck check(mesh, skin, points, tree);
  const std::size_t parts = std::max(1U, threads);
  std::vector<RestrictedDelaunay> results(parts);
  const auto from = [&](std::size_t part) { return mesh.triangles.size() * part / parts; };
  {
    std::vector<std::jthread> others;
    for (std::size_t part = 1; part < parts; ++part) {
      others.emplace_back(
          [&, part] { results[part] = check.run(from(part), from(part + 1), listed); });
    }
    results[0] = check.run(from(0), from(1), listed);
  }
  RestrictedDelaunay& whole = results[0];
  for (std::size_t part = 1; part < parts; ++part) {
    const RestrictedDelaunay& other = results[part];
    whole.violations += other.violations;
    whole.undecided += other.undecided;
    whole.exact_balls += other.exact_balls;
    whole.deepest.insert(whole.deepest.end(), other.deepest.begin(), other.deepest.end());
    whole.first_undecided.insert(whole.first_undecided.end(), other.first_undecided.begin(),
                                 other.first_undecided.end());
  }
  DelaunayCheck::keep_deepest(whole, listed);
  return whole;
}

std::size_t local_delaunay_violations(const IndexedMesh& mesh, const geometry::SurfaceMesh& surface,
                                      const skin::SkinSurface& skin,
                                      std::span<const SurfacePoint> points) {
  // In shares of R^2. The ball lies within sqrt(R^2 + s^2) + |s| of the circumcentre, less than
  // sqrt(2.25) R as long as |s| <= 0.4 R; where R <= 0.15 rho, |s| is about R^2 / 2 rho < 0.1 R.
  constexpr double far = 2.25, largest_reach = 0.4;
  const double rounding = rounding_of(mesh);
  std::size_t violations = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const std::array at{&points[a], &points[b], &points[c]};
    const Circumcircle circle = circumcircle(at[0]->position, at[1]->position, at[2]->position);
    std::optional<Pencil> bound;
    std::optional<SurfaceBall> ball;
    bool is_entered = false;
    for (std::uint32_t k = 0; k < 3 && !is_entered; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      const Point& p = mesh.positions[surface.apex(surface.twin(h)).index()];
      const Vector d = p - circle.centre;
      if (d.squaredNorm() > far * circle.radius * circle.radius) continue;
      if (!bound) bound = pencil(skin, at, circle);
      if (bound && bound->reach <= largest_reach * circle.radius && !may_contain(*bound, d))
        continue;
      if (!ball) ball = exact_surface_ball(skin, *at[0], at[1]->position, at[2]->position);
      is_entered = ball->is_exact && depth_in(*ball, p, rounding);
    }
    violations += is_entered;
  }
  return violations;
}

}  // namespace morskin::refine

#include "certify/delaunay_filter.h"

#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using certify::DelaunayFilter;
using geometry::HalfEdgeId;
using geometry::TriangleId;
using skin::Vector;
using surface::SurfacePoint;

namespace {

using Corners = std::array<const SurfacePoint*, 3>;

void note(const skin::SkinSurface& skin, DelaunayFilter& filter, TriangleId t, const Corners& p) {
  const double rho = max_length_scale(p);
  filter.note(t, p, certify::TriangleSides(p), skin.residual_bound(rho));
}

/// How deep x lies in the surface ball of a triangle, in shares of its squared radius; nothing
/// where there is no such ball.
std::optional<double> depth(const skin::SkinSurface& skin, const Corners& p,
                            const SurfacePoint& x) {
  const auto ball = certify::exact_surface_ball(skin, *p[0], p[1]->position, p[2]->position);
  if (!ball.is_exact) return std::nullopt;
  return ball.intrusion(x.position) / ball.squared_radius;
}

/// Two triangles on an edge ab, their far corners c on its left and d on its right.
struct Pair {
  SurfacePoint a, b, c, d;
  Corners left() const { return {&a, &b, &c}; }
  Corners right() const { return {&b, &a, &d}; }
};

bool is_certain(const skin::SkinSurface& skin, const Pair& pair) {
  DelaunayFilter filter(2);
  note(skin, filter, TriangleId{0U}, pair.left());
  note(skin, filter, TriangleId{1U}, pair.right());
  return filter.certainly_delaunay(HalfEdgeId{0U}, HalfEdgeId{3U});
}

/// Four points of the skin about a fifth, nearly on one circle: hard to tell which edge is
/// Delaunay.
std::optional<Pair> random_pair(const skin::SkinSurface& skin, const SurfacePoint& x,
                                Random& random) {
  const Vector e = x.normal.unitOrthogonal(), f = x.normal.cross(e);
  const double size = random.between(0.02, 0.3) * x.length_scale;
  const double off_circle = random.uniform() < 0.5 ? 0.2 : 0.02;
  const auto at = [&](double angle) {
    const double r = size * random.between(1 - off_circle, 1 + off_circle);
    return skin.project(x.position + r * (std::cos(angle) * e + std::sin(angle) * f), x.cell);
  };
  const double b_angle = random.between(0.5, 2 * M_PI - 0.5);
  const auto a = at(0), d = at(b_angle * random.uniform()), b = at(b_angle);
  const auto c = at(b_angle + (2 * M_PI - b_angle) * random.uniform());
  if (!a || !b || !c || !d) return std::nullopt;
  return Pair{*a, *b, *c, *d};
}

}  // namespace

TEST_CASE(
    "at an edge proved Delaunay neither far corner lies in the other triangle's surface ball") {
  std::size_t seen = 0, seen_quickly = 0;
  for (const char* file : {"caffeine.xyz", "5tmn_ligand.pdb"}) {
    const auto skin = prepare_skin(molecule(file, skin::Model::Vdw));
    const auto mesh = make_mesh(skin, uncertified());
    Random random(7);
    for (int i = 0; i < 40000; ++i) {
      const std::size_t v = random.below(mesh.cells.size());
      const SurfacePoint x = skin.surface.at(mesh.mesh.positions[v], mesh.cells[v]);
      const auto pair = random_pair(skin.surface, x, random);
      if (!pair) continue;
      const bool is_quick = certify::is_certainly_delaunay(
          pair->left(), pair->d, skin.surface.residual_bound(pair->d.length_scale));
      const bool is_noted = is_certain(skin.surface, *pair);
      if (!is_quick && !is_noted) continue;
      seen_quickly += is_quick;
      seen += is_noted;
      const auto in_left = depth(skin.surface, pair->left(), pair->d);
      const auto in_right = depth(skin.surface, pair->right(), pair->c);
      REQUIRE(in_left.has_value());
      REQUIRE(in_right.has_value());
      CHECK(*in_left < 0);
      CHECK(*in_right < 0);
    }
  }
  CHECK(seen > 8000);
  CHECK(seen_quickly > 2000);
}

TEST_CASE("nearly all edges of a refined mesh are proved Delaunay by their angles") {
  const auto skin = prepare_skin(molecule("caffeine.xyz", skin::Model::Sas));
  const auto mesh = skin_mesh(skin.surface, make_mesh(skin, uncertified()));
  DelaunayFilter filter(mesh.surface.triangle_count());
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    note(skin.surface, filter, TriangleId{t}, {&mesh.at(a), &mesh.at(b), &mesh.at(c)});
  }
  std::size_t open = 0, edges = 0;
  for (std::size_t i = 0; i < 3 * mesh.surface.triangle_count(); ++i) {
    const HalfEdgeId h{i}, twin = mesh.surface.twin(h);
    CHECK(filter.certainly_delaunay(h, twin) == filter.certainly_delaunay(twin, h));
    open += !filter.certainly_delaunay(h, twin);
    ++edges;
  }
  CHECK(20 * open < edges);
}

#pragma once

/// Skins of all scales with good meshes of them, and what holds of any mesh isotopic to a skin.

#include "certify/certificate.h"
#include "certify/tube.h"
#include "geometry/mesh_shape.h"
#include "geometry/self_intersections.h"
#include "tests/support/mutants.h"
#include "tests/support/nasty_sets.h"

namespace morskin::support {

/// A skin and a good mesh of it.
struct Specimen {
  std::string name;
  WeightedPoints points;
  certify::Sizing sizing;
  morskin::PreparedSkin skin;
  IndexedMesh mesh;

  certify::Certificate certify(const IndexedMesh& other) const {
    return certify::certify(other, skin.surface, skin.topology, sizing);
  }
};

inline std::optional<Specimen> specimen(std::string name, const WeightedPoints& points, double C) {
  try {
    morskin::PreparedSkin skin = morskin::prepare_skin(points);
    auto result = morskin::make_mesh(skin, with(sizing_for(C)));
    if (!result.certificate.certified) return std::nullopt;
    return Specimen{std::move(name), points, sizing_for(C), std::move(skin),
                    std::move(result.mesh)};
  } catch (const geometry::RefusedInput&) {
    return std::nullopt;
  }
}

/// Some balls about as large as the scale, now and then with a ball far off.
inline WeightedPoints scaled_balls(Random& random) {
  const double scale = std::pow(10.0, random.between(-7, 6));
  const double offset = random.below(2) == 0 ? 0 : scale * std::pow(10.0, random.between(0, 4));
  const Point shift = offset * random.direction();
  WeightedPoints points;
  for (std::size_t n = 1 + random.below(5); n > 0; --n) {
    points.push_back(
        {shift + scale * random.in_cube(0, 3), 2 * std::pow(scale * random.between(0.5, 1.2), 2)});
  }
  if (random.below(4) == 0) {
    const double far = scale * std::pow(10.0, random.between(0.7, 5));
    points.push_back({shift + far * random.direction(), 2 * scale * scale});
  }
  return points;
}

/// Nearly the same balls: so nearly, or so differently, that the skin may be another.
inline WeightedPoints nearly(WeightedPoints points, Random& random) {
  const double share = std::pow(10.0, -random.between(0, 9));
  const double size = std::sqrt(points[0].weight);
  switch (random.below(4)) {
    case 0:
      for (auto& p : points) p.weight *= 1 + share * random.between(-0.9, 0.9);
      break;
    case 1:
      for (auto& p : points) p.position += share * size * random.direction();
      break;
    case 2:
      points.push_back({points[0].position + 3 * random.uniform() * size * random.direction(),
                        points[0].weight * share});
      break;
    default:
      if (points.size() > 1)
        points.erase(points.begin() + static_cast<long>(random.below(points.size())));
  }
  return points;
}

/// The specimen of a seed: a molecule, balls of any scale, or a nasty set; the skin may be refused,
/// or the mesh be too large for many tries.
inline std::optional<Specimen> specimen(unsigned seed) {
  constexpr std::array molecules{"two_balls.xyzr",    "cube8.xyzr",  "ring12.xyzr",
                                 "shell_hollow.xyzr", "benzene.pdb", "caffeine.xyz"};
  constexpr unsigned kinds = 4;
  Random random(seed);
  const double C = random.between(0.2, 0.38);
  const std::string name = "specimen " + std::to_string(seed);
  switch (seed % kinds) {
    case 0: {
      const char* const file = molecules[random.below(molecules.size())];
      const skin::Model model = all_models[random.below(all_models.size())];
      return specimen(name + ", " + file, molecule(file, model), C);
    }
    case 1: {
      const WeightedPoints points = nasty_set(seed / kinds);
      return points.size() > 12 ? std::nullopt : specimen(name + ", nasty", points, C);
    }
    default:
      return specimen(name + ", balls", scaled_balls(random), C);
  }
}

/// The Euler characteristic of each component, ascending.
inline std::vector<long> euler_characteristics(const IndexedMesh& mesh) {
  std::vector<long> result;
  for (const IndexedMesh& part : parts_of(mesh)) {
    result.push_back(static_cast<long>(part.positions.size()) -
                     static_cast<long>(part.triangles.size() / 2));
  }
  std::ranges::sort(result);
  return result;
}

/// How often a closed mesh winds round a point: the solid angles over 4 pi.
inline double winding_number(const IndexedMesh& mesh, const Point& x) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vector a = (mesh.positions[t[0]] - x).normalized();
    const Vector b = (mesh.positions[t[1]] - x).normalized();
    const Vector c = (mesh.positions[t[2]] - x).normalized();
    sum += std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (2 * M_PI);
}

/// Points that no mesh within the tube contains: |G| > |N|^2, or a critical point. About them the
/// mesh winds as the skin does: once where G < 0, else not.
inline std::vector<std::pair<Point, int>> points_off_the_tube(const Specimen& good,
                                                              Random& random) {
  std::vector<Point> tried;
  for (const auto& p : good.points) tried.push_back(p.position);
  for (const IndexedMesh& part : parts_of(good.mesh)) {
    Point sum = Point::Zero();
    for (const Point& x : part.positions) sum += x / static_cast<double>(part.positions.size());
    tried.push_back(sum);
    for (int i = 0; i < 8; ++i) {
      const Point& x = part.positions[random.below(part.positions.size())];
      tried.push_back(sum + random.between(0, 2) * (x - sum));
    }
  }
  std::vector<std::pair<Point, int>> result;
  for (const Point& x : tried) {
    const auto at = good.skin.surface.enclose(x, good.skin.surface.locate(x, geometry::CellId{0U}));
    const double n = at.half_gradient.norm() + at.error;
    if (std::max(at.low, -at.high) > n * n) result.emplace_back(x, at.high < 0 ? 1 : 0);
  }
  return result;
}

/// Bound on the volume between a proved mesh and the skin, infinite where the corners bound
/// nothing.
///
/// The flow carries a triangle along lines no longer than s, on which |N| is at least n - s. Along
/// N / |N| an area grows at a rate of at most 2 / |N|, so to no more than (n / (n - s))^2 of
/// itself, and sweeps area * n s / (n - s).
inline double volume_bound(const IndexedMesh& mesh, const Specimen& good) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const auto& [a, b, c] = t;
    const auto shape =
        certify::triangle_bounds(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    double rho = std::numeric_limits<double>::infinity(), g = 0;
    for (const std::uint32_t v : t) {
      const Point& x = mesh.positions[v];
      const auto at = good.skin.surface.enclose(x, good.skin.surface.locate(x, {}));
      rho = std::min(rho, at.half_gradient.norm() - at.error);
      g = std::max(g, at.max_value());
    }
    const double n = rho - shape.circumradius;
    const double s = certify::max_flow_path(n, g + shape.circumradius * shape.circumradius);
    const auto corner = geometry::triangle_shape(mesh.positions[a], mesh.positions[b],
                                                 mesh.positions[c], mesh.positions[a]);
    sum += s < n ? corner.area * n * s / (n - s) : std::numeric_limits<double>::infinity();
  }
  return sum;
}

/// What is wrong with a mesh that is called homeomorphic, in words; empty if nothing is.
inline std::string falsehood(const IndexedMesh& mesh, const Specimen& good, Random& random) {
  if (geometry::self_intersections(mesh).count > 0) return "it intersects itself";
  if (euler_characteristics(mesh) != euler_characteristics(good.mesh)) {
    return "its components have other Euler characteristics";
  }
  for (const auto& [x, expected] : points_off_the_tube(good, random)) {
    if (std::abs(winding_number(mesh, x) - expected) > 0.01) return "it winds otherwise";
  }
  constexpr double rounding = 1e-9;
  const auto is = geometry::measure_shape(mesh), should = geometry::measure_shape(good.mesh);
  const double bound = volume_bound(mesh, good) + volume_bound(good.mesh, good);
  if (std::abs(is.volume - should.volume) > bound + rounding * std::pow(should.area, 1.5)) {
    return "its volume is " + std::to_string(is.volume / should.volume) + " of what it should be";
  }
  return {};
}

}  // namespace morskin::support

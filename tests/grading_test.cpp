#include "morskin/grading.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/support/ball_sets.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using geometry::Point;
using surface::SizeField;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<SizeField::Source> random_sources(Random& random, std::size_t count) {
  std::vector<SizeField::Source> sources;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::pow(10, random.between(-3, 1));
    sources.push_back({random.in_cube(-10, 10), size});
    if (i % 7 == 0) sources.push_back({sources.back().position, 2 * size});  // superfluous
  }
  return sources;
}

double least(const std::vector<SizeField::Source>& sources, double slope, const Point& x) {
  double size = infinity;
  for (const auto& s : sources) size = std::min(size, s.size + slope * (s.position - x).norm());
  return size;
}

MeshingOptions graded(double C, std::optional<double> grading) {
  MeshingOptions options{.sizing = {.C = C, .Q = certify::Sizing::quality_for(C)}};
  options.grading = grading;
  return options;
}

}  // namespace

TEST_CASE("a size field allows the least of all its sources, those that do not count left out") {
  for_seeds(60, [](unsigned seed) {
    Random random(seed);
    const auto sources = random_sources(random, 1 + seed * seed / 4);
    const double slope = random.between(0.05, 1);
    const SizeField field(sources, slope);
    CHECK(field.source_count() < sources.size() + (seed < 3));
    for (int k = 0; k < 50; ++k) {
      const Point x = random.in_cube(-20, 20);
      const double expected = least(sources, slope, x);
      CHECK(field.limited(infinity, x) == doctest::Approx(expected).epsilon(1e-12));
      CHECK(field.limited(expected / 2, x) == expected / 2);
    }
  });
}

TEST_CASE("a size field without sources limits nothing") {
  CHECK(SizeField({}, 0.5).limited(3, Point(1, 2, 3)) == 3);
}

TEST_CASE("limited length scales grow by the slope alone, but for the trial's width") {
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    const MeshingOptions options = graded(certify::Sizing::coarsest_C, 0.25);
    const auto field = size_field(skin, options, Run());
    REQUIRE(field);
    const SizedSurface sized(skin.surface, field);
    // Points of the skin that the trial has not seen.
    const MeshResult other = make_mesh(skin, {.sizing = {.C = 0.17}});
    std::vector<surface::SurfacePoint> points;
    for (std::size_t v = 0; v < other.mesh.positions.size(); v += 5) {
      points.push_back(sized.sized(skin.surface.at(other.mesh.positions[v], other.cells[v])));
      const auto again = (*sized).project(points.back().position, points.back().cell);
      REQUIRE(again);
      CHECK(again->length_scale == doctest::Approx(points.back().length_scale).epsilon(1e-6));
    }
    double steepest = 0;
    for (const surface::SurfacePoint& x : points) {
      for (const surface::SurfacePoint& y : points) {
        const double along = field->slope() * (x.position - y.position).norm();
        steepest = std::max(steepest, x.length_scale / (1.5 * y.length_scale + along));
      }
    }
    CHECK(steepest <= 1);
  });
}

TEST_CASE("with a grading edges grow slowly from the short ones, and the mesh is certified") {
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    for (const double C : {0.2, 0.4}) {
      CAPTURE(C);
      MeshingOptions ungraded = graded(C, {});
      ungraded.method = Method::Static;
      const MeshResult free = make_mesh(skin, ungraded);
      std::size_t triangles = free.mesh.triangles.size();
      for (const double grading : {0.2, 0.1}) {
        CAPTURE(grading);
        const MeshResult result = make_mesh(skin, graded(C, grading));
        CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
        CHECK(result.certificate.proved_angle_deg() >= 30);
        const Grading found = measure_grading(result.mesh, grading);
        CHECK(found.most <= 1.6);
        CHECK(found.largest <= 2);
        if (!size_field(skin, graded(C, grading), Run())) continue;
        CHECK(result.method == Method::Static);
        // Where a field limits little, which samples are taken decides as much.
        CHECK(found.most <= std::max(1.35, measure_grading(free.mesh, grading).most));
        CHECK(static_cast<double>(result.mesh.triangles.size()) >=
              0.98 * static_cast<double>(triangles));
        triangles = result.mesh.triangles.size();
      }
    }
  });
}

TEST_CASE("a grading goes with a density, and one that C keeps anyway changes nothing") {
  const PreparedSkin skin = prepare_skin(molecule("9dna.pdb", skin::Model::Vdw));
  MeshingOptions options = graded(certify::Sizing::coarsest_C, 0.2);
  options.size_goal.density = 12;
  const MeshResult dense = make_mesh(skin, options);
  CHECK(dense.certificate.certified);
  const double density = static_cast<double>(dense.mesh.positions.size()) / dense.certificate.area;
  CHECK(std::abs(density / 12 - 1) <= 0.1);

  const MeshingOptions steep = graded(0.2, 0.9);
  CHECK(!size_field(skin, steep, Run()));
  CHECK(make_mesh(skin, steep).mesh.triangles == make_mesh(skin, graded(0.2, {})).mesh.triangles);
}

TEST_CASE("a grading that makes no sense is refused") {
  const PreparedSkin skin = prepare_skin(molecule("5tmn_ligand.pdb", skin::Model::Vdw));
  for (const double grading : {0., -1., 0.001, infinity, std::nan("")}) {
    CHECK_THROWS_AS(make_mesh(skin, graded(0.2, grading)), geometry::RefusedInput);
  }
  MeshingOptions swept = graded(0.2, 0.2), unbound = swept;
  swept.method = Method::Sweep;
  unbound.angle_goal_deg = 20;
  CHECK_THROWS_AS(make_mesh(skin, swept), geometry::RefusedInput);
  CHECK_THROWS_AS(make_mesh(skin, unbound), geometry::RefusedInput);
}

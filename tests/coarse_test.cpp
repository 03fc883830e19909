// Meshes by length and meshes that are coarser than anything is proved of beforehand.

#include "certify/triangle_geometry.h"
#include "front/subdomains.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using certify::Sizing;

namespace {

std::vector<double> edge_lengths(const geometry::IndexedMesh& mesh) {
  std::vector<double> lengths;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      lengths.push_back(
          (mesh.positions[triangle[k]] - mesh.positions[triangle[(k + 1) % 3]]).norm());
    }
  }
  std::ranges::sort(lengths);
  return lengths;
}

Sizing by_length(double C, double length) {
  Sizing sizing = sizing_for(C);
  sizing.set_edge_length(length);
  return sizing;
}

}  // namespace

TEST_CASE(
    "edges asked for by length have that length in the median where the skin is flat enough") {
  const auto skin = prepare_skin({ball(0, 0, 0, 10)});
  for (const double C : {0.08, 0.2, 0.3}) {
    for (const double length : {0.4, 0.7, 1.2}) {
      CAPTURE(C);
      CAPTURE(length);
      const Sizing sizing = by_length(C, length);
      const MeshResult result = make_mesh(skin, with(sizing));
      REQUIRE_MESSAGE(result.certificate.certified, result.certificate.reason);
      const std::vector<double> edges = edge_lengths(result.mesh);
      constexpr double tenth = 0.1;
      CHECK(std::abs(edges[edges.size() / 2] - length) < tenth * length);
      // [L] and [U] with the length scale that the length stands for.
      CHECK(edges.front() > 2 * C / sizing.Q * sizing.largest_length_scale);
      CHECK(edges.back() < 2 * C * sizing.Q * sizing.largest_length_scale);
    }
  }
}

TEST_CASE("so do edges of the static method, on molecules too") {
  const auto median_over = [](const std::vector<geometry::WeightedPoint>& balls, double C,
                              double length) {
    MeshingOptions options = with(by_length(C, length));
    options.method = Method::Static;
    const MeshResult result = make_mesh(prepare_skin(balls), options);
    CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    const std::vector<double> edges = edge_lengths(result.mesh);
    return edges[edges.size() / 2] / length;
  };
  for (const double C : {0.08, 0.3, 0.4}) {
    CAPTURE(C);
    CHECK(median_over({ball(0, 0, 0, 4)}, C, 0.5) == doctest::Approx(1).epsilon(0.1));
  }
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [&](const auto& balls) {
    CHECK(median_over(balls, 0.4, 0.4) == doctest::Approx(1).epsilon(0.1));
  });
}

TEST_CASE("a front that has passed itself on a hyperboloid does not go round it for ever") {
  // Of 1ATP. Found by taking balls away while the front still went round the neck of two of them.
  const std::vector<std::array<double, 4>> balls{
      {10.756, 18.91, 7.439, 1.52},  {12.385, 18.52, 1.875, 1.7},   {13.494, 19.617, 4.822, 1.7},
      {13.313, 19.351, 6.045, 1.55}, {8.472, 19.676, 4.727, 1.7},   {8.463, 21.425, 5.189, 1.8},
      {9.807, 22.03, 4.159, 1.7},    {10.745, 20.147, -1.045, 1.7}, {9.466, 20.24, -0.225, 1.7},
      {11.117, 21.494, -1.628, 1.7}, {9.538, 21.094, 1.013, 1.7},   {13.659, 21.996, 10.041, 1.7},
      {10.758, 20.78, 9.282, 1.52},  {14.716, 22.501, 7.994, 1.55}, {16.198, 19.871, 6.553, 1.7},
      {15.235, 19.45, 7.212, 1.52}};
  std::vector<geometry::WeightedPoint> points;
  for (const auto& [x, y, z, radius] : balls) {
    points.push_back({{x, y, z}, skin::weight(radius, skin::Model::Paper, 1.4)});
  }
  // Laid with C itself, as no mesh is any more beyond C = 0.2.
  const auto skin = prepare_skin(points);
  const Sizing sizing = sizing_for(0.4);
  const morse::Guide guide =
      guide_for(skin, sizing, morse::MorseFunction::height({0.0123, 1, 0.0271}));
  const front::SweepResult swept = front::sweep_once(skin.surface, guide, {.sizing = sizing});
  constexpr std::size_t twice_round = 10'000;  // the whole skin takes some 1,100
  CHECK(swept.operations.creep < twice_round);
}

TEST_CASE("a length longer than C gives anywhere changes nothing") {
  const auto skin = prepare_skin(ball_set(7));
  const auto a = make_mesh(skin, with(sizing_for(0.2)));
  const auto b = make_mesh(skin, with(by_length(0.2, 100)));
  CHECK(a.mesh == b.mesh);
}

TEST_CASE("random ball sets are certified with edges of any length, by C and by length") {
  for_skins(30, [&](const PreparedSkin& skin) {
    for (const double C : {0.25, 0.35}) {
      CAPTURE(C);
      for (const Sizing& sizing : {sizing_for(C), by_length(C, 0.4)}) {
        const MeshResult result = make_mesh(skin, with(sizing));
        CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
      }
    }
  });
}

// Figure 3: the contraction of an arc, in the Morse-Smale complex of a real skin seen from above.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/figures/figures.h"
#include "app/figures/skin_scene.h"
#include "morse/simplification.h"

namespace morskin::figures {
namespace {

using morse::CriticalId;
using morse::MorseSmaleComplex;

// Two layers of balls in a lattice of triangles. On the upper side there is a maximum on each ball,
// a saddle between two and a minimum between three. Waves of height make all of them differ. Two
// balls in the middle stand lower, so that the saddle between them, a, is hardly above one of the
// minima beside it, b.
std::vector<geometry::WeightedPoint> sheet() {
  constexpr double row = 0.866, thickness = 0.9, weight = 0.6, sunk = 0.1, slope = 0.06;
  std::vector<geometry::WeightedPoint> points;
  for (const double layer : {0.0, -thickness}) {
    for (int i = -2; i <= 2; ++i) {
      for (int j = -3; j <= 3; ++j) {
        const double x = row * i, z = j + (i % 2 == 0 ? -0.5 : 0.0);
        if (std::abs(z) > 2.1) continue;
        const double wave = 0.05 * std::sin(2.1 * i + 1.3 * j) + 0.03 * std::cos(0.5 * i + 3.7 * j);
        const bool is_sunk = layer == 0 && i == 0 && std::abs(z) < 1;
        points.push_back({{x, layer + wave + slope * x - (is_sunk ? sunk : 0), z}, weight});
      }
    }
  }
  return points;
}

// Whether p lies within a region as seen from above: by the number of times that a ray crosses the
// lines of its four arcs.
bool is_within(const MorseSmaleComplex& complex, const std::array<CriticalId, 4>& region,
               const Point& p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const auto [saddle, extremum] = complex.arcs[i];
    if ((saddle != region[1] && saddle != region[3]) ||
        (extremum != region[0] && extremum != region[2])) {
      continue;
    }
    const auto line = complex.line(morse::ArcId{i});
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point &u = line[k - 1], &v = line[k];
      if ((u.z() > p.z()) == (v.z() > p.z())) continue;
      const double share = (p.z() - u.z()) / (v.z() - u.z());
      if (u.x() + share * (v.x() - u.x()) > p.x()) is_inside = !is_inside;
    }
  }
  return is_inside;
}

// The regions about a saddle, those first that share its first ascending arc.
std::vector<std::array<CriticalId, 4>> regions_about(const MorseSmaleComplex& complex,
                                                     CriticalId saddle) {
  std::vector<std::array<CriticalId, 4>> regions;
  for (const auto& region : complex.regions) {
    if (region[1] == saddle || region[3] == saddle) regions.push_back(region);
  }
  std::ranges::sort(regions, {}, [](const auto& region) { return region[2]; });
  return regions;
}

constexpr std::array two_of_one{Colour::of(0xf3b45c), Colour::of(0xf9d9a4)},
    two_of_other{Colour::of(0xa98fe0), Colour::of(0xd2c3f2)};
constexpr std::array tints{two_of_one[0], two_of_one[1], two_of_other[0], two_of_other[1]};
constexpr Colour plain = Colour::of(0xd5dbe1);

void add_complex(Scene& scene, const MorseSmaleComplex& complex,
                 const std::vector<bool>& survives) {
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const auto line = complex.line(morse::ArcId{i});
    const int index = complex.points[complex.arcs[i].extremum.index()].index;
    scene.lines.push_back({{line.begin(), line.end()}, colour_of_index(index), 2.4, 0.03});
  }
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (survives[i]) add_critical_points(scene, std::array{complex.points[i]}, 0.035);
  }
}

void add_letter(Scene& scene, const MorseSmaleComplex& complex, CriticalId id,
                const std::string& letter) {
  scene.labels.push_back({complex.points[id.index()].point.position, letter, Vector2(0, 30), 16});
}

}  // namespace

Image contraction(double scale) {
  const morskin::PreparedSkin skin = morskin::prepare_skin(sheet());
  const morse::MorseFunction height = morse::MorseFunction::height(Vector(0, 1, 0));
  const morse::ChosenFunction chosen =
      morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), height);
  const MorseSmaleComplex complex =
      morse::morse_smale_complex(skin.surface, height, chosen.critical);
  const auto [a, b, c, persistence] = morse::persistence_pairs(complex).front();
  const morse::Simplification contracted = morse::cancel_up_to(complex, persistence, 0);

  Scene before;
  before.meshes.push_back(skin_layer(skin, meshed(skin, 0.03)));
  MeshLayer& layer = before.meshes[0];
  layer.coat.gloss = 0.1;
  const auto regions = regions_about(complex, a);
  for (const auto& t : layer.mesh.triangles) {
    const Point middle =
        (layer.mesh.positions[t[0]] + layer.mesh.positions[t[1]] + layer.mesh.positions[t[2]]) / 3;
    std::size_t k = 0;
    while (k < regions.size() && !is_within(complex, regions[k], middle)) ++k;
    const bool is_tinted = middle.y() > 0 && k < regions.size();
    layer.triangle_colours.push_back(is_tinted ? tints[k] : plain);
  }
  Scene after = before;
  // Where two regions have become one.
  for (Colour& colour : after.meshes[0].triangle_colours) {
    for (const auto& [kept, gone] : {two_of_one, two_of_other}) {
      if (colour.r == gone.r && colour.g == gone.g) colour = kept;
    }
  }
  add_complex(before, complex, std::vector(complex.points.size(), true));
  add_complex(after, contracted.complex, contracted.survives);
  add_letter(before, complex, a, "a");
  add_letter(before, complex, b, "b");
  for (Scene* scene : {&before, &after}) add_letter(*scene, complex, c, "c");

  Camera camera = pictures::camera_from(Vector(0, 1, 0.25), Vector(0, 0, -1), 460, 460);
  camera.target = complex.points[a.index()].point.position;
  camera.scale = 190;
  const std::array panels{panel(before, camera, scale), panel(after, camera, scale)};
  return with_legend(
      captioned(panels, std::array<std::string_view, 2>{"before", "after the contraction of ab"},
                scale, 2),
      critical_point_legend({{Mark::Line, minimum_red, "arc to a minimum"},
                             {Mark::Line, maximum_green, "arc to a maximum"},
                             {Mark::Patch, two_of_one[0], "two regions that become one"},
                             {Mark::Patch, two_of_other[0], "two others that do"}}),
      scale);
}

}  // namespace morskin::figures

// Figures 2, 4 and 10(a): critical points, the sweep along them, the lines between them.

#include <algorithm>
#include <array>

#include "app/figures/bundled.h"
#include "app/figures/figures.h"
#include "app/figures/recorded_sweep.h"
#include "app/figures/skin_scene.h"

namespace morskin::figures {
namespace {

// Two legs, a waist and two horns of different heights: the fewest critical points that show all
// that Figure 2 names.
std::vector<geometry::WeightedPoint> two_legs_two_horns() {
  struct BallOf {
    Point centre;
    double radius;
  };
  constexpr double sheet = 0.0;
  const std::array balls{BallOf{{-1.75, -2.15, sheet}, 0.85}, BallOf{{1.65, -1.75, sheet}, 0.85},
                         BallOf{{-0.85, -0.75, sheet}, 0.8},  BallOf{{0.85, -0.6, sheet}, 0.8},
                         BallOf{{0, 0.15, sheet}, 0.95},      BallOf{{-1.05, 1.15, sheet}, 0.8},
                         BallOf{{1.0, 1.0, sheet}, 0.75},     BallOf{{-1.85, 2.35, sheet}, 0.8},
                         BallOf{{1.75, 1.95, sheet}, 0.75}};
  std::vector<geometry::WeightedPoint> points;
  for (const BallOf& b : balls) points.push_back({b.centre, 2 * b.radius * b.radius});
  return points;
}

// A triangle's colour by whether it has a vertex on the front.
std::vector<Colour> front_colours(const geometry::IndexedMesh& mesh) {
  std::vector<bool> is_on_front(mesh.positions.size());
  for (const auto& [a, b] : pictures::boundary_edges(mesh)) {
    is_on_front[a] = is_on_front[b] = true;
  }
  std::vector<Colour> colours;
  for (const auto& t : mesh.triangles) {
    const bool touches = is_on_front[t[0]] || is_on_front[t[1]] || is_on_front[t[2]];
    colours.push_back(touches ? front_red : skin_blue);
  }
  return colours;
}

}  // namespace

Image level_curves(double scale) {
  const morskin::PreparedSkin skin = morskin::prepare_skin(two_legs_two_horns());
  const morse::MorseFunction height = morse::MorseFunction::height(Vector(0, 1, 0));
  const morse::ChosenFunction chosen =
      morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), height);
  Scene scene;
  scene.meshes.push_back(skin_layer(skin, meshed(skin, 0.03, height)));
  std::vector<morse::CriticalPoint> points = chosen.critical.points;
  std::ranges::sort(points, {}, &morse::CriticalPoint::value);
  constexpr double lift = 0.02;
  const Colour pale = Colour::of(0x5c7388), strong = Colour::of(0x10243a);
  constexpr int levels = 22;
  const double low = points.front().value, high = points.back().value;
  for (int i = 0; i < levels; ++i) {
    add_level_curve(scene, scene.meshes[0], height, low + (i + 0.5) / levels * (high - low), pale,
                    1.1, lift);
  }
  for (const morse::CriticalPoint& p : points) {
    if (p.index == 1) add_level_curve(scene, scene.meshes[0], height, p.value, strong, 2.6, lift);
  }
  add_critical_points(scene, points, 0.1);
  // The paper's letters: minima p, q, saddles r, s; the maximum t outlasts u.
  constexpr std::array<std::string_view, 6> letters{"p", "q", "r", "s", "u", "t"};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_below = points[i].index == 0;
    scene.labels.push_back({points[i].point.position,
                            std::string(i < letters.size() ? letters[i] : "?"),
                            Vector2(points[i].index == 1 ? 20 : 0, is_below ? 32 : -16), 17});
  }
  const Camera camera = pictures::camera_from(Vector(0.1, 0.24, 1), Vector::UnitY(), 620, 600)
                            .fitted(scene.extent(), 0.06);
  return with_legend(panel(scene, camera, scale),
                     critical_point_legend({{Mark::Line, strong, "level of a saddle"},
                                            {Mark::Line, pale, "other levels"}}),
                     scale);
}

Image cube_snapshots(double scale) {
  // Without a probe the balls leave the six faces of the cube open.
  const morskin::PreparedSkin skin = bundled_skin("cube8.xyzr", skin::Model::Paper, 0);
  const RecordedSweep sweep = recorded_sweep(skin, {.sizing = {.C = 0.08}});
  const MeshLayer whole = skin_layer(sweep.mesh, sweep.mesh.surface.triangle_count());
  Scene measure;
  measure.meshes.push_back(whole);
  const Camera camera = pictures::camera_from(Vector(0.5, 0.38, 1), Vector::UnitY(), 330, 330)
                            .fitted(measure.extent(), 0.05);
  const auto last_of = [&](front::Operation operation) {
    std::size_t triangles = 0;
    for (const Event& e : sweep.events) {
      if (e.operation == operation) triangles = e.after;
    }
    return triangles;
  };
  const std::size_t created = last_of(front::Operation::Creation);
  std::size_t unsealed = created;
  for (const Event& e : sweep.events) {
    if (e.operation == front::Operation::Seal) break;
    unsealed = e.after;
  }
  const std::size_t all = whole.mesh.triangles.size();
  const auto between = [&](double share) {
    return created + static_cast<std::size_t>(share * static_cast<double>(unsealed - created));
  };
  const std::array states{created, between(0.2), between(0.45), between(0.75), unsealed, all};
  const Colour inner_side = Colour::of(0xe3d3b4);
  std::vector<Image> panels;
  for (const std::size_t state : states) {
    Scene scene;
    scene.meshes.push_back(skin_layer(sweep.mesh, state));
    MeshLayer& layer = scene.meshes[0];
    layer.triangle_colours = front_colours(layer.mesh);
    layer.coat.edge_width = 0.9;
    layer.coat.back = inner_side;
    add_critical_points(scene, sweep.guide.points, 0.075);
    panels.push_back(panel(scene, camera, scale));
  }
  const Image sheet =
      captioned(panels, std::array<std::string_view, 6>{"1", "2", "3", "4", "5", "6"}, scale, 3);
  return with_legend(sheet,
                     critical_point_legend({{Mark::Patch, front_red, "triangles on the front"},
                                            {Mark::Patch, inner_side, "inner side"}}),
                     scale);
}

Image inhibitor_complex(double scale) {
  const morskin::PreparedSkin skin = bundled_skin("5tmn_ligand.pdb");
  const morse::ChosenFunction chosen =
      morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), {});
  const morse::MorseSmaleComplex complex =
      morse::morse_smale_complex(skin.surface, chosen.function, chosen.critical);
  Scene scene;
  scene.meshes.push_back(skin_layer(skin, meshed(skin, 0.05)));
  scene.meshes[0].coat.colour = Colour::of(0xd5dbe1);
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const auto line = complex.line(morse::ArcId{i});
    const int index = complex.points[complex.arcs[i].extremum.index()].index;
    scene.lines.push_back({{line.begin(), line.end()}, colour_of_index(index), 2.6, 0.04});
  }
  add_critical_points(scene, complex.points, 0.13);
  // The height rises upwards in the picture; of the directions across it, the one along which the
  // molecule is thinnest, and from a little above.
  std::vector<Point> level = scene.meshes[0].mesh.positions;
  const Vector& rise = chosen.function.direction;
  for (Point& p : level) p -= rise.dot(p) * rise;
  const Vector across = principal_camera(level, 1, 1).up.cross(rise).normalized();
  const Camera camera = pictures::camera_from(across + 0.4 * rise, rise, 1000, 560);
  return with_legend(
      panel(scene, camera.fitted(scene.extent()), scale),
      critical_point_legend({{Mark::Line, minimum_red, "integral line from a saddle to a minimum"},
                             {Mark::Line, maximum_green, "to a maximum"}}),
      scale);
}

}  // namespace morskin::figures

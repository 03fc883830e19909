#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/commands.h"
#include "app/limits.h"
#include "app/pictures/png.h"
#include "app/pictures/render.h"
#include "app/staged_outputs.h"
#include "certify/triangle_geometry.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/union_find.h"

namespace morskin::app {
namespace {

using pictures::Camera;
using pictures::Colour;
using pictures::Image;

constexpr double min_side = 7;  // pixels of a mean triangle from which on its edges are drawn
constexpr Colour front_red = Colour::of(0xe02d2d);

// Red at 21 degrees, the paper's bound, and below; through yellow to blue at 60.
std::vector<Colour> colours_by_angle(const geometry::IndexedMesh& mesh) {
  constexpr std::array stops{Colour::of(0xb2182b), Colour::of(0xf4a45c), Colour::of(0xf7efb2),
                             Colour::of(0x8fc3de), Colour::of(0x2d6fb0)};
  std::vector<Colour> colours;
  for (const auto& [a, b, c] : mesh.triangles) {
    const certify::AngleRange angles =
        certify::angle_range(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    const double share = std::clamp((angles.smallest_deg - 21) / (60 - 21), 0.0, 1.0);
    const double position = share * (stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(position), stops.size() - 2);
    colours.push_back(mixed(stops[i], stops[i + 1], position - static_cast<double>(i)));
  }
  return colours;
}

// Components by shared vertices, the first one in the first colour.
std::vector<Colour> colours_by_component(const geometry::IndexedMesh& mesh) {
  constexpr std::array palette{Colour::of(0x8db7d9), Colour::of(0xe8a87c), Colour::of(0x93c48b),
                               Colour::of(0xc9a0d6), Colour::of(0xe6d27a), Colour::of(0xe39aa7),
                               Colour::of(0x86cfc4), Colour::of(0xb3b0a2)};
  geometry::UnionFind sets(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(a, c);
  }
  std::vector<std::optional<std::size_t>> number(mesh.positions.size());
  std::size_t count = 0;
  std::vector<Colour> colours;
  for (const auto& t : mesh.triangles) {
    std::optional<std::size_t>& own = number[sets.root(t[0])];
    if (!own) own = count++;
    colours.push_back(palette[*own % palette.size()]);
  }
  return colours;
}

pictures::Scene scene_of(geometry::IndexedMesh mesh, const RenderArguments& arguments) {
  pictures::Scene scene;
  for (const auto& [a, b] : pictures::boundary_edges(mesh)) {
    scene.lines.push_back({{mesh.positions[a], mesh.positions[b]}, front_red, 2.2});
  }
  pictures::MeshLayer layer;
  if (!arguments.flat) layer.normals = pictures::smooth_normals(mesh);
  pictures::drop_copies(mesh);
  if (arguments.by == ColourBy::Angle) layer.triangle_colours = colours_by_angle(mesh);
  if (arguments.by == ColourBy::Component) layer.triangle_colours = colours_by_component(mesh);
  layer.coat.colour = arguments.colour;
  layer.mesh = std::move(mesh);
  scene.meshes.push_back(std::move(layer));
  return scene;
}

// The typical side of a visible triangle, pixels: the root of the mean of their areas.
double mean_side(const geometry::IndexedMesh& mesh, const Camera& camera) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& t : mesh.triangles) {
    const geometry::Vector a = camera.seen(mesh.positions[t[0]]),
                           b = camera.seen(mesh.positions[t[1]]),
                           c = camera.seen(mesh.positions[t[2]]);
    if (a.x() < 0 || a.y() < 0 || a.x() > camera.width || a.y() > camera.height) continue;
    sum += (b - a).head<2>().norm() * (c - a).head<2>().norm() / 2;
    ++count;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

Image panel(pictures::Scene& scene, const Camera& camera, const RenderArguments& arguments) {
  pictures::MeshLayer& layer = scene.meshes[0];
  const bool is_edged =
      arguments.edges == DrawEdges::Always ||
      (arguments.edges == DrawEdges::Auto && mean_side(layer.mesh, camera) > min_side);
  layer.coat.edge_width = is_edged ? 1.1 : 0;
  // Enough to keep a line in front of the triangles it bounds.
  for (pictures::Line& line : scene.lines) line.lift = line.width / camera.scale;
  return pictures::render(scene, camera, {.shadows = arguments.shadows});
}

Camera camera_for(const std::vector<geometry::IndexedMesh>& meshes,
                  const RenderArguments& arguments) {
  std::vector<geometry::Point> points;
  for (const geometry::IndexedMesh& mesh : meshes) {
    points.insert(points.end(), mesh.positions.begin(), mesh.positions.end());
  }
  Camera camera =
      pictures::camera_from(arguments.view, arguments.up, arguments.width, arguments.height)
          .fitted(points);
  if (arguments.at) camera.target = *arguments.at;
  camera.scale *= arguments.zoom;
  // Beyond these, squares and cubes of coordinates leave the range of doubles.
  constexpr double farthest = 1e50, finest = 1e60;
  if (!(camera.target.cwiseAbs().maxCoeff() < farthest) ||
      !(camera.scale > 1 / finest && camera.scale < finest)) {
    throw geometry::UnreadableInput(
        arguments.meshes.front().string() +
        ": too large, too small or too far away to be drawn; scale it to some 1e-50 to 1e50");
  }
  return camera;
}

// The camera of an inset, with its frame in the first panel.
Camera inset_camera(const Camera& camera, const Inset& inset, Image& first) {
  Camera detail = camera;
  detail.scale *= inset.factor;
  const double dx = (inset.x - 0.5) * camera.width, dy = (inset.y - 0.5) * camera.height;
  detail.target += (dx * camera.right - dy * camera.up) / camera.scale;
  const double w = camera.width / inset.factor / 2, h = camera.height / inset.factor / 2;
  const double x = camera.width / 2.0 + dx, y = camera.height / 2.0 + dy;
  const pictures::Box box{x - w, y - h, x + w, y + h};
  draw_box(first, box, {pictures::white, 4});
  draw_box(first, box, {pictures::ink, 2});
  return detail;
}

constexpr int gap = 16;  // between panels, pixels

void check_sheet(const RenderArguments& arguments) {
  constexpr double longest = 1e6;  // libpng's limit of rows and columns
  const std::size_t panels = arguments.meshes.size() + (arguments.inset ? 1 : 0);
  const std::size_t columns = std::min(panels, static_cast<std::size_t>(arguments.columns));
  const std::size_t rows = (panels + columns - 1) / columns;
  const auto side = [](std::size_t count, int pixels) {
    return static_cast<double>(count) * (pixels + gap);
  };
  if (side(columns, arguments.width) > longest || side(rows, arguments.height) > longest) {
    throw UsageError("the picture would be longer than a million pixels; choose a smaller --size");
  }
}

}  // namespace

ExitCode render_command(const RenderArguments& arguments) {
  TimeLimit time_limit(arguments.limits, arguments.meshes.front());
  check_sheet(arguments);
  std::vector<geometry::IndexedMesh> meshes;
  for (const std::filesystem::path& path : arguments.meshes) {
    meshes.push_back(geometry::read_mesh(path));
  }
  StagedOutputs outputs({arguments.output});
  const Camera camera = camera_for(meshes, arguments);
  std::vector<Image> panels;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    pictures::Scene scene = scene_of(std::move(meshes[i]), arguments);
    panels.push_back(panel(scene, camera, arguments));
    if (i > 0 || !arguments.inset) continue;
    const Camera detail = inset_camera(camera, *arguments.inset, panels[0]);
    panels.push_back(panel(scene, detail, arguments));
    draw_border(panels.back(), {pictures::ink, 2});
  }
  if (arguments.inset) std::rotate(panels.begin() + 1, panels.begin() + 2, panels.end());
  const std::string picture = pictures::png(pictures::in_rows(panels, arguments.columns, gap));
  time_limit.cancel();
  write_to_all(outputs, picture);
  return ExitCode::Success;
}

}  // namespace morskin::app

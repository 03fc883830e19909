#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/commands.h"
#include "app/limits.h"
#include "app/pictures/png.h"
#include "app/pictures/render.h"
#include "app/staged_outputs.h"
#include "app/triangle_colours.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/mesh_shape.h"

namespace morskin::app {
namespace {

using pictures::Camera;
using pictures::Image;

constexpr double min_side = 7;  // pixels of a mean triangle from which on its edges are drawn

struct Subject {
  pictures::Scene scene;
  std::size_t components = 0;  // as in TriangleColours
  bool is_inside_out = false;
};

Subject subject_of(geometry::IndexedMesh mesh, const RenderArguments& arguments) {
  pictures::Scene scene;
  for (const auto& [a, b] : pictures::boundary_edges(mesh)) {
    if (mesh.positions[a] == mesh.positions[b]) continue;
    scene.lines.push_back({{mesh.positions[a], mesh.positions[b]}, border_red, 2.2});
  }
  pictures::MeshLayer layer;
  if (!arguments.flat) layer.normals = pictures::smooth_normals(mesh);
  pictures::drop_copies(mesh);
  TriangleColours colours = triangle_colours(mesh, arguments.by);
  layer.triangle_colours = std::move(colours.colours);
  layer.coat.colour = arguments.colour;
  const bool is_inside_out = geometry::measure_shape(mesh).volume < 0;
  layer.mesh = std::move(mesh);
  scene.meshes.push_back(std::move(layer));
  return {std::move(scene), colours.components, is_inside_out};
}

// The typical side of a triangle in the picture, pixels: the root of the mean of half the product
// of two sides as seen. A triangle counts where its first corner does.
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

/// Squares and cubes of coordinates stay in the range of doubles.
bool is_usable(const Camera& camera) {
  constexpr double farthest = 1e50, finest = 1e60;
  return camera.target.cwiseAbs().maxCoeff() < farthest && camera.scale > 1 / finest &&
         camera.scale < finest;
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
  if (!is_usable(camera)) {
    throw geometry::RefusedInput(
        arguments.meshes.front().string() +
        ": too large, too small or too far away to be drawn; scale it to some 1e-50 to 1e50");
  }
  if (arguments.at) camera.target = *arguments.at;
  camera.scale *= arguments.zoom;
  if (!is_usable(camera)) throw UsageError("--at and --zoom lead too far away from the mesh");
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
  if (std::ranges::all_of(meshes, [](const auto& mesh) { return mesh.triangles.empty(); })) {
    throw geometry::RefusedInput(arguments.meshes.front().string() + ": has no triangles to draw");
  }
  StagedOutputs outputs({arguments.output});
  const Camera camera = camera_for(meshes, arguments);
  std::vector<Image> panels;
  std::size_t components = 0;
  bool has_border = false, shows_inside = false;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    auto [scene, own_components, is_inside_out] = subject_of(std::move(meshes[i]), arguments);
    components = std::max(components, own_components);
    has_border |= !scene.lines.empty();
    shows_inside |= has_border || is_inside_out;
    panels.push_back(panel(scene, camera, arguments));
    if (i > 0 || !arguments.inset) continue;
    const Camera detail = inset_camera(camera, *arguments.inset, panels[0]);
    panels.push_back(panel(scene, detail, arguments));
    draw_border(panels.back(), {pictures::ink, 2});
  }
  if (arguments.inset) std::rotate(panels.begin() + 1, panels.begin() + 2, panels.end());
  const std::string picture = pictures::png(
      pictures::with_legend(pictures::in_rows(panels, arguments.columns, gap),
                            legend_of(arguments, components, has_border, shows_inside)));
  time_limit.cancel();
  write_to_all(outputs, picture);
  return ExitCode::Success;
}

}  // namespace morskin::app

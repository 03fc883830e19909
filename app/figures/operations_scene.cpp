#include "app/figures/operations_scene.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace morskin::figures {

std::optional<Fan> fan_of(const Stage& stage, const Event& event) {
  std::map<geometry::VertexId, std::size_t> uses;
  for (std::size_t t = event.before; t < event.after; ++t) {
    for (const auto v : stage.corners(t)) ++uses[v];
  }
  for (const auto& [centre, count] : uses) {
    if (count != event.after - event.before) continue;
    std::map<geometry::VertexId, geometry::VertexId> next, previous;
    for (std::size_t t = event.before; t < event.after; ++t) {
      const auto c = stage.corners(t);
      const auto k = static_cast<std::size_t>(std::ranges::find(c, centre) - c.begin());
      next[c[(k + 1) % 3]] = c[(k + 2) % 3];
      previous[c[(k + 2) % 3]] = c[(k + 1) % 3];
    }
    Fan fan{centre, {}};
    for (const auto& [from, to] : next) {
      if (!previous.contains(from)) fan.rim.push_back(from);
    }
    if (fan.rim.size() > 1) continue;
    if (fan.rim.empty()) fan.rim.push_back(next.begin()->first);
    while (next.contains(fan.rim.back()) && next[fan.rim.back()] != fan.rim.front()) {
      fan.rim.push_back(next[fan.rim.back()]);
    }
    return fan;
  }
  return std::nullopt;
}

Scene state(const Stage& stage, std::size_t triangles, std::size_t fresh) {
  Scene scene;
  scene.meshes.push_back(stage.bare);
  scene.meshes.push_back(skin_layer(stage.sweep.mesh, triangles));
  MeshLayer& layer = scene.meshes[1];
  layer.normals.clear();
  layer.coat.edge_width = 1.8;
  layer.coat.back = layer.coat.colour;
  layer.triangle_colours.assign(triangles, skin_blue);
  for (std::size_t t = fresh; t < triangles; ++t) layer.triangle_colours[t] = fresh_orange;
  for (const auto& [a, b] : pictures::boundary_edges(layer.mesh)) {
    scene.lines.push_back(
        {{layer.mesh.positions[a], layer.mesh.positions[b]}, front_red, 4.5, 0.02});
  }
  return scene;
}

Point on_rim(const surface::SurfacePoint& centre, double radius, const Point& p) {
  const Vector d = p - centre.position;
  return centre.position + radius * (d - d.dot(centre.normal) * centre.normal).normalized();
}

pictures::Line circle(const Point& centre, double radius, const Vector& first, const Vector& second,
                      double dash) {
  constexpr int sides = 120;
  pictures::Line line{{}, pictures::ink, 2, 0.01, dash};
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    line.points.push_back(centre + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return line;
}

pictures::Line tangent_disk(const Stage& stage, const surface::SurfacePoint& p) {
  const Vector first = p.normal.unitOrthogonal();
  return circle(p.position, stage.disk_share * p.length_scale, first, p.normal.cross(first), 7);
}

Camera over(const Stage& stage, const surface::SurfacePoint& p, double half_width, double tilt) {
  const Vector gradient = stage.sweep.guide.function.gradient(p.position);
  const Vector rise = (gradient - gradient.dot(p.normal) * p.normal).normalized();
  Camera camera = pictures::camera_from(p.normal - tilt * rise, rise, 460, 400);
  camera.target = p.position;
  camera.scale = camera.width / (2 * half_width);
  return camera;
}

void add_vertex(Scene& scene, const Point& p, const std::string& text, const Vector2& shift,
                double radius, const Colour& colour) {
  scene.balls.push_back({p, radius, colour});
  scene.labels.push_back({p, text, shift, 14});
}

Vector2 outward(const Camera& camera, const Point& centre, const Point& p, double pixels) {
  const Vector d = camera.seen(p) - camera.seen(centre);
  const Vector2 flat = d.head<2>();
  return (flat.norm() > 0 ? Vector2(pixels * flat.normalized()) : Vector2(0, -pixels)) +
         Vector2(0, 6);
}

std::vector<LegendEntry> state_legend(std::string dashes) {
  return {{Mark::Patch, fresh_orange, "new triangles"},
          {Mark::Line, front_red, "front"},
          {Mark::Patch, bare_grey, "bare skin"},
          {Mark::Dashes, pictures::ink, std::move(dashes)}};
}

Image before_and_after(const Scene& before, const Scene& after, const Camera& camera,
                       std::array<std::string_view, 2> captions, std::string dashes, double scale) {
  const std::array panels{panel(before, camera, scale), panel(after, camera, scale)};
  std::vector<LegendEntry> legend = state_legend(std::move(dashes));
  const LegendEntry laid_before{Mark::Patch, skin_blue, "triangles laid before"};
  legend.insert(legend.begin() + 1, laid_before);
  return with_legend(captioned(panels, captions, scale, 2), {{}, std::move(legend)}, scale);
}

}  // namespace morskin::figures

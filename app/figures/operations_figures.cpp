// Figures 5 to 8: the operations of section 4.1, from one real sweep of the cube of Figure 4. Each
// shows the state right before an operation and right after it.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

#include "app/figures/bundled.h"
#include "app/figures/figures.h"
#include "app/figures/recorded_sweep.h"
#include "app/figures/skin_scene.h"
#include "front/tangent_disk.h"

namespace morskin::figures {
namespace {

using front::Operation;

struct Stage {
  morskin::PreparedSkin skin = bundled_skin("cube8.xyzr", skin::Model::Paper, 0);
  RecordedSweep sweep = recorded_sweep(skin, {.sizing = {.C = 0.08}});
  MeshLayer bare = backdrop(skin, sweep.guide.function, 0.03);
  double disk_share = front::Spacing{}.disk_share * certify::Sizing{}.tangent_disk_share();

  std::array<geometry::VertexId, 3> corners(std::size_t triangle) const {
    return sweep.mesh.surface.corners(geometry::TriangleId{triangle});
  }
  const surface::SurfacePoint& at(geometry::VertexId v) const { return sweep.mesh.at(v); }
};

// The triangles of an operation as a fan: its centre, and the rim in order.
struct Fan {
  geometry::VertexId centre;
  std::vector<geometry::VertexId> rim;
};

// Of an operation whose triangles have one vertex in common and no two rims, else nothing.
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

// The state after a number of triangles, those from `fresh` on highlighted, the front in red.
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

// A circle about a point of the skin; its plane is that of two orthogonal vectors.
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

// A camera over a point of the skin, the Morse function rising upwards in the picture.
Camera over(const Stage& stage, const surface::SurfacePoint& p, double half_width, double tilt) {
  const Vector gradient = stage.sweep.guide.function.gradient(p.position);
  const Vector rise = (gradient - gradient.dot(p.normal) * p.normal).normalized();
  Camera camera = pictures::camera_from(p.normal - tilt * rise, rise, 460, 400);
  camera.target = p.position;
  camera.scale = camera.width / (2 * half_width);
  return camera;
}

void add_vertex(Scene& scene, const Point& p, const std::string& text, const Vector2& shift,
                double radius, const Colour& colour = pictures::ink) {
  scene.balls.push_back({p, radius, colour});
  scene.labels.push_back({p, text, shift, 14});
}

// The position of a label away from a centre in the view.
Vector2 outward(const Camera& camera, const Point& centre, const Point& p, double pixels) {
  const Vector d = camera.seen(p) - camera.seen(centre);
  const Vector2 flat = d.head<2>();
  return (flat.norm() > 0 ? Vector2(pixels * flat.normalized()) : Vector2(0, -pixels)) +
         Vector2(0, 6);
}

Image before_and_after(const Scene& before, const Scene& after, const Camera& camera,
                       std::array<std::string_view, 2> captions, double scale) {
  const std::array panels{panel(before, camera, scale), panel(after, camera, scale)};
  return captioned(panels, captions, scale, 2);
}

// Of the events of one kind that `suits`, the one at a share of their number.
template <class Suits>
const Event& chosen(const Stage& stage, Operation operation, double share, const Suits& suits) {
  std::vector<const Event*> events;
  for (const Event& e : stage.sweep.events) {
    if (e.operation == operation && suits(e)) events.push_back(&e);
  }
  if (events.empty()) throw std::logic_error("the sweep has no operation for this figure");
  const double position = share * static_cast<double>(events.size() - 1);
  return *events[static_cast<std::size_t>(position)];
}

}  // namespace

Image bowl(double scale) {
  const Stage stage;
  const Event& event = chosen(stage, Operation::Creation, 0, [](const Event&) { return true; });
  const Fan fan = *fan_of(stage, event);
  const surface::SurfacePoint& p0 = stage.at(fan.centre);
  const double r = stage.disk_share * p0.length_scale;
  Scene scene = state(stage, event.after, event.before);
  scene.lines.push_back(tangent_disk(stage, p0));
  // Seen from below, the minimum upwards.
  Camera camera = pictures::camera_from(Vector(0.25, -0.6, 0.8), -Vector::UnitY(), 620, 460);
  camera.target = p0.position;
  camera.scale = camera.width / (4.4 * r);
  add_vertex(scene, p0.position, "p_0", Vector2(0, -14), 0.05 * r);
  for (std::size_t i = 0; i < fan.rim.size(); ++i) {
    const Point& p = stage.at(fan.rim[i]).position;
    const Vector d = p - p0.position;
    // On a sphere patch the projection keeps the direction from the centre.
    const Point q = p0.position + r * (d - d.dot(p0.normal) * p0.normal).normalized();
    const std::string number = std::to_string(i + 1);
    scene.lines.push_back({{q, p}, pictures::ink, 2, 0.02});
    add_vertex(scene, q, "q_" + number, outward(camera, p0.position, q, 26), 0.035 * r,
               Colour::of(0xffffff));
    add_vertex(scene, p, "p_" + number, outward(camera, p0.position, p, -24), 0.05 * r);
  }
  return panel(scene, camera, scale);
}

Image creep(double scale) {
  const Stage stage;
  const Event& event = chosen(stage, Operation::Creep, 0.42, [&](const Event& e) {
    return e.after - e.before == 3 && fan_of(stage, e).has_value();
  });
  const Fan fan = *fan_of(stage, event);
  const surface::SurfacePoint& p = stage.at(fan.centre);
  const double r = stage.disk_share * p.length_scale;
  const Camera camera = over(stage, p, 2.6 * r, 0.45);
  Scene before = state(stage, event.before, event.before);
  Scene after = state(stage, event.after, event.before);
  for (Scene* scene : {&before, &after}) {
    scene->lines.push_back(tangent_disk(stage, p));
    add_vertex(*scene, p.position, "p_t", Vector2(0, 30), 0.06 * r);
  }
  for (std::size_t i = 0; i < fan.rim.size(); ++i) {
    const bool is_last = i + 1 == fan.rim.size();
    const Point& x = stage.at(fan.rim[i]).position;
    const Vector2 shift = outward(camera, p.position, x, 24);
    const std::string name = is_last ? "p_n" : "p_" + std::to_string(i);
    add_vertex(after, x, name, shift, 0.05 * r);
    if (i == 0 || is_last) add_vertex(before, x, name, shift, 0.05 * r);
  }
  return before_and_after(before, after, camera, {"before", "after creep"}, scale);
}

Image wing(double scale) {
  const Stage stage;
  const Event& event =
      chosen(stage, Operation::Wing, 0.4, [&](const Event& e) { return e.after - e.before == 1; });
  // The corner that closes is the vertex that the triangle shares with both front edges: the one
  // whose two edges of the triangle were front edges before.
  const MeshLayer laid = skin_layer(stage.sweep.mesh, event.before);
  const auto front = pictures::boundary_edges(laid.mesh);
  const auto is_front = [&](geometry::VertexId a, geometry::VertexId b) {
    return std::ranges::binary_search(
        front, std::array{std::min(a.value, b.value), std::max(a.value, b.value)});
  };
  const auto c = stage.corners(event.before);
  std::size_t k = 0;
  while (k < 2 && !(is_front(c[k], c[(k + 1) % 3]) && is_front(c[k], c[(k + 2) % 3]))) ++k;
  const surface::SurfacePoint& f = stage.at(c[k]);
  const double r = stage.disk_share * f.length_scale;
  const Camera camera = over(stage, f, 2.6 * r, 0.45);
  Scene before = state(stage, event.before, event.before);
  Scene after = state(stage, event.after, event.before);
  for (Scene* scene : {&before, &after}) {
    add_vertex(*scene, f.position, "f", Vector2(0, 30), 0.06 * r);
    constexpr std::array<const char*, 2> names{"g", "d"};
    for (std::size_t i = 0; i < 2; ++i) {
      const Point& x = stage.at(c[(k + 1 + i) % 3]).position;
      add_vertex(*scene, x, names[i], outward(camera, f.position, x, 22), 0.05 * r);
    }
  }
  return before_and_after(before, after, camera, {"a small front angle at f", "after wing"}, scale);
}

Image bridge(double scale) {
  const Stage stage;
  const Event& event = chosen(stage, Operation::Bridge, 0, [](const Event&) { return true; });
  // The small angles that the bridge makes are closed with it.
  std::size_t after_all = event.after;
  for (const Event& e : stage.sweep.events) {
    if (e.before == after_all && e.operation == Operation::Wing) after_all = e.after;
  }
  const Point middle = stage.at(stage.corners(event.before)[0]).position;
  const auto nearest = [&] {
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < stage.sweep.guide.points.size(); ++i) {
      const morse::CriticalPoint& p = stage.sweep.guide.points[i];
      const double d = (p.point.position - middle).norm();
      if (p.index == 1 && d < least) {
        least = d;
        best = i;
      }
    }
    return best;
  }();
  const morse::CriticalPoint& s = stage.sweep.guide.points[nearest];
  const double r = stage.disk_share * s.point.length_scale;
  Camera camera = pictures::camera_from(s.point.normal - 0.35 * s.ascending, s.ascending, 460, 400);
  if (s.ascending.dot(stage.sweep.guide.function.gradient(middle)) < 0) camera.up = -camera.up;
  camera.target = s.point.position;
  camera.scale = camera.width / (6.0 * r);
  Scene before = state(stage, event.before, event.before);
  Scene after = state(stage, after_all, event.before);
  const double sphere = stage.sweep.guide.spheres.radius(morse::CriticalId{nearest});
  for (Scene* scene : {&before, &after}) {
    pictures::Line rim = circle(s.point.position, sphere, camera.right, camera.up, 4);
    rim.is_on_top = true;
    scene->lines.push_back(rim);
    add_vertex(*scene, s.point.position, "p_s", Vector2(16, -12), 0.07 * r, saddle_blue);
  }
  return before_and_after(before, after, camera, {"before", "after bridge"}, scale);
}

}  // namespace morskin::figures

// Figures 5, 6 and 8: the operations of section 4.1, from one real sweep of the cube of Figure 4.
// Each shows the state right before an operation and right after it.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "app/figures/figures.h"
#include "app/figures/operations_scene.h"

namespace morskin::figures {

using front::Operation;

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
    // On a sphere patch the projection keeps the direction from the centre.
    const Point q = on_rim(p0, r, p);
    const std::string number = std::to_string(i + 1);
    scene.lines.push_back({{q, p}, pictures::ink, 2, 0.02});
    add_vertex(scene, q, "q_" + number, outward(camera, p0.position, q, 26), 0.035 * r,
               Colour::of(0xffffff));
    add_vertex(scene, p, "p_" + number, outward(camera, p0.position, p, -24), 0.05 * r);
  }
  return with_legend(panel(scene, camera, scale), {{}, state_legend("tangent disk")}, scale);
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
    const bool is_new = i > 0 && !is_last;
    const Vector2 shift = outward(camera, p.position, x, is_new ? -24 : 24);
    const std::string name = is_last ? "p_n" : "p_" + std::to_string(i);
    add_vertex(after, x, name, shift, 0.05 * r);
    if (!is_new) {
      add_vertex(before, x, name, shift, 0.05 * r);
    } else {
      const Point q = on_rim(p, r, x);
      after.lines.push_back({{q, x}, pictures::ink, 2, 0.02});
      add_vertex(after, q, "q_" + std::to_string(i), outward(camera, p.position, q, 24), 0.035 * r,
                 pictures::white);
    }
  }
  // The disk's radius, drawn over bare skin.
  const Point ahead = on_rim(p, r, stage.at(fan.rim[fan.rim.size() / 2]).position);
  before.lines.push_back({{p.position, ahead}, pictures::ink, 1.5, 0.02});
  before.labels.push_back({p.position + 0.6 * (ahead - p.position), "r_a", Vector2(16, 4), 14});
  return before_and_after(before, after, camera, {"before", "after creep"}, "tangent disk", scale);
}

namespace {

// The four ends of the two front edges that a bridge joins: p_l, p_r, p_u, p_v. The bridge's first
// triangle has one edge and an end of the other.
std::array<geometry::VertexId, 4> ends_of_bridge(const Stage& stage, const Event& event,
                                                 std::size_t after_all) {
  const FrontBefore front(stage, event.before);
  auto c = stage.corners(event.before);
  for (int i = 0; i < 2 && !front.has(c[0], c[1]); ++i)
    std::rotate(c.begin(), c.begin() + 1, c.end());
  for (std::size_t t = event.before; t < after_all; ++t) {
    for (const geometry::VertexId v : stage.corners(t)) {
      if (std::ranges::find(c, v) == c.end() && front.has(c[2], v)) return {c[0], c[1], c[2], v};
    }
  }
  throw std::logic_error("the bridge of this figure joins no two edges");
}

}  // namespace

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
    constexpr std::array<const char*, 4> names{"p_l", "p_r", "p_u", "p_v"};
    const auto ends = ends_of_bridge(stage, event, after_all);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const Point& x = stage.at(ends[i]).position;
      add_vertex(*scene, x, names[i], outward(camera, s.point.position, x, 24), 0.06 * r);
    }
  }
  return before_and_after(before, after, camera, {"before", "after bridge"}, "protecting sphere",
                          scale);
}

}  // namespace morskin::figures

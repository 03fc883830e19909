// Figures 10(b) and 11: skins as results.

#include <array>

#include "app/figures/bundled.h"
#include "app/figures/figures.h"
#include "app/figures/free_form.h"
#include "app/figures/skin_scene.h"

namespace morskin::figures {

Image head(double scale) {
  const std::vector<Point> samples =
      samples_of(head_function, Point(-1.1, -2.2, -1.4), Point(1.1, 1.4, 1.4), 0.04);
  const std::vector<geometry::WeightedPoint> balls = inner_polar_balls(samples, head_function);
  const morskin::PreparedSkin skin = morskin::prepare_skin(balls);
  Scene points, inside, surface;
  for (const Point& p : samples) points.balls.push_back({p, 0.013, Colour::of(0x3c5f80)});
  for (std::size_t i = 0; i < balls.size(); i += 20) {
    const double radius = std::sqrt(balls[i].weight / 2);
    inside.balls.push_back({balls[i].position, radius, Colour::of(0xe0b48c)});
  }
  surface.meshes.push_back(skin_layer(skin, meshed(skin, 0.04)));
  surface.meshes[0].coat.colour = Colour::of(0xe6cfb8);
  surface.meshes[0].coat.gloss = 0.12;
  const Camera camera = pictures::camera_from(Vector(0.55, 0.08, 1), Vector::UnitY(), 330, 470)
                            .fitted(surface.extent());
  const std::array panels{panel(points, camera, scale), panel(inside, camera, scale),
                          panel(surface, camera, scale)};
  return captioned(
      panels,
      std::array<std::string_view, 3>{"samples", "every twentieth inner polar ball", "their skin"},
      scale, 3);
}

Image gramicidin(double scale) {
  const morskin::PreparedSkin skin = bundled_skin("1grm_model1.pdb");
  Scene scene;
  scene.meshes.push_back(skin_layer(skin, meshed(skin, 0.08)));
  const Camera camera =
      pictures::camera_from(Vector::UnitZ(), Vector::UnitY(), 600, 600).fitted(scene.extent());
  Camera detail = camera;
  detail.scale *= 9;
  detail.target += (-0.047 * 600 * camera.right + 0.148 * 600 * camera.up) / camera.scale;
  Scene edged = scene;
  edged.meshes[0].coat.edge_width = 1.2;
  std::array panels{panel(scene, camera, scale), panel(edged, detail, scale)};
  frame(panels[0], camera, detail, scale);
  draw_border(panels[1], {pictures::ink, 2 * scale});
  return captioned(panels, std::array<std::string_view, 2>{"(a)", "(b)"}, scale, 2);
}

}  // namespace morskin::figures

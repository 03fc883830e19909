// Section 4.1, front/operations.cpp: one creep.
//
// A single ball's sweep is stopped after its first creep. The bowl takes 120 of the 360 degrees
// about the departure vertex p_t, so n = 240 / 60 = 4 triangles are laid. The points q_i lie on
// the rim of the tangent disk, at the distance r_a (section 4.2); p_i is q_i projected to the skin.

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "front/subdomains.h"
#include "morse/make_guide.h"
#include "morskin/pipeline.h"
#include "papers/steps/step.h"

int main() {
  using namespace morskin;
  const PreparedSkin skin = prepare_skin({{{0, 0, 0}, 2.0}});  // rho = 1 everywhere
  const double share = certify::Sizing{}.tangent_disk_share();
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), {}, share);
  // [excerpt: step-creep]
  std::vector<front::Operation> done;
  std::vector<std::size_t> laid;  // triangles there are after each
  front::OperationObserver recorder([&](front::Operation operation, std::size_t triangles) {
    done.push_back(operation);
    laid.push_back(triangles);
  });
  const surface::Mesh mesh = front::sweep_once(skin.surface, guide, {}, {}, {&recorder}).mesh;
  // [/excerpt]
  bool holds = done.at(0) == front::Operation::Creation && laid[0] == 6 &&
               done.at(1) == front::Operation::Creep && laid[1] - laid[0] == 4;
  std::printf("bowl: %zu triangles; first creep: %zu more\n", laid[0], laid[1] - laid[0]);

  // The fan: each triangle is p_t, p_i, p_(i - 1), in some turn of them.
  const auto corners = [&](std::size_t t) { return mesh.surface.corners(geometry::TriangleId{t}); };
  for (std::size_t t = laid[0]; t < laid[1]; ++t) {
    std::size_t k = 0;  // the corner that all four have
    for (std::size_t other = laid[0]; other < laid[1]; ++other) {
      const auto c = corners(other);
      while (k < 3 && std::ranges::find(c, corners(t)[k]) == c.end()) ++k;
    }
    if (k == 3) return 1;
    const surface::SurfacePoint& p = mesh.at(corners(t)[k]);
    // On a sphere about the origin q lies over its projection p in the tangent plane of p_t.
    const auto q = [&](std::size_t corner) {
      const geometry::Point& x = mesh.position(corners(t)[corner % 3]);
      return geometry::Vector(x / x.dot(p.normal) - p.position);
    };
    const geometry::Vector a = q(k + 1), b = q(k + 2);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
    std::printf("  angle at p_t %.2f degrees, distances of the q %.4f and %.4f\n", angle, a.norm(),
                b.norm());
    const double r = front::Spacing{}.disk_share * share;  // of the largest that 4.2 allows
    holds = holds && std::abs(angle - 60) < 1 && std::abs(a.norm() / r - 1) < 0.01;
  }
  return step::claim("a fan of 240 / 60 triangles on the rim of the tangent disk", holds);
}

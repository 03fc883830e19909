// Section 4.3, refine/refinement.h: one flip.
//
// A restricted Delaunay triangle keeps its surface ball empty: the ball about a point of the skin
// through its three corners (section 2.2). One edge of such a mesh is turned the wrong way by hand.
// Then the ball of a triangle beside it holds the far corner, and the refinement turns it back.

#include "front/subdomains.h"
#include "morse/make_guide.h"
#include "morskin/pipeline.h"
#include "papers/steps/step.h"
#include "refine/refinement.h"

int main() {
  using namespace morskin;
  const PreparedSkin skin = prepare_skin({{{0, 0, 0}, 2.0}});
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), {},
                        certify::Sizing{}.tangent_disk_share());
  surface::Mesh mesh = front::sweep_once(skin.surface, guide).mesh;
  refine::Refinement(skin.surface, {}, mesh).run();
  const geometry::HalfEdgeId h{300U};
  const auto ends = [&] { return std::pair(mesh.surface.origin(h), mesh.surface.target(h)); };
  const auto [a, b] = ends();

  // How deep the far corner lies in the ball of h's triangle, over the ball's squared radius.
  // [excerpt: step-flip]
  const auto depth = [&] {
    const auto [u, v, w] = mesh.surface.corners(geometry::SurfaceMesh::triangle(h));
    const auto ball =
        certify::exact_surface_ball(skin.surface, mesh.at(u), mesh.position(v), mesh.position(w));
    const auto far = mesh.surface.apex(mesh.surface.twin(h));
    return ball.intrusion(mesh.position(far)) / ball.squared_radius;
  };
  // [/excerpt]
  const double before = depth();
  std::printf("edge %u-%u: the far corner's depth in the ball is %.3f\n", a.value, b.value, before);
  mesh.surface.flip(h);
  const auto [c, d] = ends();
  const double after = depth();
  std::printf("edge %u-%u in its place: %.3f\n", c.value, d.value, after);

  refine::Refinement again(skin.surface, {}, mesh);
  again.run();
  const auto& counts = again.counts();
  std::printf("refinement: %zu flip, %zu contractions, %zu insertions; edge %u-%u is %s\n",
              counts.flip, counts.contract, counts.insert, a.value, b.value,
              mesh.surface.has_edge(a, b) ? "back" : "gone");
  return step::claim("an edge that is not Delaunay is turned back",
                     before <= 0 && after > 0 && counts.flip == 1 && counts.contract == 0 &&
                         counts.insert == 0 && mesh.surface.has_edge(a, b));
}

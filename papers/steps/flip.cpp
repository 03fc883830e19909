// Section 4.3, refine/triangle_geometry.h: one flip.
//
// An edge of a restricted Delaunay triangulation is turned the wrong way by hand. The surface ball
// of a triangle beside it, centred on the skin through its corners, then holds the far corner;
// turned back it does not, and the refinement does just that.

#include "front/mesh_skin.h"
#include "front/two_fronts.h"
#include "papers/steps/step.h"
#include "refine/refinement.h"

int main() {
  using namespace morskin;
  const front::PreparedSkin skin = front::prepare_skin({{{0, 0, 0}, 2.0}});
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), {},
                        refine::Sizing{}.tangent_disk_share());
  skin::SkinMesh mesh = front::sweep_once(skin.surface, guide).mesh;
  refine::Refinement(skin.surface, {}, mesh).run();
  const auto before = mesh.surface.triangle_list();

  const geometry::HalfEdgeId h{300U};
  const auto depth = [&] {
    const auto [a, b, c] = mesh.surface.corners(geometry::SurfaceMesh::triangle(h));
    const auto ball =
        refine::exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
    const auto far = mesh.surface.apex(mesh.surface.twin(h));
    return ball.intrusion(mesh.position(far)) / ball.squared_radius;
  };
  const double good = depth();
  mesh.surface.flip(h);
  const double bad = depth();
  std::printf("the far corner's depth in the ball, over its squared radius: %.3f\n", good);
  std::printf("after the edge was turned by hand: %.3f\n", bad);

  refine::Refinement again(skin.surface, {}, mesh);
  again.run();
  std::printf("the refinement made %zu flip, %zu contractions, %zu insertions\n",
              again.counts().flip, again.counts().contract, again.counts().insert);
  return step::claim("an edge that is not Delaunay is turned back",
                     good <= 0 && bad > 0 && again.counts().flip == 1 &&
                         again.counts().contract + again.counts().insert == 0);
}

// Section 2.2 and papers/certificate.md, refine/certificate.h: a certificate, and what it refuses.
//
// The mesh of two balls is certified from its coordinates and triangles alone. Then one triangle is
// turned round, one vertex is moved a hundredth of its length scale, and a ball is left out.

#include "front/mesh_skin.h"
#include "papers/steps/step.h"

int main() {
  using namespace morskin;
  const front::PreparedSkin skin =
      front::prepare_skin({{{-1, 0, 0}, 2.0}, {{1, 0, 0}, 2.0}, {{6, 0, 0}, 1.5}});
  const geometry::IndexedMesh mesh = front::mesh_skin(skin).mesh;
  const auto verdict = [&](const char* what, const geometry::IndexedMesh& some) {
    const refine::Certificate certificate = refine::certify(some, skin.surface, skin.topology);
    std::printf("%-20s %s\n", what,
                certificate.certified ? "certified" : certificate.reason.c_str());
    return certificate.certified;
  };
  bool holds = verdict("as meshed:", mesh);

  geometry::IndexedMesh turned = mesh;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  holds = !verdict("one turned round:", turned) && holds;

  geometry::IndexedMesh moved = mesh;
  moved.positions[3] *= 1.01;
  holds = !verdict("one vertex moved:", moved) && holds;

  geometry::IndexedMesh partial = mesh;
  std::erase_if(partial.triangles, [&](const auto& t) { return mesh.positions[t[0]].x() > 4; });
  std::vector<geometry::Point> kept;
  for (const geometry::Point& p : mesh.positions) {
    if (p.x() <= 4) kept.push_back(p);
  }
  // The balls were meshed in turn or mixed: vertices keep their order, so count those before.
  std::vector<std::uint32_t> place(mesh.positions.size());
  for (std::uint32_t v = 0, next = 0; v < place.size(); ++v) {
    place[v] = next;
    next += mesh.positions[v].x() <= 4;
  }
  for (auto& t : partial.triangles) {
    for (std::uint32_t& v : t) v = place[v];
  }
  partial.positions = kept;
  holds = !verdict("a ball left out:", partial) && holds;
  return step::claim("the certificate holds for the mesh and for none of the others", holds);
}

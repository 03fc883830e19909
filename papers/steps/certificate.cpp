// Section 2.2 and papers/certificate.md, certify/certificate.h: a certificate, and what it refuses.
//
// The mesh of three balls, two of them joined, is certified from its coordinates and triangles
// alone: [L], [U], so angles above arcsin(1 / Q^2), and as many components and handles as the balls
// have. Then a triangle is turned round, a vertex is moved by a hundredth, a ball is left out.

#include "morskin/pipeline.h"
#include "papers/steps/step.h"

int main() {
  using namespace morskin;
  const PreparedSkin skin = prepare_skin({{{-1, 0, 0}, 2.0}, {{1, 0, 0}, 2.0}, {{6, 0, 0}, 1.5}});
  const geometry::IndexedMesh mesh = make_mesh(skin).mesh;
  const certify::Certificate good = certify::certify(mesh, skin.surface, skin.topology);
  std::printf("[L] %.3f (above 1), [U] %.3f (below 1), smallest angle %.1f (bound %.2f)\n",
              good.worst_L, good.worst_U, good.min_angle_deg, certify::Sizing{}.angle_bound_deg());
  std::printf("V - E + F = %ld, expected %ld\n", good.euler_characteristic,
              good.expected_euler_characteristic);
  bool holds = good.worst_L > 1 && good.worst_U < 1 && good.euler_characteristic == 4 &&
               good.min_angle_deg > certify::Sizing{}.angle_bound_deg();

  // [excerpt: step-certificate]
  const auto is_certified = [&](const char* what, const geometry::IndexedMesh& some) {
    const auto certificate = certify::certify(some, skin.surface, skin.topology);
    std::printf("%s: %s\n", what, certificate.certified ? "certified" : certificate.reason.c_str());
    return certificate.certified;
  };
  // [/excerpt]
  holds = is_certified("as meshed", mesh) && holds;

  geometry::IndexedMesh turned = mesh;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  holds = !is_certified("one triangle turned round", turned) && holds;

  geometry::IndexedMesh moved = mesh;
  moved.positions[3] *= 1.01;
  holds = !is_certified("one vertex moved", moved) && holds;

  geometry::IndexedMesh partial;  // without the ball at x = 6
  const auto is_kept = [&](std::uint32_t v) { return mesh.positions[v].x() < 4; };
  std::vector<std::uint32_t> index;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    index.push_back(static_cast<std::uint32_t>(partial.positions.size()));
    if (is_kept(v)) partial.positions.push_back(mesh.positions[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    if (is_kept(a)) partial.triangles.push_back({index[a], index[b], index[c]});
  }
  holds = !is_certified("a ball left out", partial) && holds;
  return step::claim("the certificate holds for the mesh and for none of the others", holds);
}

#include <cstdio>

#include "morskin/mesh_skin.h"

int main() {
  // Two balls by centre (Angstrom) and weight (Angstrom^2).
  const morskin::MeshResult result = morskin::mesh_skin({{{0, 0, 0}, 4.0}, {{1.5, 0, 0}, 5.0}});
  std::printf("%zu triangles, smallest angle %.1f degrees, %s\n", result.mesh.triangles.size(),
              result.certificate.min_angle_deg, result.certificate.reason.c_str());
  return result.certificate.certified ? 0 : 1;
}

#include <morskin/morskin.h>

#include <cstdio>

int main() {
  const morskin::Skin skin({{{{0, 0, 0}, 1.4}, {{1.5, 0, 0}, 1.6}}},
                           {.model = morskin::Model::Vdw});
  const morskin::SkinMesh mesh = skin.mesh({.C = 0.1});
  std::printf("%zu triangles, smallest angle %.1f degrees, %s\n", mesh.triangles().triangles.size(),
              mesh.certificate().min_angle_deg, mesh.certificate().reason.c_str());
  return mesh.certificate().certified ? 0 : 1;
}

// From a molecule's file to a certified mesh: mesh_a_molecule MOLECULE OUT.ply
//
// Prints what is proved. Exit code 0 if it is, 1 if the mesh was left as OUT.ply.unverified, 2 on
// an error, which the text tells.

#include <morskin/morskin.h>

#include <cstdio>
#include <exception>

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "mesh_a_molecule MOLECULE OUT.ply\n");
    return 2;
  }
  try {
    const morskin::Skin skin(morskin::read_molecule(words[1]), {.model = morskin::Model::Sas});
    const morskin::SkinMesh mesh = skin.mesh({.C = 0.2}, {.threads = 2});
    mesh.write(words[2]);
    const morskin::Certificate& certificate = mesh.certificate();
    std::printf("%zu triangles, %s, genus %zu, angles from %.1f degrees, area %.2f A^2\n",
                mesh.triangles().triangles.size(),
                certificate.certified ? "certified" : certificate.reason.c_str(), skin.genus(),
                certificate.min_angle_deg, certificate.area);
    return certificate.certified ? 0 : 1;
  } catch (const std::exception& error) {  // morskin::Error, or memory or threads that are short
    std::fprintf(stderr, "mesh_a_molecule: %s\n", error.what());
    return 2;
  }
}

// papers/library.md, morskin/morskin.h: the library in a program of its users.
//
// A molecule is read, its solvent-accessible skin is prepared, meshed and certified, written and
// read back, asked for what lies at its vertices, and a run is stopped half way.

#include <morskin/morskin.h>

#include <algorithm>
#include <filesystem>

#include "papers/steps/step.h"

int main() {
  using namespace morskin;
  // [excerpt: library-skin]
  const std::vector<Atom> atoms = read_molecule("bench/molecules/caffeine.xyz");
  const Skin skin(atoms, {.model = Model::Sas, .probe = 1.4}, {.threads = 2});
  std::printf("%zu atoms, %zu component, genus %zu\n", atoms.size(), skin.components(),
              skin.genus());
  // [/excerpt]

  // [excerpt: library-mesh]
  const SkinMesh mesh = skin.mesh({.C = 0.2, .angle_goal_deg = 30}, {.threads = 2});
  const Certificate& certificate = mesh.certificate();
  std::printf("%zu triangles, %s, angles from %.1f degrees\n", mesh.triangles().triangles.size(),
              certificate.certified ? "certified" : certificate.reason.c_str(),
              certificate.min_angle_deg);
  // [/excerpt]

  // [excerpt: library-files]
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "caffeine.ply";
  mesh.write(file);
  const Certificate again = skin.certify(read_mesh(file), mesh.sizing(), {.threads = 2});
  std::printf("read back: %s\n", again.certified ? "certified" : again.reason.c_str());
  std::filesystem::remove(file);
  // [/excerpt]

  // [excerpt: library-points]
  std::vector<std::size_t> vertices_of(atoms.size());
  std::size_t saddle_like = 0;
  for (const SkinPoint& p : mesh.points()) {
    ++vertices_of[p.atom];
    saddle_like += p.curvatures[0] * p.curvatures[1] < 0;
  }
  const auto busiest = std::ranges::max_element(vertices_of);
  std::printf("%zu vertices where the skin is saddle-shaped; atom %td has most vertices, %zu\n",
              saddle_like, busiest - vertices_of.begin(), *busiest);
  // [/excerpt]

  // [excerpt: library-morse]
  const MorseSmaleComplex complex = skin.morse_smale(Point{0.3, 0.9, 0.2});
  std::printf("%zu critical points, %zu arcs, %zu regions\n", complex.points.size(),
              complex.arcs.size(), complex.regions.size());
  // [/excerpt]

  // [excerpt: library-errors]
  std::stop_source enough;
  bool is_stopped = false;
  try {
    skin.mesh({.C = 0.02}, {.progress =
                                [&](std::string_view stage, double) {
                                  if (stage == "sweep") enough.request_stop();
                                },
                            .stop = enough.get_token()});
  } catch (const Error& error) {
    is_stopped = error.kind() == Error::Kind::Stopped;
    std::printf("no mesh: %s\n", error.what());
  }
  // [/excerpt]
  return step::claim("meshed, certified twice, and stopped on request",
                     certificate.certified && again.certified && is_stopped);
}

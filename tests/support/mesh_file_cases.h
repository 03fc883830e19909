#pragma once

/// What tests of mesh files write and read again: two tetrahedra, in formats of every kind; and
/// whether what is wrong is turned down.

#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "tests/support/test.h"

namespace morskin::support {

using namespace geometry;

/// Coordinates that decimal text gets wrong unless it is careful.
inline IndexedMesh awkward_tetrahedron() {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  return {{{0.1, -1.0 / 3, 1e-300}, {1e300, 2, -0.0}, {tiny, 123456789.123456789, 0}, {-1, -2, -3}},
          {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{2, 3, 0}}}};
}

/// Coordinates that single precision holds.
inline IndexedMesh plain_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}},
          {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
}

inline constexpr MeshFormat read_formats[] = {
    MeshFormat::PlyBinary, MeshFormat::PlyAscii, MeshFormat::Off, MeshFormat::Obj,
    MeshFormat::Stl,       MeshFormat::Vtu,      MeshFormat::Msh};

inline std::string ending_of(MeshFormat format) {
  constexpr std::array names{"mesh.ply", "mesh.ply", "mesh.off", "mesh.obj", "mesh.stl",
                             "mesh.vtu", "mesh.glb", "mesh.npz", "mesh.msh"};  // as declared
  return names.at(static_cast<std::size_t>(format));
}

/// The message with which a file is turned down; "" if it is read.
inline std::string complaint(const std::string& bytes, const std::string& name) {
  try {
    parse_mesh(bytes, name);
    return "";
  } catch (const UnreadableInput& error) {
    return error.what();
  }
}

inline void check_refused(const std::string& bytes, const std::string& name,
                          const std::string& part) {
  const std::string reason = complaint(bytes, name);
  CAPTURE(reason);
  CHECK(!reason.empty());
  CHECK(contains(reason, part));
}

inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  return text.replace(text.find(old), old.size(), by);
}

}  // namespace morskin::support

#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace morskin::fuzz {

/// The names, and so the formats, that the first byte of an input chooses from. New ones go to the
/// end, so that the seeds keep theirs.
inline constexpr std::array molecule_names = {"a.pdb",  "a.cif", "a.pqr", "a.xyz",
                                              "a.xyzr", "a",     "a.xyzw"};
inline constexpr std::array mesh_names = {"a.ply", "a.off", "a.obj", "a.stl",
                                          "a.vtu", "a.msh", "a"};

/// The two highest bits play no part; they are for choices of another kind.
inline std::string molecule_name(std::uint8_t first) {
  return molecule_names[(first & 63) % molecule_names.size()];
}

inline std::string mesh_name(std::uint8_t first) { return mesh_names[first % mesh_names.size()]; }

}  // namespace morskin::fuzz

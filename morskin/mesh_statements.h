#pragma once

/// What the library's mesh files say of themselves, under the keys of papers/provenance.md. It does
/// not know the file of the atoms and how they were chosen, and leaves hashes to the command.

#include <string_view>

#include "geometry/provenance.h"

namespace morskin {

struct MeshOptions;
struct SkinOptions;

constexpr std::string_view certified_verdict = "certified", other_verdict = "not certified";
/// Of STL and GLB, in single precision, and of MSMS's files with --decimals: they hold no point of
/// the skin, and are not certified themselves.
constexpr std::string_view rounded_verdict = "certified before rounding";

/// @param sizing  as SkinMesh::sizing() tells it
geometry::Provenance statements(const SkinOptions& skin, const MeshOptions& sizing,
                                std::string_view verdict);

}  // namespace morskin

#include "app/rounded_outputs.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "app/output_names.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "morskin/rounded_mesh.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::MeshFormat;

/// The mesh as a file stores it, if that is another.
std::optional<IndexedMesh> stored(const IndexedMesh& mesh, MeshFormat format,
                                  const std::optional<int>& decimals) {
  if (is_single(format)) return geometry::in_single_precision(mesh);
  if (format != MeshFormat::MsmsVertices || !decimals) return std::nullopt;
  return geometry::with_decimals(mesh, *decimals);
}

/// Who counts columns would read wrong numbers where one is wider than they are.
void check_columns(const IndexedMesh& rounded, const std::filesystem::path& output) {
  constexpr double below = -1e4, above = 1e5;  // four digits and a sign before the point
  constexpr std::size_t most_vertices = 9'999'999;
  const bool fits = std::ranges::all_of(rounded.positions, [&](const geometry::Point& at) {
    return at.minCoeff() > below && at.maxCoeff() < above;
  });
  if (fits && rounded.positions.size() <= most_vertices) return;
  throw geometry::RefusedInput(
      output.string() + ": its columns, which --decimals asks for, hold " +
      (fits ? "numbers of at most 9,999,999 vertices; leave it out, or ask for larger triangles"
            : "coordinates above -10,000 and below 100,000 Angstrom; leave it out, or move the "
              "molecule nearer to the origin"));
}

}  // namespace

void check_rounded_outputs(const IndexedMesh& mesh, const MeshArguments& arguments) {
  // Who asks for decimals gets what they make of the angles, and the file says that it is rounded.
  constexpr double any = 180;
  for (const std::filesystem::path& output : arguments.outputs) {
    const MeshFormat format = format_of(output);
    const auto rounded = stored(mesh, format, arguments.decimals);
    if (!rounded) continue;
    const bool is_msms_file = format == MeshFormat::MsmsVertices;
    if (is_msms_file) check_columns(*rounded, output);
    const std::size_t spoilt = morskin::count_spoilt(
        mesh, *rounded, is_msms_file ? any : morskin::single_precision_loss_deg);
    if (spoilt == 0) continue;
    const std::string digits = is_msms_file
                                   ? "with --decimals " + std::to_string(*arguments.decimals)
                                   : "in single precision, all that the format has";
    const std::string way_out =
        is_msms_file ? "give more --decimals or none"
                     : "write another format, or move the molecule nearer to the origin";
    throw geometry::RefusedInput(output.string() + ": " + digits + ", " + std::to_string(spoilt) +
                                 " of " + std::to_string(mesh.triangles.size()) +
                                 " triangles would be turned over or needles; " + way_out +
                                 ", or ask for larger triangles, as by --density");
  }
}

}  // namespace morskin::app

// What the library's face tells of a skin beside meshes: of its points, and of heights on it.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "certify/located_vertices.h"
#include "certify/tube.h"
#include "geometry/exact_range.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/text_lines.h"
#include "geometry/mesh_shape.h"
#include "morse/simplification.h"
#include "morskin/boundary.h"
#include "morskin/mesh_attributes.h"
#include "morskin/mesh_statements.h"
#include "morskin/rounded_mesh.h"
#include "morskin/traced_complex.h"
#include "skin/atom_shares.h"
#include "skin/curvatures.h"

namespace morskin {

namespace {

using morskin::outside;  // not hidden by those below

SkinPoint outside(const skin::SkinSurface& skin, const surface::SurfacePoint& x,
                  std::uint32_t component) {
  const auto [curvatures, directions] =
      skin.with_patch(x.cell, [&](const skin::Patch& patch) { return skin::curvatures(patch, x); });
  SkinPoint result{.normal = outside(x.normal),
                   .length_scale = x.length_scale,
                   .curvatures = curvatures,
                   .directions = {outside(directions[0]), outside(directions[1])},
                   .atom = skin.nearest_atom(x.position, x.cell).value,
                   .atoms = {-1, -1, -1, -1},
                   .shares = {},
                   .component = component};
  const skin::AtomShares shares = skin::atom_shares(skin, x);
  for (std::size_t i = 0; i < shares.size; ++i) {
    result.atoms[i] = static_cast<std::int32_t>(shares.atoms[i].value);
    result.shares[i] = shares.shares[i];
  }
  return result;
}

std::vector<CriticalPoint> outside(const std::vector<morse::CriticalPoint>& points) {
  std::vector<CriticalPoint> result;
  result.reserve(points.size());
  for (const morse::CriticalPoint& p : points) {
    result.push_back({outside(p.point.position), p.index, p.value});
  }
  return result;
}

MorseSmaleComplex outside(const morse::MorseSmaleComplex& complex) {
  MorseSmaleComplex result;
  result.points = outside(complex.points);
  for (const morse::Arc& arc : complex.arcs) {
    result.arcs.push_back({arc.saddle.value, arc.extremum.value});
  }
  result.arc_points.reserve(complex.line_points.size());
  for (const geometry::Point& p : complex.line_points) result.arc_points.push_back(outside(p));
  result.arc_offsets = complex.first_point;
  for (const auto& [a, b, c, d] : complex.regions) {
    result.regions.push_back({a.value, b.value, c.value, d.value});
  }
  return result;
}

/// The points that survive, numbered anew, and what joins them.
morse::MorseSmaleComplex surviving(morse::Simplification simplified) {
  morse::MorseSmaleComplex complex = std::move(simplified.complex);
  std::vector<morse::CriticalId> number;
  std::vector<morse::CriticalPoint> points;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    number.push_back(morse::CriticalId{points.size()});
    if (simplified.survives[i]) points.push_back(std::move(complex.points[i]));
  }
  complex.points = std::move(points);
  for (morse::Arc& arc : complex.arcs) {
    arc.saddle = number[arc.saddle.index()];
    arc.extremum = number[arc.extremum.index()];
  }
  for (auto& region : complex.regions) {
    for (morse::CriticalId& corner : region) corner = number[corner.index()];
  }
  return complex;
}

/// The format of a file with data by vertex.
geometry::MeshFormat format_with_data(const std::filesystem::path& file) {
  const std::optional<geometry::MeshFormat> format = geometry::mesh_format_of(file);
  if (format && geometry::has_vertex_data(*format)) return *format;
  throw geometry::RefusedInput(file.string() +
                               ": only .ply, .vtu, .glb, .npz and .msh hold data by vertex");
}

bool is_msms(geometry::MeshFormat format) {
  return format == geometry::MeshFormat::MsmsVertices || format == geometry::MeshFormat::MsmsFaces;
}

/// The format of a file without other data.
geometry::MeshFormat format_of(const std::filesystem::path& file) {
  const std::optional<geometry::MeshFormat> format = geometry::mesh_format_of(file);
  return format && is_msms(*format) ? *format : geometry::plain_format_of(file);
}

/// Whether a format has a place for normals.
bool has_normals(geometry::MeshFormat format) {
  return format == geometry::MeshFormat::Npz || format == geometry::MeshFormat::Glb ||
         is_msms(format);
}

/// Writes MSMS's two files, either of which is named. They get their names once both are whole.
/// @return the name of that one
std::filesystem::path write_pair(const std::filesystem::path& file,
                                 const geometry::IndexedMesh& mesh,
                                 const geometry::MeshAttributes& beside, std::string_view ending,
                                 const Run& run) {
  std::vector<geometry::PendingFile> files;
  for (const auto& path : {file, geometry::msms_partners(file).front()}) {
    if (geometry::is_written_directly(path)) {
      throw geometry::UnwritableOutput(path.string() +
                                       ": is no place for one of two files; use another name");
    }
    const std::string bytes = geometry::serialized(mesh, *geometry::mesh_format_of(path), beside);
    run.report(geometry::unknown_share);
    files.emplace_back(path).write(bytes);
  }
  for (geometry::PendingFile& pending : files) pending.commit(ending);
  return files.front().final_name(ending);
}

std::vector<Datum> data_called(std::span<const std::string> names) {
  std::vector<Datum> data;
  for (const std::string& name : names) {
    if (name == "all") continue;
    const std::optional<Datum> datum = parse_datum(name);
    if (!datum) {
      std::string known;
      for (const Datum d : all_data()) known += std::string(name_of(d)) + ", ";
      throw geometry::RefusedInput("data by vertex are " + known + "or all; not " +
                                   geometry::quoted(name));
    }
    if (std::ranges::find(data, *datum) == data.end()) data.push_back(*datum);
  }
  if (std::ranges::find(names, "all") != names.end()) {
    return {all_data().begin(), all_data().end()};
  }
  return data;
}

geometry::RefusedInput far_from_skin(std::size_t vertex) {
  return geometry::RefusedInput("vertex " + std::to_string(vertex) + " is not near the skin");
}

/// Beyond it nothing lies near a skin, and squares may overflow.
void require_in_range(const geometry::IndexedMesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const geometry::Point& p = mesh.positions[v];
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > geometry::largest_exact) throw far_from_skin(v);
  }
}

/// Whether the flow leads to the skin within half the length scale at x; farther off curvatures say
/// little of the skin.
bool is_near(const skin::SkinSurface& skin, const surface::SurfacePoint& x) {
  constexpr double most = 0.5;
  const double g = std::abs(skin.jet(x.position, x.cell).value);
  return certify::max_flow_path(x.length_scale, g) <= most * x.length_scale;
}

/// @throws geometry::RefusedInput  the mesh is spoilt in single precision
void require_exact_enough(const geometry::IndexedMesh& mesh, const std::filesystem::path& file) {
  const std::size_t spoilt =
      count_spoilt(mesh, geometry::in_single_precision(mesh), single_precision_loss_deg);
  if (spoilt == 0) return;
  throw geometry::RefusedInput(
      file.string() + ": in single precision, all that the format has, " + std::to_string(spoilt) +
      " of " + std::to_string(mesh.triangles.size()) +
      " triangles would be turned over or needles; write another format, or move the atoms nearer "
      "to the origin");
}

std::optional<morse::MorseFunction> height_along(const std::optional<Point>& direction) {
  if (!direction) return std::nullopt;
  return morse::MorseFunction::height_along(inside(*direction));
}

}  // namespace

std::vector<SkinPoint> Skin::points(const TriangleMesh& mesh) const {
  return with_errors([&] {
    const geometry::IndexedMesh from = inside(mesh);
    const skin::SkinSurface& surface = prepared_->skin.surface;
    const std::vector<std::uint32_t> component = geometry::vertex_components(from);
    require_in_range(from);
    const std::vector<surface::SurfacePoint> points = certify::locate_vertices(from, surface);
    std::vector<SkinPoint> result;
    result.reserve(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (!is_near(surface, points[v])) throw far_from_skin(v);
      result.push_back(outside(surface, points[v], component[v]));
    }
    return result;
  });
}

std::vector<CriticalPoint> Skin::critical_points(const std::optional<Point>& direction) const {
  return with_errors([&] {
    const PreparedSkin& skin = prepared_->skin;
    return outside(choose_function(skin, height_along(direction)).critical.points);
  });
}

MorseSmaleComplex Skin::morse_smale(const std::optional<Point>& direction, const RunOptions& run,
                                    Simplify simplify) const {
  return with_errors([&] {
    if (simplify != Simplify::Not && simplify != Simplify::ShortArcs) {
      throw geometry::RefusedInput("to simplify is neither Not nor ShortArcs");
    }
    const PreparedSkin& skin = prepared_->skin;
    const morse::MorseSmaleComplex traced =
        trace_complex(skin, height_along(direction), inside(run)).complex;
    if (simplify == Simplify::Not) return outside(traced);
    const double share = sphere_share(skin.surface, certify::Sizing());
    return outside(surviving(morse::contract_short_arcs(traced, share)));
  });
}

std::filesystem::path SkinMesh::write(const std::filesystem::path& file,
                                      std::span<const std::string> vertex_data,
                                      const RunOptions& run) const {
  const Run steps = inside(run);
  const auto work = [&] {
    const geometry::IndexedMesh mesh = inside(triangles());
    const bool is_certified = certificate().certified;
    const std::string_view ending = is_certified ? "" : ".unverified";
    const geometry::MeshFormat format =
        vertex_data.empty() ? format_of(file) : format_with_data(file);
    const bool is_single = geometry::is_single(format);
    if (is_single && is_certified) require_exact_enough(mesh, file);
    geometry::MeshAttributes beside;
    if (!vertex_data.empty() || has_normals(format)) {
      const skin::SkinSurface& skin = skin_.prepared_->skin.surface;
      const auto cells = certify::cells_of(certify::locate_vertices(mesh, skin, steps));
      steps.report(geometry::unknown_share);
      beside = mesh_attributes(skin, mesh, cells, data_called(vertex_data));
      beside.normals = skin_normals(skin, mesh, cells);
      if (is_msms(format)) beside.msms = msms_columns(skin, mesh, cells);
      steps.report(geometry::unknown_share);
    }
    const std::string_view verdict = is_single ? rounded_verdict : certified_verdict;
    beside.provenance =
        statements(skin_.prepared_->options, sizing(), is_certified ? verdict : other_verdict);
    if (is_msms(format)) return write_pair(file, mesh, beside, ending, steps);
    const std::string bytes = geometry::serialized(mesh, format, beside);
    steps.report(geometry::unknown_share);
    std::filesystem::path name = file;
    name += ending;
    geometry::write_file_atomically(name, bytes);
    return name;
  };
  return with_errors([&] { return steps.stage("write", work); });
}

}  // namespace morskin

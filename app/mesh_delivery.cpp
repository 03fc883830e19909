#include "app/mesh_delivery.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "app/output_names.h"
#include "app/snapshots.h"
#include "geometry/error.h"
#include "geometry/stopwatch.h"
#include "morskin/feature_data.h"
#include "morskin/mesh_statements.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::MeshFormat;

/// Whether a file is read back in full: one that `check` reads, without loss.
bool keeps_coordinates(MeshFormat format, const MeshArguments& arguments) {
  switch (format) {
    case MeshFormat::PlyBinary:
    case MeshFormat::PlyAscii:
    case MeshFormat::Off:
    case MeshFormat::Obj:
    case MeshFormat::Vtu:
    case MeshFormat::Msh:
      return true;
    case MeshFormat::MsmsVertices:
      return !arguments.decimals;
    default:
      return false;
  }
}

}  // namespace

void MeshDelivery::guided(const morse::Guide& guide) {
  if (!arguments_.has_snapshots()) return;
  snapshots_.emplace(guide, arguments_.snapshot_values, arguments_.snapshots,
                     [this](const front::Snapshot& snapshot) {
                       outputs_.undisturbed([&] {
                         write_snapshot(arguments_.snapshot_folder, ++snapshots_written_, snapshot);
                       });
                     });
}

std::vector<front::SweepObserver*> MeshDelivery::sweep_observers() {
  if (!snapshots_) return {};
  return {&*snapshots_};
}

geometry::MeshAttributes MeshDelivery::attributes(const IndexedMesh& mesh,
                                                  std::span<const geometry::CellId> cells) const {
  const auto is_any = [&](auto... formats) {
    return std::ranges::any_of(arguments_.outputs, [&](const std::filesystem::path& path) {
      return ((format_of(path) == formats) || ...);
    });
  };
  geometry::MeshAttributes result;
  if (skin_ == nullptr) return result;
  if (std::ranges::any_of(arguments_.outputs, takes_vertex_data)) {
    result = mesh_attributes(*skin_, mesh, cells, arguments_.vertex_data.data, properties_);
  }
  result.arrays = arrays_;
  if (arguments_.vertex_data.features) {
    result.vertices.push_back(mass_attribute(mesh));
    if (is_any(MeshFormat::Npz)) {
      std::ranges::move(laplacian_arrays(mesh), std::back_inserter(result.arrays));
    }
  }
  if (is_any(MeshFormat::MsmsVertices, MeshFormat::Glb, MeshFormat::Npz)) {
    result.normals = skin_normals(*skin_, mesh, cells);
  }
  if (is_any(MeshFormat::MsmsVertices)) {
    result.msms = msms_columns(*skin_, mesh, cells);
    result.msms.decimals = arguments_.decimals;
  }
  return result;
}

std::string MeshDelivery::write(const IndexedMesh& mesh, std::span<const geometry::CellId> cells,
                                bool is_certified) {
  std::string written;
  geometry::timed(seconds_writing_, [&] {
    geometry::MeshAttributes beside = attributes(mesh, cells);
    curve(mesh, cells);
    for (geometry::PendingFile& file : files_) {
      const MeshFormat format = format_of(file.path());
      beside.provenance = origin_.provenance(hashes(mesh, format), verdict(format, is_certified));
      written = std::string();  // one at a time
      written = bytes(mesh, format, beside);
      file.write(written);
    }
  });
  return written;
}

void MeshDelivery::curve(const IndexedMesh& mesh, std::span<const geometry::CellId> cells) {
  if (arguments_.order != 2) return;
  curved_.reset();
  try {
    curved_ = second_order(*skin_, mesh, cells);
  } catch (const geometry::RefusedInput& error) {
    not_curved_ = error.what();
  }
}

std::optional<CurvedReport> MeshDelivery::curved() const {
  if (arguments_.order != 2) return std::nullopt;
  if (!curved_)
    throw geometry::RefusedInput(arguments_.molecule.input.string() + ": " + not_curved_);
  return CurvedReport{curved_->mesh.nodes.size(), curved_->measures, ""};
}

std::string MeshDelivery::bytes(const IndexedMesh& mesh, MeshFormat format,
                                const geometry::MeshAttributes& beside) const {
  // Without curved triangles the run is refused, and this file is never named.
  if (!curved_ || !geometry::has_second_order(format)) {
    return geometry::serialized(mesh, format, beside);
  }
  return geometry::serialized(curved_->mesh, format, curved_attributes(beside));
}

geometry::MeshAttributes MeshDelivery::curved_attributes(
    const geometry::MeshAttributes& flat) const {
  const std::vector<geometry::Point>& nodes = curved_->mesh.nodes;
  const std::size_t vertices = nodes.size() - curved_->ends.size();
  const auto first = static_cast<std::ptrdiff_t>(vertices);
  const IndexedMesh in_edges{{nodes.begin() + first, nodes.end()}, {}};
  const std::span<const geometry::CellId> cells(curved_->cells);
  const geometry::MeshAttributes added = mesh_attributes(*skin_, in_edges, cells.subspan(vertices),
                                                         arguments_.vertex_data.data, properties_);
  geometry::MeshAttributes result = flat;
  for (std::size_t i = 0; i < result.vertices.size(); ++i) {
    geometry::Attribute& attribute = result.vertices[i];
    if (attribute.name != name_of(Datum::Component)) {
      const std::vector<double>& numbers = added.vertices[i].numbers;
      attribute.numbers.insert(attribute.numbers.end(), numbers.begin(), numbers.end());
      continue;
    }
    for (const std::uint32_t end : curved_->ends) {  // connectivity decides, not the place
      for (std::size_t k = 0; k < attribute.columns.size(); ++k) {
        attribute.numbers.push_back(attribute.numbers[end * attribute.columns.size() + k]);
      }
    }
  }
  return result;
}

bool MeshDelivery::complete(const morskin::MeshResult& result,
                            std::vector<std::filesystem::path>& names) {
  const IndexedMesh& mesh = result.mesh;
  const bool is_certified = result.certificate.certified;
  if (!is_certified) {
    if (mesh.positions.size() != result.cells.size()) return false;
    write(mesh, result.cells, false);
  }
  for (const geometry::PendingFile& file : files_) {
    names.push_back(file.final_name(is_certified ? "" : unverified));
    if (!is_certified && file.path() == certified_file_) certified_file_ = names.back().string();
  }
  for (const std::filesystem::path& path : arguments_.outputs) {
    if (!is_certified || !geometry::is_written_directly(path)) continue;
    const MeshFormat format = format_of(path);
    geometry::MeshAttributes beside = attributes(mesh, result.cells);
    beside.provenance = origin_.provenance(hashes(mesh, format), verdict(format, true));
    geometry::write_file_atomically(path, bytes(mesh, format, beside));
    names.push_back(path);
  }
  return true;
}

geometry::Provenance MeshDelivery::provenance(const morskin::MeshResult& result) {
  constexpr MeshFormat exact = MeshFormat::PlyBinary;
  return origin_.provenance(hashes(result.mesh, exact),
                            verdict(exact, result.certificate.certified));
}

std::string_view MeshDelivery::verdict(MeshFormat format, bool is_certified) const {
  if (!is_certified) return other_verdict;
  const bool is_rounded = is_single(format) || (arguments_.decimals && is_msms(format));
  return is_rounded ? rounded_verdict : certified_verdict;
}

const MeshHashes& MeshDelivery::hashes(const IndexedMesh& mesh, MeshFormat format) {
  const bool is_rounded = arguments_.decimals && is_msms(format);
  // All other files store the same numbers.
  if (!is_single(format)) format = is_rounded ? MeshFormat::MsmsVertices : MeshFormat::PlyBinary;
  const auto [place, is_new] = hashes_.try_emplace(format);
  if (!is_new) return place->second;
  const Stored stored = format == MeshFormat::Stl   ? Stored::FloatCorners
                        : format == MeshFormat::Glb ? Stored::Floats
                                                    : Stored::Doubles;
  place->second = is_rounded ? hashes_of(geometry::with_decimals(mesh, *arguments_.decimals),
                                         stored, arguments_.threads)
                             : hashes_of(mesh, stored, arguments_.threads);
  return place->second;
}

morskin::Observer::Delivery MeshDelivery::deliver(IndexedMesh mesh,
                                                  std::span<const geometry::CellId> cells) {
  hashes_.clear();
  std::string written = write(mesh, cells, true);
  Delivery delivery{std::move(mesh), {}};
  try {
    read_back(delivery, std::move(written));
  } catch (const geometry::UnreadableInput& error) {
    delivery.defect = error.what();
  }
  return delivery;
}

const geometry::PendingFile* MeshDelivery::faces_of(const geometry::PendingFile& file) const {
  const std::filesystem::path partner = msms_partner(file.path());
  const auto found = std::ranges::find_if(files_, [&](const geometry::PendingFile& other) {
    return is_same_file(other.path(), partner);
  });
  return found == files_.end() ? nullptr : &*found;
}

IndexedMesh MeshDelivery::content_of(const geometry::PendingFile& file,
                                     std::string& written) const {
  if (&file != &files_.back()) {
    return parsed(geometry::read_file(file.temporary_name()).view(), file);
  }
  file.read_again(written);
  return parsed(written, file);
}

IndexedMesh MeshDelivery::parsed(std::string_view bytes, const geometry::PendingFile& file) const {
  const MeshFormat format = format_of(file.path());
  if (format != MeshFormat::MsmsVertices) {
    const std::string name = file.path().string();
    geometry::MeshFile content = geometry::parse_mesh_file(bytes, name);
    const bool is_curved = curved_ && geometry::has_second_order(format);
    if (is_curved ? content.curved != curved_->mesh : content.curved.has_value()) {
      throw geometry::UnreadableInput(name + ": does not hold the curved triangles");
    }
    return std::move(content.mesh);
  }
  const geometry::PendingFile& faces = *faces_of(file);
  return geometry::parse_msms(bytes, file.path().string(),
                              geometry::read_file(faces.temporary_name()).view(),
                              faces.path().string());
}

void MeshDelivery::read_back(Delivery& delivery, std::string written) {
  certified_file_.clear();
  for (const geometry::PendingFile& file : files_) {
    const MeshFormat format = format_of(file.path());
    if (!keeps_coordinates(format, arguments_)) continue;
    // MSMS's two files are read together; one that goes into a pipe is not there to be read.
    if (format == MeshFormat::MsmsVertices && faces_of(file) == nullptr) continue;
    if (certified_file_.empty()) {
      certified_file_ = file.path().string();
      delivery.mesh = {};  // one copy at a time
      delivery.mesh = content_of(file, written);
    } else if (delivery.mesh != content_of(file, written)) {
      delivery.defect = file.path().string() + " does not hold the mesh of " + certified_file_;
    }
  }
  if (!certified_file_.empty()) return;
  certified_file_ = "a binary PLY copy in memory";
  written = std::string();
  written = geometry::serialized(delivery.mesh, MeshFormat::PlyBinary);
  delivery.mesh = {};
  delivery.mesh = geometry::parse_mesh(written, certified_file_);
}

}  // namespace morskin::app

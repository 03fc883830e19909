#include "app/mesh_delivery.h"

#include <utility>

#include "app/snapshots.h"
#include "geometry/error.h"
#include "geometry/stopwatch.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::MeshFormat;

bool keeps_coordinates(MeshFormat format) {
  return format != MeshFormat::Stl && format != MeshFormat::Vtu;
}

IndexedMesh content_of(const geometry::PendingFile& file) {
  return geometry::parse_mesh(geometry::read_file(file.temporary_name()).view(),
                              file.path().string());
}

}  // namespace

MeshFormat format_of(const std::filesystem::path& path) {
  return geometry::mesh_format_of(path).value_or(MeshFormat::PlyBinary);
}

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

morskin::Observer::Delivery MeshDelivery::deliver(IndexedMesh mesh) {
  geometry::timed(seconds_writing_, [&] {
    for (geometry::PendingFile& file : files_) {
      file.write(geometry::serialized(mesh, format_of(file.path())));
    }
  });
  Delivery delivery{std::move(mesh), {}};
  try {
    read_back(delivery);
  } catch (const geometry::UnreadableInput& error) {
    delivery.defect = error.what();
  }
  return delivery;
}

void MeshDelivery::read_back(Delivery& delivery) {
  certified_file_.clear();
  for (const geometry::PendingFile& file : files_) {
    if (!keeps_coordinates(format_of(file.path()))) continue;
    if (certified_file_.empty()) {
      certified_file_ = file.path().string();
      delivery.mesh = {};  // one copy at a time
      delivery.mesh = content_of(file);
    } else if (delivery.mesh != content_of(file)) {
      delivery.defect = file.path().string() + " does not hold the mesh of " + certified_file_;
    }
  }
  if (!certified_file_.empty()) return;
  certified_file_ = "the same mesh as binary PLY, in memory";
  const std::string bytes = geometry::serialized(delivery.mesh, MeshFormat::PlyBinary);
  delivery.mesh = {};
  delivery.mesh = geometry::parse_mesh(bytes, certified_file_);
}

}  // namespace morskin::app

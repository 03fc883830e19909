#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/curved_report.h"
#include "app/mesh_origin.h"
#include "app/staged_outputs.h"
#include "front/snapshots.h"
#include "geometry/files/mesh_files.h"
#include "morskin/observer.h"
#include "morskin/pipeline.h"
#include "morskin/second_order.h"

namespace morskin::app {

/// Writes a mesh to its files, so that what is certified is what they hold; on the way it takes the
/// snapshots that were asked for.
class MeshDelivery : public morskin::Observer {
 public:
  /// @param arguments, outputs, files, skin  must outlive this; the files are those of the mesh
  /// @param skin  nothing for another surface, of which files tell nothing beside the mesh
  /// @param properties, arrays  of atoms, to be told as well
  MeshDelivery(const MeshArguments& arguments, StagedOutputs& outputs,
               std::span<geometry::PendingFile> files, const skin::SkinSurface* skin,
               MeshOrigin origin, std::vector<morskin::AtomProperty> properties,
               std::vector<geometry::NamedArray> arrays)
      : arguments_(arguments),
        outputs_(outputs),
        files_(files),
        skin_(skin),
        origin_(std::move(origin)),
        properties_(std::move(properties)),
        arrays_(std::move(arrays)) {}

  void sized(const certify::Sizing& sizing) override {
    origin_.set_sizing(sizing);
    snapshots_written_ = 0;
  }
  void guided(const morse::Guide& guide) override;
  std::vector<front::SweepObserver*> sweep_observers() override;
  /// Reads back the first file whose format keeps every coordinate; if there is none, the bytes
  /// that a PLY file would have. Other such files must hold the same mesh. All say that they are
  /// certified; they have no name yet.
  Delivery deliver(geometry::IndexedMesh mesh, std::span<const geometry::CellId> cells) override;

  /// Writes what is no regular file or, where the mesh is not certified, the files again, which
  /// then say so.
  /// @param names  gets those of all that holds the mesh, as the files will be called
  /// @return false if the mesh could not be read back, so that there is none to name
  bool complete(const morskin::MeshResult& result, std::vector<std::filesystem::path>& names);

  /// With the hashes of the mesh's doubles.
  geometry::Provenance provenance(const morskin::MeshResult& result);

  /// What was read back.
  const std::string& certified_file() const { return certified_file_; }
  double seconds_writing() const { return seconds_writing_; }
  /// What the last mesh is with curved triangles; nothing unless they were asked for.
  /// @throws geometry::RefusedInput  there are none, with the reason
  std::optional<CurvedReport> curved() const;

 private:
  /// @return what was written to the last file
  std::string write(const geometry::IndexedMesh& mesh, std::span<const geometry::CellId> cells,
                    bool is_certified);
  /// What is told beside the mesh, as far as one of the outputs takes it; without provenance.
  geometry::MeshAttributes attributes(const geometry::IndexedMesh& mesh,
                                      std::span<const geometry::CellId> cells) const;
  /// Makes the curved triangles if they are asked for, or says why not.
  void curve(const geometry::IndexedMesh& mesh, std::span<const geometry::CellId> cells);
  /// What is told of the nodes of the curved triangles, by what is told of the vertices.
  geometry::MeshAttributes curved_attributes(const geometry::MeshAttributes& flat) const;
  std::string bytes(const geometry::IndexedMesh& mesh, geometry::MeshFormat format,
                    const geometry::MeshAttributes& beside) const;
  /// What a file says of itself.
  std::string_view verdict(geometry::MeshFormat format, bool is_certified) const;
  /// Of the mesh delivered last, as files of a format store it; each kind is computed once.
  const MeshHashes& hashes(const geometry::IndexedMesh& mesh, geometry::MeshFormat format);
  /// @param written  to the last file; its memory is used for what is read
  void read_back(Delivery& delivery, std::string written);
  /// The file of the triangles to MSMS's vertices; nullptr where it goes into a pipe.
  const geometry::PendingFile* faces_of(const geometry::PendingFile& file) const;
  geometry::IndexedMesh content_of(const geometry::PendingFile& file, std::string& written) const;
  geometry::IndexedMesh parsed(std::string_view bytes, const geometry::PendingFile& file) const;

  const MeshArguments& arguments_;
  StagedOutputs& outputs_;
  std::span<geometry::PendingFile> files_;
  const skin::SkinSurface* skin_;
  MeshOrigin origin_;
  std::map<geometry::MeshFormat, MeshHashes> hashes_;
  const std::vector<morskin::AtomProperty> properties_;
  const std::vector<geometry::NamedArray> arrays_;
  std::optional<morskin::SecondOrder> curved_;
  std::string not_curved_;  ///< why there are none
  std::optional<front::Snapshots> snapshots_;
  std::size_t snapshots_written_ = 0;
  std::string certified_file_;
  double seconds_writing_ = 0;
};

}  // namespace morskin::app

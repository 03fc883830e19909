#pragma once

/// Data by vertex or by triangle of a mesh that follow it by themselves, whatever is done to it:
/// insertion, contraction, compaction, appending of another mesh with the same data. New elements
/// have a value given beforehand. Each is a flat array and nothing else.

#include <cstdint>
#include <utility>

#include "geometry/last_visit.h"
#include "geometry/surface_mesh.h"

namespace morskin::geometry {

/// What vertex and triangle data have in common.
template <class Index, class T>
class MeshData : public IdVector<Index, T>, public MeshFollower {
  using Table = IdVector<Index, T>;

 public:
  /// Replaces all values. @pre as many as the mesh has elements, or is about to have
  MeshData& operator=(Table values) {
    Table::operator=(std::move(values));
    return *this;
  }
  MeshData& operator=(const MeshData&) = default;
  MeshData& operator=(MeshData&&) = default;

 protected:
  MeshData(SurfaceMesh& mesh, std::size_t size, const T& fill, bool has_triangles)
      : Table(size, fill), MeshFollower(mesh, has_triangles), fill_(fill) {}
  void resize_filled(std::size_t size) {
    if (size == this->size() + 1) return this->push_back(fill_);  // by far the usual case
    if (size != this->size()) this->resize(size, fill_);
  }
  void reset(Index i) { (*this)[i] = fill_; }
  void append(MeshFollower* other, std::size_t size) {
    if (auto* data = dynamic_cast<MeshData*>(other)) {
      Table& appended = *data;
      visit_last(appended,
                 [&](auto block) { this->insert(this->end(), block.begin(), block.end()); });
      appended = Table();
    }
    resize_filled(size);
  }

 private:
  T fill_;
};

template <class T>
class VertexData : public MeshData<VertexId, T> {
 public:
  /// @param fill  the value of each vertex, now and when it comes to be
  explicit VertexData(SurfaceMesh& mesh, const T& fill = T())
      : MeshData<VertexId, T>(mesh, mesh.vertex_count(), fill, false) {}
  using MeshData<VertexId, T>::operator=;

 private:
  void vertices_resized(std::size_t vertices) override { this->resize_filled(vertices); }
  void reserved(std::size_t vertices) override { this->reserve(vertices); }
  void vertex_removed(VertexId v) override { this->reset(v); }
  void compacted(const Renaming& renaming) override {
    for (std::size_t v = 0; v < this->size(); ++v) {
      const auto kept = renaming.vertices[VertexId{v}];
      if (kept && kept->index() != v) (*this)[*kept] = std::move((*this)[VertexId{v}]);
    }
    this->resize_filled(renaming.vertices_left);
  }
  void appended(MeshFollower* other, std::size_t vertices, std::size_t) override {
    this->append(other, vertices);
  }
};

template <class T>
class TriangleData : public MeshData<TriangleId, T> {
 public:
  /// @param fill  the value of each triangle, now and when it comes to be
  explicit TriangleData(SurfaceMesh& mesh, const T& fill = T())
      : MeshData<TriangleId, T>(mesh, mesh.triangle_count(), fill, true) {}
  using MeshData<TriangleId, T>::operator=;

 protected:
  void triangles_resized(std::size_t triangles) override { this->resize_filled(triangles); }
  void reserved(std::size_t vertices) override { this->reserve(2 * vertices); }
  void triangle_split(TriangleId, TriangleId second, TriangleId third) override {
    this->reset(second);
    this->reset(third);
  }
  void appended(MeshFollower* other, std::size_t, std::size_t triangles) override {
    this->append(other, triangles);
  }

 private:
  void compacted(const Renaming& renaming) override {
    for (std::size_t t = 0; t < this->size(); ++t) {
      if (!renaming.is_removed(TriangleId{t})) {
        const TriangleId kept = renaming(TriangleId{t});
        if (kept.index() != t) (*this)[kept] = std::move((*this)[TriangleId{t}]);
      }
    }
    this->resize_filled(renaming.triangles_left);
  }
};

/// By triangle, the number of triangles laid before it, which is when a replay shows it. A flip
/// changes none. Triangles about an inserted vertex take the latest birth of the triangle split and
/// its neighbours. Appended triangles keep the births of their own mesh.
class TriangleBirths : public TriangleData<std::uint32_t> {
 public:
  using TriangleData<std::uint32_t>::TriangleData;

  /// How many were laid, those counted that are no more. Births are below it.
  std::uint32_t laid() const { return laid_; }

 private:
  void triangles_resized(std::size_t triangles) override {
    while (size() < triangles) push_back(laid_++);
    TriangleData<std::uint32_t>::triangles_resized(triangles);
  }
  void triangle_split(TriangleId first, TriangleId second, TriangleId third) override;
  void appended(MeshFollower* other, std::size_t vertices, std::size_t triangles) override {
    if (const auto* births = dynamic_cast<const TriangleBirths*>(other)) laid_ += births->laid_;
    TriangleData<std::uint32_t>::appended(other, vertices, triangles);
  }

  std::uint32_t laid_ = 0;
};

}  // namespace morskin::geometry

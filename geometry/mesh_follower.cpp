#include "geometry/mesh_follower.h"

#include <algorithm>

#include "geometry/mesh_data.h"

namespace morskin::geometry {

MeshFollower::MeshFollower(SurfaceMesh& mesh, bool has_triangles) : mesh_(&mesh) {
  mesh.followers_.all.push_back(this);
  if (has_triangles) mesh.followers_.with_triangles.push_back(this);
}

MeshFollower::~MeshFollower() {
  if (mesh_ == nullptr) return;
  std::erase(mesh_->followers_.all, this);
  std::erase(mesh_->followers_.with_triangles, this);
}

SurfaceMesh::Followers::~Followers() {
  for (MeshFollower* follower : all) follower->mesh_ = nullptr;
}

void TriangleBirths::triangle_split(TriangleId first, TriangleId second, TriangleId third) {
  const SurfaceMesh& mesh = followed();
  std::uint32_t last = (*this)[first];
  // The first half-edges of the three are those of the triangle that was split.
  for (const TriangleId t : {first, second, third}) {
    const HalfEdgeId edge = SurfaceMesh::half_edge(t, 0);
    if (mesh.is_boundary(edge)) continue;
    last = std::max(last, (*this)[SurfaceMesh::triangle(mesh.twin(edge))]);
  }
  for (const TriangleId t : {first, second, third}) (*this)[t] = last;
}

}  // namespace morskin::geometry

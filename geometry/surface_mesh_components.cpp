// The connected components of a mesh.

#include "geometry/surface_mesh.h"
#include "geometry/union_find.h"

namespace morskin::geometry {

Components components(const SurfaceMesh& mesh) {
  // A triangle takes the label of a neighbour before it, or a new one; labels that meet are one. As
  // the smallest stands for a set, components are numbered by their first triangle.
  Components result;
  result.of_triangle.resize(mesh.triangle_count());
  UnionFind labels(0);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    std::optional<std::uint32_t> label;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      if (mesh.is_boundary(h) || mesh.twin(h) > h) continue;
      const std::uint32_t other = result.of_triangle[SurfaceMesh::triangle(mesh.twin(h)).index()];
      if (label && *label != other) labels.join(*label, other);
      label = other;
    }
    result.of_triangle[t] = label ? *label : labels.add();
  }
  std::vector<std::uint32_t> number(labels.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    number[i] = labels.root(i) == i ? result.count++ : number[labels.root(i)];
  }
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!mesh.is_removed(TriangleId{t})) result.of_triangle[t] = number[result.of_triangle[t]];
  }
  return result;
}

}  // namespace morskin::geometry

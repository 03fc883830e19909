#pragma once

/// Angles, area and volume of a mesh, which need no connectivity.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

/// The cosines of a triangle's angles at p, q and r; NaN at the ends of a side of length zero.
inline std::array<double, 3> cosines(const Vector& pq, const Vector& qr, const Vector& rp) {
  const double x = pq.norm(), y = qr.norm(), z = rp.norm();
  return {-pq.dot(rp) / (x * z), -pq.dot(qr) / (x * y), -qr.dot(rp) / (y * z)};
}

/// The extreme cosines of a triangle's angles, its area, and the signed volume of its tetrahedron
/// with an apex. A side of length zero counts as an angle of 0 and one of 180 degrees.
struct TriangleShape {
  double largest_cosine, smallest_cosine;
  double area;    ///< Angstrom^2
  double volume;  ///< Angstrom^3, of the tetrahedron with `apex`
};
/// @param apex  the same for a whole mesh; near it, to avoid cancellation
TriangleShape triangle_shape(const Point& p, const Point& q, const Point& r, const Point& apex);

struct MeshShape {
  double min_angle_deg = 180, max_angle_deg = 0;
  double area = 0;    ///< Angstrom^2
  double volume = 0;  ///< Angstrom^3 inside a closed mesh, without voids
};
MeshShape measure_shape(const IndexedMesh& mesh);

/// The same for whoever goes through the triangles anyway, some of them at a time.
class ShapeMeasure {
 public:
  /// @param mesh  must outlive this
  explicit ShapeMeasure(const IndexedMesh& mesh) : mesh_(&mesh) {}

  void add(const TriangleCorners& triangle);
  /// All that another has measured of the same mesh.
  void add(const ShapeMeasure& other);
  /// @pre all triangles have been added
  MeshShape shape() const;

 private:
  bool certainly_holds(const Vector& pq, const Vector& qr, const Vector& rp) const;

  const IndexedMesh* mesh_;
  double area_ = 0, volume_ = 0;
  double largest_cosine_ = -1, smallest_cosine_ = 1;  ///< of the extreme angles
};

/// By vertex, the number of its component; they count from 0 in the order of their first vertices.
std::vector<std::uint32_t> vertex_components(const IndexedMesh& mesh);

/// By k from 0 to 17, the number of angles in [10 k, 10 k + 10) degrees; 180 counts in the last.
using AngleHistogram = std::array<std::size_t, 18>;
AngleHistogram angle_histogram(const IndexedMesh& mesh);

}  // namespace morskin::geometry

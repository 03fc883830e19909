#pragma once

/// How good the triangles of a mesh are: the distribution of their angles, valences, radius ratios.
/// From points and triangles alone, of any connectivity; no part of the proof.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "geometry/indexed_mesh.h"
#include "geometry/run.h"

namespace morskin::certify {

/// A triangle with a side of length zero counts as one with the angles 0 and 180 degrees and the
/// ratio 0; so does one with a side whose square is beyond the range of doubles.
struct MeshQuality {
  static constexpr int bin_deg = 5;
  std::size_t vertices = 0, triangles = 0;
  /// By k, the triangles whose smallest angle is in [5 k, 5 k + 5) degrees; 60 is in the last.
  std::array<std::size_t, 12> smallest_angles{};
  /// By k, the triangles whose largest angle is in (60 + 5 k, 65 + 5 k] degrees; 60 is in the
  /// first.
  std::array<std::size_t, 24> largest_angles{};
  /// By k, the vertices that are k corners of triangles, which on a closed mesh have k neighbours;
  /// the last counts those with more too.
  std::array<std::size_t, 10> valences{};
  std::uint32_t min_valence = 0, max_valence = 0;
  /// Twice the radius of the incircle over that of the circumcircle: 1 if equilateral. NaN without
  /// triangles.
  double min_radius_ratio = std::numeric_limits<double>::quiet_NaN();
  double mean_radius_ratio = std::numeric_limits<double>::quiet_NaN();
  /// So long are 5, 50 and 95 of a hundred edges at most. Of a large mesh some edges are taken,
  /// spread evenly over the triangles. NaN without triangles.
  struct EdgeLengths {
    double short_end = std::numeric_limits<double>::quiet_NaN();
    double median = short_end, long_end = short_end;
  } edges;

  /// Triangles with an angle below so many degrees.
  /// @pre a multiple of bin_deg, 0 to 60
  std::size_t triangles_below(int angle_deg) const;
  /// Triangles with an angle above so many degrees.
  /// @pre a multiple of bin_deg, 60 to 180
  std::size_t triangles_above(int angle_deg) const;
};

/// O(n), and the same for any number of threads.
MeshQuality measure_quality(const geometry::IndexedMesh& mesh,
                            const geometry::Run& run = geometry::Run());

}  // namespace morskin::certify

#pragma once

/// The data of a viewer page: named arrays, packed, and a JSON object that describes them.
/// Reader: `viewer/src/page_data.js`; the arrays of a page are listed in `papers/viewer.md`.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::app {

/// Multiples of `step` from `origin`: a position is three integers below 2^24, exact in single
/// precision.
struct Grid {
  geometry::Point origin = geometry::Point::Zero();
  double step = 1;  ///< Angstrom

  std::array<std::int32_t, 3> nearest(const geometry::Point& p) const;
};
/// @return a grid about the points with a step of at most `wanted` and at least 1,024 steps, as
///         far as 24 bits go
Grid grid_about(std::span<const geometry::Point> points, double wanted);
/// @return a grid about the mesh on which its shortest edge is at least 64 steps long, as far as 24
///         bits go
Grid grid_of(const geometry::IndexedMesh& mesh);

class PageData {
 public:
  /// Integers, split by byte so that deflate finds the high bytes, which are mostly zero.
  void add(const std::string& name, const std::vector<std::uint32_t>& numbers);
  /// The same for signed ones: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
  void add(const std::string& name, const std::vector<std::int32_t>& numbers);
  void add(const std::string& name, const std::vector<std::uint8_t>& bytes);
  void add(const std::string& name, const std::vector<double>& numbers);
  void add(const std::string& name, const std::vector<float>& numbers);
  /// UTF-8; what is not is shown as replacement characters.
  void add(const std::string& name, const std::string& text);

  nlohmann::ordered_json about;  ///< for people and for the page: names, counts, options

  /// The page: the viewer with these data in it.
  /// @throws geometry::LimitReached  for more than 2 GB
  std::string page() const;

 private:
  void add_entry(const std::string& name, std::string_view kind, std::size_t count,
                 std::size_t planes);

  nlohmann::ordered_json entries_ = nlohmann::ordered_json::array();
  std::string bytes_;
};

}  // namespace morskin::app

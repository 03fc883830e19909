// The order in which points enter a triangulation, and the curve behind it.

#include "geometry/spatial_order.h"

#include <cmath>

#include "tests/support/triangulations.h"

using namespace morskin::geometry;
using namespace morskin::support;

TEST_CASE("the Hilbert curve visits every cell once, each next to the last") {
  constexpr int bits = 4;
  constexpr std::uint32_t side = 1u << bits;
  std::vector<Eigen::Vector3i> cells(side * side * side, Eigen::Vector3i(-9, -9, -9));
  for (std::uint32_t x = 0; x < side; ++x) {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t z = 0; z < side; ++z) {
        cells[hilbert_index(x, y, z, bits)] = Eigen::Vector3d(x, y, z).cast<int>();
      }
    }
  }
  for (std::size_t i = 1; i < cells.size(); ++i) {
    CHECK((cells[i] - cells[i - 1]).lpNorm<1>() == 1);
  }
}

TEST_CASE("the spatial order holds every id once") {
  const Points points = random_points(1, 5000, 1);
  std::vector<AtomId> order = spatial_order(points).ids;
  CHECK(order == spatial_order(points).ids);
  std::sort(order.begin(), order.end());
  REQUIRE(order.size() == points.size());
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(order[i] == AtomId(i));
}

TEST_CASE("rounds of the spatial order grow sevenfold and are the same for any number of threads") {
  const Points points = random_points(2, 150000, 1);
  const SpatialOrder one = spatial_order(points), three = spatial_order(points, 3);
  CHECK(one.ids == three.ids);
  CHECK(one.ends == three.ends);
  REQUIRE(one.ends.back() == points.size());
  CHECK(std::is_sorted(one.ends.begin(), one.ends.end()));
  REQUIRE(one.ends.size() > 3);
  for (std::size_t k = 1; k < one.ends.size(); ++k) {
    CAPTURE(k);
    const auto all = static_cast<double>(one.ends[k]);
    const double share = 1 - static_cast<double>(one.ends[k - 1]) / all;
    CHECK(std::abs(share - 7.0 / 8) < 4 * std::sqrt(7.0 / 64 / all));  // standard deviations
  }
}

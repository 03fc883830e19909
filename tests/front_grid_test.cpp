#include "front/front_grid.h"

#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;
using geometry::Point;

TEST_CASE(
    "the grid finds within a radius just what a search of all corners finds, over six orders of "
    "length") {
  std::size_t found_in_all = 0;
  for_seeds<Random>(60, [&](unsigned seed, Random& random) {
    // A length scale that changes no faster than the point moves, smallest at a few places.
    std::vector<std::pair<Point, double>> deepest;
    for (int i = 0; i < 4; ++i) {
      deepest.emplace_back(random.between(0, 2) * random.direction(),
                           std::pow(10.0, random.between(-6, 0)));
    }
    const auto length_scale = [&](const Point& x) {
      double least = INFINITY;
      for (const auto& [at, scale] : deepest) least = std::min(least, scale + (x - at).norm());
      return least;
    };
    const auto random_point = [&]() -> Point {
      const auto& [at, scale] = deepest[random.below(deepest.size())];
      return at + scale * std::pow(10.0, random.between(-1, 1)) * random.direction();
    };
    FrontGrid grid(seed % 2 == 0 ? 0.4 : 0.85);  // in two bands at most, or in three
    struct Filed {
      FrontEdgeId corner;
      Point position;
      FrontGrid::Keys keys;
    };
    std::vector<Filed> filed;
    for (std::uint32_t i = 0; i < 3000; ++i) {
      if (random.uniform() < 0.35 && !filed.empty()) {
        const std::size_t k = random.below(filed.size());
        grid.erase(filed[k].corner, filed[k].keys);
        filed[k] = filed.back();
        filed.pop_back();
      } else {
        const Point x = random_point();
        filed.push_back({FrontEdgeId{i}, x, grid.insert(FrontEdgeId{i}, x, length_scale(x))});
      }
      if (i % 30 != 0) continue;
      CAPTURE(i);
      const Point p = random_point();
      const double rho = length_scale(p);
      const double radius = random.between(0, grid.max_radius(rho));
      std::vector<FrontEdgeId> visited, expected;
      grid.for_each_within(p, rho, radius, [&](FrontEdgeId e) { visited.push_back(e); });
      std::sort(visited.begin(), visited.end());
      visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
      // Single precision offsets: a thousandth of the radius, a millionth of the scale.
      const double beyond = radius * 1.001 + 1e-5 * rho;
      for (const auto& [e, x, keys] : filed) {
        const double d = (x - p).norm();
        const bool is_visited = std::binary_search(visited.begin(), visited.end(), e);
        if (d <= radius * (1 - 1e-6)) CHECK(is_visited);
        if (d > beyond) CHECK_FALSE(is_visited);
        if (is_visited) expected.push_back(e);
      }
      CHECK(expected.size() == visited.size());  // nothing erased is visited
      found_in_all += visited.size();
    }
  });
  CHECK(found_in_all > 1000);
}

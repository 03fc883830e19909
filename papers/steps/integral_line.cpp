// Section 3.2, morse/integral_lines.h: one integral line.
//
// From a saddle of the cube's skin the line of steepest descent is followed to a minimum. The
// height must fall from node to node, and every node must lie on the skin.

#include "morse/choose_function.h"
#include "morse/integral_lines.h"
#include "papers/steps/step.h"
#include "skin/dual_complex.h"

int main() {
  using namespace morskin;
  std::vector<geometry::WeightedPoint> balls;
  for (int i = 0; i < 8; ++i) {
    balls.push_back({{i & 1 ? 1.25 : -1.25, i & 2 ? 1.25 : -1.25, i & 4 ? 1.25 : -1.25}, 2.4});
  }
  const skin::SkinSurface skin(balls);
  const auto chosen =
      morse::choose_function(skin, skin::dual_complex(skin).skin_euler_characteristic(), {});
  const auto& points = chosen.critical.points;
  const morse::IntegralLines lines(skin, chosen.function, points);
  std::size_t saddle = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].index == 1 &&
        (points[saddle].index != 1 || points[i].value > points[saddle].value)) {
      saddle = i;
    }
  }
  std::vector<geometry::Point> nodes;
  std::vector<geometry::CellId> cells;
  const morse::Course course = lines.trace(morse::CriticalId{saddle}, points[saddle].descending,
                                           morse::Way::Down, nodes, cells);
  if (!course.arrival) return 1;
  bool falls = true, is_on_skin = true;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    falls = falls && (i == 0 || chosen.function(nodes[i]) < chosen.function(nodes[i - 1]));
    is_on_skin = is_on_skin && std::abs(skin.value(nodes[i], cells[i])) < 1e-9;
  }
  const auto& end = points[course.arrival->extremum.index()];
  std::printf(
      "from the highest saddle, height %.3f, over %zu nodes to a point of index %d, "
      "height %.3f\n",
      points[saddle].value, nodes.size(), end.index, end.value);
  return step::claim("the line falls all the way on the skin to a minimum",
                     falls && is_on_skin && end.index == 0);
}

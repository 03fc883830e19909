// Section 3.2, morse/integral_lines.h: one integral line.
//
// From the highest saddle of a cube of balls the line of steepest descent is followed to a minimum.
// It runs along the gradient of the height, here V - (n . V) n (errata, E2): the chord between two
// nodes must have the gradient's direction at its middle.

#include <Eigen/Geometry>
#include <cmath>

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
  const auto [height, critical] =
      morse::choose_function(skin, skin::dual_complex(skin).skin_euler_characteristic(), {});
  const auto& points = critical.points;
  std::size_t saddle = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_higher = saddle == points.size() || points[i].value > points[saddle].value;
    if (points[i].index == 1 && is_higher) saddle = i;
  }
  // [excerpt: step-integral-line]
  std::vector<geometry::Point> nodes;
  std::vector<geometry::CellId> cells;
  const morse::IntegralLines lines(skin, height, points, 0.05);  // steps of 0.05 rho
  const morse::Course course = lines.trace(morse::CriticalId{saddle}, points[saddle].descending,
                                           morse::Direction::Down, nodes, cells);
  if (!course.arrival) return 1;
  // [/excerpt]
  bool falls = true;
  double widest = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    falls = falls && height(nodes[i]) < height(nodes[i - 1]);
    const auto middle = skin.project((nodes[i - 1] + nodes[i]) / 2, cells[i - 1]);
    const geometry::Vector &n = middle->normal, &V = height.direction;
    const geometry::Vector gradient = V - n.dot(V) * n, chord = nodes[i - 1] - nodes[i];
    widest = std::max(widest, std::atan2(gradient.cross(chord).norm(), gradient.dot(chord)));
  }
  const auto& end = points[course.arrival->extremum.index()];
  std::printf("from the saddle at height %6.3f\n", points[saddle].value);
  for (std::size_t i = 0; i < nodes.size(); i += nodes.size() / 5) {
    std::printf("  node %3zu    at height %6.3f\n", i, height(nodes[i]));
  }
  std::printf("to the minimum at height %6.3f\n", end.value);
  std::printf("widest angle of a chord with the gradient: %.2f degrees\n", widest * 180 / M_PI);
  return step::claim("the line falls along the gradient to a minimum",
                     falls && end.index == 0 && widest < 0.001);
}

// Section 2.1, geometry/predicates.h: a predicate deciding a tie.
//
// Five corners of a cube lie on one sphere. Is the fifth inside the sphere of the other four?
// Neither rounding nor jitter may decide. The ids do, by symbolic perturbation: each weight grows
// by an infinitesimal, larger for smaller ids.

#include "geometry/predicates_internal.h"
#include "papers/steps/step.h"

int main() {
  using namespace morskin::geometry;
  const WeightedPoint a{{0, 0, 0}}, b{{1, 0, 0}}, c{{0, 1, 0}}, d{{0, 0, 1}}, e{{1, 1, 1}};
  // The pre-condition: a, b, c, d in positive order.
  const bool is_positive =
      orientation(a.position, b.position, c.position, d.position) == Sign::Positive;
  const auto& p = is_positive ? a : b;
  const auto& q = is_positive ? b : a;

  const auto quick = internal::filtered_orthosphere(p, q, c, d, e);
  std::printf("floating point with an error bound: %s\n", quick ? "decides" : "cannot tell");

  // [excerpt: step-tie]
  const auto side = [&](std::uint32_t id_of_e) {
    std::array<AtomId, 5> ids;
    for (std::uint32_t i = 0; i < 4; ++i) ids[i] = AtomId{10 + i};
    ids[4] = AtomId{id_of_e};
    return orthosphere_side(p, q, c, d, e, ids);
  };
  // [/excerpt]
  const bool is_inside_when_first = side(0) == Side::Inside;
  const bool is_inside_when_last = side(99) == Side::Inside;
  std::printf("e with the smallest id: %s\n", is_inside_when_first ? "inside" : "outside");
  std::printf("e with the largest id:  %s\n", is_inside_when_last ? "inside" : "outside");

  // The same points in another order must give the same answer.
  const std::array<AtomId, 5> turned{AtomId{11U}, AtomId{12U}, AtomId{10U}, AtomId{13U},
                                     AtomId{99U}};
  const bool is_same = orthosphere_side(q, c, p, d, e, turned) == side(99);
  return step::claim("the ids decide, the order of asking does not",
                     !quick && is_inside_when_first != is_inside_when_last && is_same);
}

// Algorithm 1, CreepTriangles(), and what the paper does before and after it (section 4.1).

#include "front/sweep.h"

namespace morskin::front {

// [excerpt: algorithm-1]
void Sweep::creep_triangles() {
  while (const auto t = lowest_departure()) {  // 1, 2: t = ExtractMin(Q)
    const auto c = protecting_sphere(*t);
    if (is_saddle(c)) {              // 3: t falls in the protecting sphere of a saddle point c
      mark_red(*c, *t);              // 7
      if (is_ready(*c)) bridge(*c);  // 4, 5
    } else if (is_maximum(c)) {      // 9: t falls in that of a maximum point c
      mark_green(*c, *t);            // 10
    } else if (!creep(*t)) {         // 12
      defer(*t);                     // where the guard leaves no triangle
    }                                // 13; for 14 see below
  }                                  // 15
}
// [/excerpt]

// Line 14 refines the new triangles after each step. Here the closed mesh is refined
// (refine/refinement.h): papers/4.3-local-refinement.md says why.

void Sweep::run(const SweepRegion& region, std::span<const SurfacePoint> bowls) {
  region_ = region;
  for (const SurfacePoint& p0 : bowls) create(p0);
  departures_.release_postponed();
  sweep_on();
}

/// Creeps, then seals what is left at the maxima, then retries what the guard refused.
void Sweep::sweep_on() {
  creep_triangles();
  release_red_marks();
  creep_triangles();
  for (const CriticalId maximum : marks_.release_all(Marks::maximum)) {
    if (is_surrounded(maximum)) seal(maximum);
  }
  creep_triangles();
  for (std::size_t before = 0; before != front_.triangles_added();) {
    before = front_.triangles_added();
    departures_.retry_refused();
    creep_triangles();
  }
  for (SweepObserver* observer : observers_) observer->finished(front_);
}

}  // namespace morskin::front

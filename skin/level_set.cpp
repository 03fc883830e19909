#include "skin/level_set.h"

#include "skin/slide.h"

namespace morskin::skin {

std::optional<SurfacePoint> LevelSet::project(const Point& x, CellId start) const {
  return slide_onto(*this, x, start);
}

}  // namespace morskin::skin

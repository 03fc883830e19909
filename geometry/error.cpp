#include "geometry/error.h"

namespace morskin::geometry {

void fail_for_lack_of_ids(std::size_t most, const char* things) {
  throw LimitReached("there are more than " + std::to_string(most) + " " + things +
                     ", as many as 32-bit numbers tell apart; take fewer atoms or a larger -C");
}

}  // namespace morskin::geometry

#pragma once

#include <doctest/doctest.h>

#include <type_traits>

namespace morskin::support {

/// Tries a law for each seed from 0 on, and names the seed of a failure. The law takes the seed, a
/// fixture made of it, or both.
template <class Fixture = unsigned, class Law>
void for_seeds(unsigned count, Law law) {
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    Fixture fixture(seed);
    if constexpr (std::is_invocable_v<Law, unsigned, Fixture&>) {
      law(seed, fixture);
    } else {
      law(fixture);
    }
  }
}

}  // namespace morskin::support

#pragma once

#include <doctest/doctest.h>

#include <type_traits>

namespace morskin::support {

/// The seeds from the first on, up to the end; a number alone is that many from 0 on.
struct Seeds {
  Seeds(unsigned count) : first(0), end(count) {}
  Seeds(unsigned from, unsigned to) : first(from), end(to) {}
  unsigned first, end;
};

/// Tries a law for each seed, and names the seed of a failure. The law takes the seed, a fixture
/// made of it, or both.
template <class Fixture = unsigned, class Law>
void for_seeds(const Seeds& seeds, Law law) {
  for (unsigned seed = seeds.first; seed < seeds.end; ++seed) {
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

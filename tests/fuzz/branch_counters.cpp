// Coverage of the one source that g++ compiles (skin/CMakeLists.txt): it calls this at every
// branch, and libFuzzer learns from the counters. Its own support of such calls is gone.

#include <array>
#include <cstddef>
#include <cstdint>

namespace {

constexpr std::size_t counter_count = std::size_t{1} << 14;
[[gnu::section("__libfuzzer_extra_counters")]] std::array<std::uint8_t, counter_count> counters;

}  // namespace

extern "C" void morskin_trace_branch() {
  const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
  ++counters[place % counter_count];
}

// Any bytes as a gzipped file, alone and behind a good header: unpacked within the limit, or turned
// down.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/error.h"
#include "geometry/files/gzip.h"
#include "tests/fuzz/require.h"

using namespace morskin;

namespace {

void unpack(std::string_view bytes) {
  constexpr std::size_t most = std::size_t{1} << 20;
  try {
    fuzz::require(geometry::unpack_gzip(bytes, "a.gz", most).size() <= most);
  } catch (const geometry::UnreadableInput&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  unpack(bytes);
  constexpr std::string_view header("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10);
  unpack(std::string(header) + std::string(bytes));
  return 0;
}

#include "geometry/files/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "geometry/error.h"
#include "geometry/task_trace.h"

namespace morskin::geometry {
namespace {

constexpr int gzip_window = 15 + 16;  // the largest window; gzip's own header and checksum
constexpr std::size_t max_at_once = std::numeric_limits<uInt>::max() / 2;

[[noreturn]] void fail(const std::string& source, const std::string& what) {
  throw UnreadableInput(source + ": " + what);
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string unpack_gzip(std::string_view bytes, const std::string& source, std::size_t max_bytes) {
  const Traced traced(TaskTrace::Kind::Stage, "gunzip");
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) fail(source, "zlib does not start; try again");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> closing(&stream, inflateEnd);

  const std::size_t limit = std::min(max_bytes, std::max(bomb_bytes, bomb_ratio * bytes.size()));
  std::string text;
  std::size_t taken = 0;  // of bytes
  std::size_t made = 0;   // of text
  const auto require_limit = [&] {
    if (made <= limit) return;
    fail(source, "unpacks from " + std::to_string(bytes.size()) + " to more than " +
                     std::to_string(limit) + " bytes; unpack it by hand if that is meant");
  };
  for (;;) {
    if (made == text.size()) {
      require_limit();
      text.resize(std::min(limit + 1, std::max(2 * made, 4 * bytes.size() + 4096)));
    }
    const std::size_t input = std::min(max_at_once, bytes.size() - taken);
    const std::size_t space = std::min(max_at_once, text.size() - made);
    // zlib never writes to its input, though its type is not const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = static_cast<uInt>(input);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + made);
    stream.avail_out = static_cast<uInt>(space);
    const int state = inflate(&stream, Z_NO_FLUSH);
    taken += input - stream.avail_in;
    made += space - stream.avail_out;
    if (state == Z_STREAM_END) {
      require_limit();
      // Another member follows, or padding, which gzip ignores too.
      if (!is_gzip(bytes.substr(taken))) {
        text.resize(made);
        if (is_gzip(text)) fail(source, "is a gzip file inside a gzip file; unpack it once");
        return text;
      }
      inflateReset(&stream);
    } else if (state != Z_OK && state != Z_BUF_ERROR) {
      fail(source, "is damaged and cannot be unpacked; fetch it again");
    } else if (taken == bytes.size() && made < text.size()) {
      fail(source, "is cut short and cannot be unpacked; fetch it again");
    }
  }
}

}  // namespace morskin::geometry

#include "app/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <functional>

namespace morskin::app {

char ControlFilter::operator()(char c) {
  constexpr char substitute = '?';
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x80 && byte < 0xc0) {  // continues a character
    // U+0080 to U+009F are control characters too.
    const bool is_control = lead_ == 0xc2 && byte < 0xa0;
    if (missing_ == 0 || is_control) return substitute;
    --missing_;
    return c;
  }
  lead_ = byte;
  missing_ = byte < 0xc2 ? 0 : byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : byte < 0xf5 ? 3 : 0;
  if (byte >= 0x80) return missing_ > 0 ? c : substitute;
  return (byte < 0x20 && c != '\n') || byte == 0x7f ? substitute : c;
}

std::string printable(std::string_view text) {
  std::string result(text);
  ControlFilter filter;
  for (char& c : result) c = filter(c);
  return result;
}

PrintableStream::int_type PrintableStream::overflow(int_type c) {
  if (c == traits_type::eof()) return 0;
  const char one = traits_type::to_char_type(c);
  return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

// Allocates nothing: the message may be that there is no memory.
std::streamsize PrintableStream::xsputn(const char* text, std::streamsize count) {
  std::array<char, 512> piece;
  for (std::streamsize done = 0; done < count;) {
    const auto size = std::min<std::streamsize>(count - done, piece.size());
    std::transform(text + done, text + done + size, piece.begin(), std::ref(filter_));
    const std::streamsize written = target_->sputn(piece.data(), size);
    done += written;
    if (written < size) return done;
  }
  return count;
}

void fill_closed_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) >= 0) continue;
    // The lowest free number is this one.
    [[maybe_unused]] const int opened =
        ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace morskin::app

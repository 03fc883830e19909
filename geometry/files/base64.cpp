#include "geometry/files/base64.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace morskin::geometry {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

void append_base64(std::string& text, std::string_view bytes) {
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i])} : 0U;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    const std::array<char, 4> four = {digits[group >> 18 & 63], digits[group >> 12 & 63],
                                      i + 1 < bytes.size() ? digits[group >> 6 & 63] : '=',
                                      i + 2 < bytes.size() ? digits[group & 63] : '='};
    text.append(four.data(), four.size());
  }
}

std::optional<std::string> from_base64(std::string_view text) {
  static constexpr std::array<signed char, 256> values = [] {
    std::array<signed char, 256> result{};
    result.fill(-1);
    signed char value = 0;
    for (const char c : digits) result[static_cast<unsigned char>(c)] = value++;
    return result;
  }();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const signed char value = values[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    group = group << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

}  // namespace morskin::geometry

#pragma once

#include <png.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morskin::support {

/// Red, green, blue of each pixel, 0 to 255, rows from the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// What a PNG holds, by libpng's own reader; nothing if it is none.
inline std::optional<Pixels> read_png(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return std::nullopt;
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  pixels.bytes.resize(std::size_t{image.width} * image.height * 3);
  if (png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr) == 0) {
    return std::nullopt;
  }
  return pixels;
}

}  // namespace morskin::support

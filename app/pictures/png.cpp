#include "app/pictures/png.h"

#include <png.h>

#include <new>
#include <stdexcept>

namespace morskin::pictures {
namespace {

void append(png_structp writer, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(writer))
      ->append(reinterpret_cast<const char*>(bytes), count);
}

[[noreturn]] void fail(png_structp, png_const_charp what) {
  throw std::runtime_error("libpng: " + std::string(what));
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  Writer() {
    if (info == nullptr) throw std::bad_alloc();
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

}  // namespace

std::string png(const Image& image) {
  std::vector<std::uint8_t> bytes = image.bytes();
  std::string file;
  const Writer writer;
  png_set_write_fn(writer.png, &file, append, nullptr);
  png_set_compression_level(writer.png, 9);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
  const auto width = static_cast<png_uint_32>(image.width());
  png_set_IHDR(writer.png, writer.info, width, static_cast<png_uint_32>(image.height()), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  for (std::size_t row = 0; row < bytes.size(); row += 3 * std::size_t{width}) {
    png_write_row(writer.png, &bytes[row]);
  }
  png_write_end(writer.png, writer.info);
  return file;
}

}  // namespace morskin::pictures

#pragma once

/// A picture in memory, and the colours in it.

#include <cstdint>
#include <span>
#include <vector>

namespace morskin::pictures {

/// A colour as a screen shows it (sRGB), each part 0 to 1.
struct Colour {
  double r = 1, g = 1, b = 1;

  /// From the usual six hexadecimal digits.
  static constexpr Colour of(std::uint32_t hex) {
    return {((hex >> 16) & 255) / 255.0, ((hex >> 8) & 255) / 255.0, (hex & 255) / 255.0};
  }
};

/// Linear interpolation from a to b.
constexpr Colour mixed(const Colour& a, const Colour& b, double share) {
  return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b)};
}

inline constexpr Colour white{1, 1, 1};
inline constexpr Colour ink = Colour::of(0x1b1f27);

/// From displayed value to light and back (sRGB's transfer curve).
double to_linear(double displayed);
double to_displayed(double linear);

/// Rows from the top, pixels from the left; pixel (x, y) covers [x, x + 1) times [y, y + 1).
class Image {
 public:
  Image(int width, int height, const Colour& background = white)
      : width_(width), height_(height), pixels_(area(width, height), background) {}

  int width() const { return width_; }
  int height() const { return height_; }
  const Colour& at(int x, int y) const { return pixels_[index(x, y)]; }
  Colour& at(int x, int y) { return pixels_[index(x, y)]; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  /// Blends a colour over a pixel; `alpha` is the share covered, 0 to 1.
  void cover(int x, int y, const Colour& colour, double alpha) {
    if (contains(x, y)) at(x, y) = mixed(at(x, y), colour, alpha);
  }
  /// Copies another picture into this one, its top left corner to (x, y).
  void paste(const Image& other, int x, int y);

  /// Red, green, blue of each pixel, 0 to 255.
  std::vector<std::uint8_t> bytes() const;

 private:
  static std::size_t area(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t index(int x, int y) const { return area(width_, y) + static_cast<std::size_t>(x); }

  int width_, height_;
  std::vector<Colour> pixels_;
};

/// Pictures in rows of at most `columns`, `gap` pixels apart, on white; each row is as high as its
/// highest picture.
Image in_rows(std::span<const Image> images, int columns, int gap);

}  // namespace morskin::pictures

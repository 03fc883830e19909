#include "app/pictures/image.h"

#include <algorithm>
#include <cmath>

namespace morskin::pictures {

double to_linear(double displayed) {
  return displayed <= 0.04045 ? displayed / 12.92 : std::pow((displayed + 0.055) / 1.055, 2.4);
}

double to_displayed(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

void Image::paste(const Image& other, int x, int y) {
  for (int j = 0; j < other.height(); ++j) {
    for (int i = 0; i < other.width(); ++i) {
      if (contains(x + i, y + j)) at(x + i, y + j) = other.at(i, j);
    }
  }
}

std::vector<std::uint8_t> Image::bytes() const {
  const auto rounded = [](double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * pixels_.size());
  for (const Colour& c : pixels_) {
    bytes.insert(bytes.end(), {rounded(c.r), rounded(c.g), rounded(c.b)});
  }
  return bytes;
}

Image in_rows(std::span<const Image> images, int columns, int gap) {
  struct Row {
    int width = 0, height = 0;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) == 0) rows.emplace_back();
    Row& row = rows.back();
    row.width += images[i].width() + (row.width > 0 ? gap : 0);
    row.height = std::max(row.height, images[i].height());
  }
  int width = 1, height = 0;
  for (const Row& row : rows) {
    width = std::max(width, row.width);
    height += row.height + (height > 0 ? gap : 0);
  }
  Image sheet(width, std::max(height, 1));
  int x = 0, y = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (i > 0 && i % static_cast<std::size_t>(columns) == 0) {
      x = 0;
      y += rows[i / static_cast<std::size_t>(columns) - 1].height + gap;
    }
    sheet.paste(images[i], x, y);
    x += images[i].width() + gap;
  }
  return sheet;
}

}  // namespace morskin::pictures

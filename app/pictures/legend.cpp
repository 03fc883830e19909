#include "app/pictures/legend.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morskin::pictures {
namespace {

// Pixels, times the unit.
constexpr double text_size = 10;   // height of capitals
constexpr double row_height = 26;  // of a row of entries
constexpr double bar_height = 44;  // of the row of a colour bar
constexpr double bar_width = 170, mark_width = 22;
constexpr double space = 8, between = 26;  // from a mark to its text, between two entries

double text_width(std::string_view text) { return text_size * lettering(text).width; }

double width_of(const LegendEntry& entry) { return mark_width + space + text_width(entry.meaning); }

// Half of the outer ticks stand beyond the bar.
double width_of(const Legend::Bar& bar) {
  return text_width(bar.quantity) + between + bar_width + text_width(bar.ticks.back()) / 2;
}

// As many entries in a row as the width has room for.
std::vector<std::span<const LegendEntry>> rows_of(std::span<const LegendEntry> entries,
                                                  double width) {
  std::vector<std::span<const LegendEntry>> rows;
  while (!entries.empty()) {
    double used = width_of(entries[0]);
    std::size_t count = 1;
    while (count < entries.size() && used + between + width_of(entries[count]) <= width) {
      used += between + width_of(entries[count++]);
    }
    rows.push_back(entries.first(count));
    entries = entries.subspan(count);
  }
  return rows;
}

double width_of(std::span<const LegendEntry> row) {
  double width = between * static_cast<double>(row.size() - 1);
  for (const LegendEntry& entry : row) width += width_of(entry);
  return width;
}

// Draws in units: (0, 0) is the top left corner of the legend.
class Drawing {
 public:
  Drawing(Image& image, double top, double unit) : image_(image), top_(top), unit_(unit) {}

  void add(const LegendEntry& entry, double x, double y) {
    const Vector2 from = at(x, y), to = at(x + mark_width, y), middle = (from + to) / 2;
    switch (entry.mark) {
      case Mark::Patch:
        draw_line(image_, std::array{at(x + 5, y), at(x + mark_width - 5, y)}, {ink, 13 * unit_});
        draw_line(image_, std::array{at(x + 5, y), at(x + mark_width - 5, y)},
                  {entry.colour, 11 * unit_});
        break;
      case Mark::Dot:
        fill_disk(image_, middle, 5 * unit_, entry.colour);
        break;
      case Mark::Line:
        draw_line(image_, std::array{from, to}, {entry.colour, 3 * unit_});
        break;
      case Mark::Dashes:
        draw_line(image_, std::array{from, to}, {entry.colour, 2 * unit_, 5 * unit_});
        break;
    }
    text(x + mark_width + space, y, entry.meaning, Align::Left);
  }

  void add(const Legend::Bar& bar, double x, double y) {
    text(x, y, bar.quantity, Align::Left);
    const double left = x + text_width(bar.quantity) + between;
    const double half = text_size * 0.7;
    const Vector2 low = at(left, y), high = at(left + bar_width, y);
    for (int column = floored(low.x()); column < floored(high.x()); ++column) {
      const double share = (column + 0.5 - low.x()) / (high.x() - low.x());
      const ColourScale& scale = bar.scale;
      const Colour colour = scale.at(scale.low + share * (scale.high - scale.low));
      for (int row = floored(low.y() - half * unit_); row < floored(low.y() + half * unit_);
           ++row) {
        image_.cover(column, row, colour, 1);
      }
    }
    for (std::size_t i = 0; i < bar.ticks.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(bar.ticks.size() - 1);
      text(left + share * bar_width, y + half + 11, bar.ticks[i], Align::Centre);
    }
  }

 private:
  static int floored(double x) { return static_cast<int>(std::floor(x)); }
  Vector2 at(double x, double y) const { return {x * unit_, top_ + y * unit_}; }
  void text(double x, double y, std::string_view words, Align align) {
    draw_text(image_, at(x, y + text_size / 2), words, text_size * unit_, align);
  }

  Image& image_;
  double top_, unit_;
};

}  // namespace

Colour ColourScale::at(double value) const {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  const double position = share * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  return mixed(stops[i], stops[i + 1], position - static_cast<double>(i));
}

Image with_legend(Image image, const Legend& legend, double unit) {
  if (legend.is_empty()) return image;
  const auto rows = rows_of(legend.entries, image.width() / unit);
  double width = legend.bar ? width_of(*legend.bar) : 0;
  for (const auto& row : rows) width = std::max(width, width_of(row));
  const double height =
      (legend.bar ? bar_height : 0) + row_height * static_cast<double>(rows.size());
  Image whole(std::max(image.width(), static_cast<int>(std::ceil(width * unit))),
              image.height() + static_cast<int>(std::ceil(height * unit)));
  whole.paste(image, (whole.width() - image.width()) / 2, 0);
  Drawing drawing(whole, image.height(), unit);
  const auto left_of = [&](double wide) { return (whole.width() / unit - wide) / 2; };
  double y = row_height / 2;
  if (legend.bar) {
    drawing.add(*legend.bar, left_of(width_of(*legend.bar)), y);
    y += bar_height;
  }
  for (const auto& row : rows) {
    double x = left_of(width_of(row));
    for (const LegendEntry& entry : row) {
      drawing.add(entry, x, y);
      x += width_of(entry) + between;
    }
    y += row_height;
  }
  return whole;
}

}  // namespace morskin::pictures

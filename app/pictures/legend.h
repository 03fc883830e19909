#pragma once

/// The legend of a picture: the meaning of its colours, in rows below it.

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/canvas.h"

namespace morskin::pictures {

/// Colours for the values of a quantity: stops at even steps from `low` to `high`, mixed between;
/// values beyond take the colour of the nearer end.
struct ColourScale {
  std::vector<Colour> stops;  ///< at least two
  double low = 0, high = 1;

  Colour at(double value) const;
};

enum class Mark { Patch, Dot, Line, Dashes };

struct LegendEntry {
  Mark mark;
  Colour colour;
  std::string meaning;
};

struct Legend {
  struct Bar {
    ColourScale scale;
    std::string quantity;
    std::vector<std::string>
        ticks;  ///< from low to high at even steps, with the unit; at least two
  };
  std::optional<Bar> bar;
  std::vector<LegendEntry> entries;

  bool is_empty() const { return !bar && entries.empty(); }
};

/// The picture with its legend below; wider, on white, if an entry needs that. Without a legend
/// the picture as it is.
/// @param unit  factor for the legend's lengths in pixels
Image with_legend(Image image, const Legend& legend, double unit = 1);

}  // namespace morskin::pictures

#pragma once

/// A small font of strokes, drawn for this project: letters, digits, the signs that figures need.

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace morskin::pictures {

using Vector2 = Eigen::Vector2d;
using Stroke = std::vector<Vector2>;  ///< a polyline; one point is a dot

/// A line of text as strokes, y up, the baseline at 0, capitals 1 high, beginning at x = 0.
struct Lettering {
  std::vector<Stroke> strokes;
  double width = 0;
};

/// @param text  UTF-8. "_" sets the next character, or the text in braces after it, as a
///              subscript: "p_0", "R_{ab}". A character without a glyph becomes a box.
Lettering lettering(std::string_view text);

}  // namespace morskin::pictures

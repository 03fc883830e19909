#pragma once

/// The figures of the paper, and one of our own, from this program's own results
/// (papers/figures.md).

#include <span>
#include <string_view>

#include "app/pictures/image.h"

namespace morskin::figures {

struct Figure {
  std::string_view name;     ///< the paper's number, "10a"; a word for what the paper has not
  std::string_view caption;  ///< what it shows
  /// @param scale  1 for the size in the papers; lengths in pixels go with it.
  pictures::Image (*draw)(double scale);
};

/// In the paper's order, then our own.
std::span<const Figure> all_figures();

/// The figure of this name, or none.
const Figure* find_figure(std::string_view name);

// models_figure.cpp
pictures::Image ball_and_stick_to_skin(double scale);  // 1
// contraction_figure.cpp
pictures::Image contraction(double scale);  // 3
// morse_figures.cpp
pictures::Image level_curves(double scale);       // 2
pictures::Image cube_snapshots(double scale);     // 4
pictures::Image inhibitor_complex(double scale);  // 10a
// operations_figures.cpp
pictures::Image bowl(double scale);    // 5
pictures::Image creep(double scale);   // 6
pictures::Image bridge(double scale);  // 8
// wing_figure.cpp
pictures::Image wing(double scale);  // 7
// sandwich_figure.cpp
pictures::Image sandwiching_ball(double scale);  // 9
// surface_ball_figure.cpp
pictures::Image surface_ball(double scale);  // surface-ball
// results_figures.cpp
pictures::Image head(double scale);        // 10b
pictures::Image gramicidin(double scale);  // 11

}  // namespace morskin::figures

#pragma once

/// Drawing on a picture: smooth lines, filled shapes, text. Lengths are pixels, y runs down.

#include <span>
#include <string_view>

#include "app/pictures/font.h"
#include "app/pictures/image.h"

namespace morskin::pictures {

struct Pen {
  Colour colour = ink;
  double width = 1.5;
  double dash = 0;  ///< length of dashes and of the gaps between; 0 for none
};

/// The polyline with round ends and joints.
void draw_line(Image& image, std::span<const Vector2> points, const Pen& pen);
void draw_circle(Image& image, const Vector2& centre, double radius, const Pen& pen);
void fill_disk(Image& image, const Vector2& centre, double radius, const Colour& colour);

/// The sides of a rectangle, pixel rows and columns included in it.
struct Box {
  double left, top, right, bottom;
};
void draw_box(Image& image, const Box& box, const Pen& pen);
/// A box along the rim of the picture.
void draw_border(Image& image, const Pen& pen);

enum class Align { Left, Centre, Right };

/// A line of text, its baseline through `at`.
/// @param size  height of capitals
/// @param halo  width of a white rim about the letters
void draw_text(Image& image, const Vector2& at, std::string_view text, double size,
               Align align = Align::Left, const Colour& colour = ink, double halo = 0);

}  // namespace morskin::pictures

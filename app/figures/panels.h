#pragma once

/// Layout that the figures share.

#include <string_view>

#include "app/pictures/legend.h"
#include "app/pictures/render.h"

namespace morskin::figures {

using geometry::Point;
using geometry::Vector;
using pictures::Camera;
using pictures::Colour;
using pictures::Image;
using pictures::LegendEntry;
using pictures::Mark;
using pictures::MeshLayer;
using pictures::Scene;
using pictures::Vector2;

// The colours of the paper's captions, distinguishable on white and on the skin.
inline constexpr Colour skin_blue = Colour::of(0x9fc1dc), minimum_red = Colour::of(0xd62f2f),
                        saddle_blue = Colour::of(0x2456d6), maximum_green = Colour::of(0x1f9a4a),
                        front_red = Colour::of(0xe02d2d), fresh_orange = Colour::of(0xf5b041),
                        bare_grey = Colour::of(0xdfdbd2);

Colour colour_of_index(int index);
/// The meaning of colour_of_index, in front of other entries.
pictures::Legend critical_point_legend(std::vector<LegendEntry> others);

/// Renders at `scale` times the camera's size.
Image panel(const Scene& scene, const Camera& camera, double scale,
            const pictures::Style& style = {});

/// Panels beside each other, each with its letter or caption below.
Image captioned(std::span<const Image> panels, std::span<const std::string_view> captions,
                double scale, int columns);

/// Frames the view of one camera in the picture of another.
void frame(Image& image, const Camera& camera, const Camera& detail, double scale);

}  // namespace morskin::figures

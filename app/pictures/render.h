#pragma once

/// Renders a scene: depth buffer, several samples a pixel, Phong shading, light from a sky and a
/// lamp with soft shadows. No graphics card; deterministic for any number of processors.

#include "app/pictures/image.h"
#include "app/pictures/scene.h"

namespace morskin::pictures {

struct Style {
  int samples = 3;  ///< an axis and pixel
  bool shadows = true;
  double outline = 0.6;  ///< darkness of the rim where one thing is in front of another, 0 to 1
  double unit = 1;       ///< factor for a scene's widths and sizes in pixels
  Colour background = white;
};

/// @pre  camera.width and height are positive, and their product times samples^2 below 2^31
Image render(const Scene& scene, const Camera& camera, const Style& style = {});

}  // namespace morskin::pictures

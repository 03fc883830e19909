#pragma once

/// A scene seen by a camera, as a picture: depth buffer, several samples a pixel, Phong shading,
/// light from a sky and a lamp with soft shadows. No graphics card; the same scene gives the same
/// picture on every run and for any number of processors.

#include "app/pictures/image.h"
#include "app/pictures/scene.h"

namespace morskin::pictures {

struct Style {
  int samples = 3;       ///< an axis and pixel
  bool shadows = true;   ///< else things look as if each stood alone
  double outline = 0.6;  ///< how dark the rim is where one thing stands before another, 0 to 1
  double unit = 1;       ///< factor for what a scene gives in pixels: widths and sizes
  Colour background = white;
};

/// @pre  camera.width and height are positive, and their product times samples^2 below 2^31
Image render(const Scene& scene, const Camera& camera, const Style& style = {});

}  // namespace morskin::pictures

#pragma once

/// Light from a sky and a lamp: many directions, each with a depth map, which gives soft shadows
/// and ambient occlusion.

#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::pictures {

using geometry::Vector;

/// The things that cast shadows, in view space (camera.h), in any unit.
struct Occluders {
  std::vector<Vector> corners;
  geometry::TriangleList triangles;
  struct SeenBall {
    Vector centre;
    double radius;
  };
  struct SeenStick {
    Vector from, to;
    double radius;
  };
  std::vector<SeenBall> balls;
  std::vector<SeenStick> sticks;
};

/// A point that is lit. In single precision: there are millions.
struct Spot {
  Eigen::Vector3f position, normal;
};

struct Illumination {
  std::vector<float> diffuse;  ///< by spot: about 1 where nothing hides the lamp
  std::vector<float> lamp;     ///< by spot: the share of the lamp that is not hidden
};

/// Directions, towards the light, of the lamp's middle.
Vector lamp_direction();

/// @param resolution  of the depth maps, an axis; they are coarser if large triangles are many
/// @param shadows     whether things cast shadows
Illumination illuminated(const Occluders& occluders, const std::vector<Spot>& spots, int resolution,
                         bool shadows);

}  // namespace morskin::pictures

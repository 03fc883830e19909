#include "app/pictures/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace morskin::pictures {

Camera Camera::fitted(std::span<const Point> points, double margin) const {
  Camera camera = *this;
  if (points.empty()) return camera;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low = Vector::Constant(infinity), high = -low;
  for (const Point& p : points) {
    const Vector at(right.dot(p), up.dot(p), toward.dot(p));
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const Vector middle = (low + high) / 2, extent = high - low;
  camera.target = middle.x() * right + middle.y() * up + middle.z() * toward;
  const double share = 1 - 2 * margin;
  camera.scale = std::min(extent.x() > 0 ? share * width / extent.x() : infinity,
                          extent.y() > 0 ? share * height / extent.y() : infinity);
  if (!std::isfinite(camera.scale)) camera.scale = 1;
  return camera;
}

Camera Camera::resized(double factor) const {
  Camera camera = *this;
  camera.width = std::max(1, static_cast<int>(std::lround(factor * width)));
  camera.height = std::max(1, static_cast<int>(std::lround(factor * height)));
  camera.scale *= factor;
  return camera;
}

Camera camera_from(const Vector& toward, const Vector& up, int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.toward = toward.normalized();
  constexpr double least = 1e-6;  // below this the two are parallel for a picture's purpose
  Vector across = up.cross(camera.toward);
  if (across.norm() < least * up.norm()) {
    Eigen::Index axis = 0;
    camera.toward.cwiseAbs().minCoeff(&axis);
    across = Vector::Unit(axis).cross(camera.toward);
  }
  camera.right = across.normalized();
  camera.up = camera.toward.cross(camera.right);
  return camera;
}

}  // namespace morskin::pictures

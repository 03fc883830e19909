#include "app/pictures/light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "app/pictures/raster.h"
#include "geometry/parallel.h"

namespace morskin::pictures {
namespace {

struct Beam {
  Vector toward;   // unit, to the light
  double diffuse;  // strength
  double lamp;     // share of the lamp
};

constexpr int sky_beams = 72, lamp_beams = 12;
constexpr double sky_strength = 0.62, lamp_strength = 0.60;
constexpr double lamp_radius = 0.16;  // tangent of half the angle that the lamp fills

// Points spread evenly over the unit sphere along a spiral (a Fibonacci lattice).
std::vector<Beam> sky() {
  const double turn = M_PI * (3 - std::sqrt(5.0));
  std::vector<Beam> beams;
  double sum = 0;
  for (int i = 0; i < sky_beams; ++i) {
    const double z = 1 - (2 * i + 1.0) / sky_beams, r = std::sqrt(1 - z * z);
    const Vector d(r * std::cos(turn * i), r * std::sin(turn * i), z);
    // Brighter from above and from the eye's side; y runs down.
    const double strength = 0.30 + std::max(0.0, 0.45 * -d.y()) + std::max(0.0, 0.55 * d.z());
    beams.push_back({d, strength, 0});
    sum += strength * std::max(0.0, d.z());
  }
  for (Beam& beam : beams) beam.diffuse *= sky_strength / sum;
  return beams;
}

std::vector<Beam> all_beams() {
  std::vector<Beam> beams = sky();
  const Vector middle = lamp_direction();
  const Vector first = middle.unitOrthogonal(), second = middle.cross(first);
  const double turn = M_PI * (3 - std::sqrt(5.0));
  for (int i = 0; i < lamp_beams; ++i) {
    const double r = lamp_radius * std::sqrt((i + 0.5) / lamp_beams);
    const Vector d =
        (middle + r * (std::cos(turn * i) * first + std::sin(turn * i) * second)).normalized();
    beams.push_back({d, lamp_strength / lamp_beams, 1.0 / lamp_beams});
  }
  return beams;
}

// The depth map of a direction: the height of the first hit above a plane across it.
class DepthMap {
 public:
  DepthMap(const Vector& toward, const std::vector<Spot>& spots, int resolution)
      : toward_(toward), first_(toward.unitOrthogonal()), second_(toward.cross(first_)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity;
    for (const Spot& spot : spots) {
      const Vector p = spot.position.cast<double>();
      const double x = first_.dot(p), y = second_.dot(p);
      low_x = std::min(low_x, x);
      high_x = std::max(high_x, x);
      low_y = std::min(low_y, y);
      high_y = std::max(high_y, y);
    }
    const double extent = std::max({high_x - low_x, high_y - low_y, 1.0});
    texel_ = extent / (resolution - 4);
    corner_ = Vector(low_x, low_y, 0) / texel_ - Vector(2, 2, 0);
    grid_ = {static_cast<int>((high_x - low_x) / texel_) + 5,
             static_cast<int>((high_y - low_y) / texel_) + 5};
    heights_.assign(static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height),
                    -std::numeric_limits<float>::infinity());
  }

  double texel() const { return texel_; }
  Vector local(const Vector& p) const {
    return Vector(first_.dot(p), second_.dot(p), toward_.dot(p)) / texel_ - corner_;
  }

  void draw(const Occluders& occluders) {
    const auto raise = [this](int x, int y, double height, auto&&...) {
      float& highest = heights_[index(x, y)];
      highest = std::max(highest, static_cast<float>(height));
    };
    std::vector<Vector> corners;
    corners.reserve(occluders.corners.size());
    for (const Vector& p : occluders.corners) corners.push_back(local(p));
    for (const auto& t : occluders.triangles) {
      for_each_sample_of_triangle(grid_, corners[t[0]], corners[t[1]], corners[t[2]], raise);
    }
    for (const auto& ball : occluders.balls) {
      for_each_sample_of_ball(grid_, local(ball.centre), ball.radius / texel_, raise);
    }
    for (const auto& stick : occluders.sticks) {
      for_each_sample_of_stick(grid_, local(stick.from), local(stick.to), stick.radius / texel_,
                               raise);
    }
  }

  // The share of the four samples around a point that are not above it.
  double openness(const Vector& at) const {
    const double x = at.x() - 0.5, y = at.y() - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const double s = x - i, t = y - j;
    return (1 - t) * ((1 - s) * open(i, j, at.z()) + s * open(i + 1, j, at.z())) +
           t * ((1 - s) * open(i, j + 1, at.z()) + s * open(i + 1, j + 1, at.z()));
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
           static_cast<std::size_t>(x);
  }
  double open(int x, int y, double height) const {
    if (x < 0 || y < 0 || x >= grid_.width || y >= grid_.height) return 1;
    return static_cast<double>(heights_[index(x, y)]) > height ? 0 : 1;
  }

  Vector toward_, first_, second_, corner_;
  double texel_ = 1;
  Grid grid_{};
  std::vector<float> heights_;
};

double extent_of(const std::vector<Spot>& spots) {
  Eigen::AlignedBox3f box;
  for (const Spot& spot : spots) box.extend(spot.position);
  return std::max<double>(box.sizes().maxCoeff(), 1);
}

// The resolution, halved until the triangles take no more steps (rows and samples) of each map than
// `most`: so thousands of triangles as long as the picture do not take hours.
int affordable_resolution(int resolution, const Occluders& occluders, double extent) {
  constexpr int least = 64;
  const double steps_of_small = 16;  // of a triangle of a fine mesh, with a margin
  const double most = 0x1p24 + steps_of_small * static_cast<double>(occluders.triangles.size());
  double rows = 0, samples = 0;  // in shares of the extent and its square
  for (const auto& [i, j, k] : occluders.triangles) {
    const Vector &a = occluders.corners[i], &b = occluders.corners[j], &c = occluders.corners[k];
    const double side = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) / extent;
    const double area = (b - a).cross(c - a).norm() / 2 / (extent * extent);
    rows += std::min(side, 1.0);
    samples += std::min(area, 1.0);
  }
  while (resolution > least && resolution * (rows + resolution * samples) > most) resolution /= 2;
  return std::max(resolution, least);
}

// The bias of a spot along its normal, in samples of the map, since a sample's height may be that
// of a point one sample away.
constexpr double lift = 1.6;

void add_light(const Occluders& occluders, const std::vector<Spot>& spots, int resolution,
               bool shadows, std::span<const Beam> beams, Illumination& light) {
  light.diffuse.assign(spots.size(), 0);
  light.lamp.assign(spots.size(), 0);
  for (const Beam& beam : beams) {
    DepthMap map(beam.toward, spots, resolution);
    if (shadows) map.draw(occluders);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const Vector normal = spots[i].normal.cast<double>();
      const double slope = normal.dot(beam.toward);
      if (slope <= 0) continue;
      double open = 1;
      if (shadows) {
        const Vector p = spots[i].position.cast<double>() + lift * map.texel() * normal;
        open = map.openness(map.local(p));
      }
      light.diffuse[i] += static_cast<float>(beam.diffuse * slope * open);
      light.lamp[i] += static_cast<float>(beam.lamp * open);
    }
  }
}

}  // namespace

Vector lamp_direction() { return Vector(-0.48, -0.62, 0.62).normalized(); }

Illumination illuminated(const Occluders& occluders, const std::vector<Spot>& spots, int resolution,
                         bool shadows) {
  if (spots.empty()) return {};
  if (shadows) resolution = affordable_resolution(resolution, occluders, extent_of(spots));
  const std::vector<Beam> beams = all_beams();
  const std::span<const Beam> all = beams;
  const std::size_t half = beams.size() / 2;
  // Always two sums, so that the result does not depend on the number of threads.
  Illumination light, other;
  geometry::do_both(
      2, [&] { add_light(occluders, spots, resolution, shadows, all.first(half), light); },
      [&] { add_light(occluders, spots, resolution, shadows, all.subspan(half), other); });
  for (std::size_t i = 0; i < spots.size(); ++i) {
    light.diffuse[i] += other.diffuse[i];
    light.lamp[i] += other.lamp[i];
  }
  return light;
}

}  // namespace morskin::pictures

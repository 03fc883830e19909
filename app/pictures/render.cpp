#include "app/pictures/render.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/pictures/light.h"
#include "app/pictures/raster.h"

namespace morskin::pictures {
namespace {

// The surface at one sample; later its colour replaces its normal.
struct Sample {
  float depth = -std::numeric_limits<float>::infinity();
  std::array<float, 3> value{};        // the normal, then the colour as displayed
  std::array<std::uint8_t, 3> coat{};  // the thing's own colour
  std::uint8_t gloss = 0;
  std::uint32_t spot = 0;

  bool is_empty() const { return depth == -std::numeric_limits<float>::infinity(); }
  Vector vector() const { return {value[0], value[1], value[2]}; }
  void set(const Vector& v) { Eigen::Vector3f::Map(value.data()) = v.cast<float>(); }
};

std::uint8_t byte(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Renders one picture. View space has the unit of a sample here.
class Painter {
 public:
  Painter(const Scene& scene, const Camera& camera, const Style& style)
      : scene_(scene),
        style_(style),
        fine_(style.samples),
        camera_(camera.resized(style.samples)),
        grid_{camera_.width, camera_.height},
        samples_(static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height)) {}

  Image painted() {
    for (const MeshLayer& layer : scene_.meshes) draw(layer);
    for (const Ball& ball : scene_.balls) draw(ball);
    for (const Stick& stick : scene_.sticks) draw(stick);
    find_rims();
    shade();
    for (const Line& line : scene_.lines) draw(line);
    return resolved();
  }

 private:
  Sample& at(int x, int y) {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
                    static_cast<std::size_t>(x)];
  }

  void put(int x, int y, double depth, const Vector& normal, const Colour& colour, double gloss) {
    Sample& sample = at(x, y);
    if (!(static_cast<float>(depth) > sample.depth)) return;
    sample.depth = static_cast<float>(depth);
    sample.set(normal);
    sample.coat = {byte(colour.r), byte(colour.g), byte(colour.b)};
    sample.gloss = byte(gloss);
  }

  void draw(const MeshLayer& layer) {
    const Coat& coat = layer.coat;
    const auto first = static_cast<std::uint32_t>(occluders_.corners.size());
    for (const Point& p : layer.mesh.positions) occluders_.corners.push_back(camera_.seen(p));
    std::vector<Vector> normals;
    for (const Vector& n : layer.normals) normals.push_back(camera_.seen_direction(n));
    const double half_width = coat.edge_width * style_.unit * fine_ / 2;
    for (std::size_t i = 0; i < layer.mesh.triangles.size(); ++i) {
      const auto& t = layer.mesh.triangles[i];
      occluders_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      const Vector &a = occluders_.corners[first + t[0]], &b = occluders_.corners[first + t[1]],
                   &c = occluders_.corners[first + t[2]];
      const bool is_front = seen_area(a, b, c) < 0;
      const double side = is_front ? 1 : -1;
      const Colour& own = layer.triangle_colours.empty() ? coat.colour : layer.triangle_colours[i];
      const Colour& colour = is_front ? own : coat.back;
      // y runs down, so view space mirrors the triangle and its normal.
      const Vector face = -side * (b - a).cross(c - a).normalized();
      const double area = std::abs(seen_area(a, b, c));
      const double to_a = area / (b - c).head<2>().norm(), to_b = area / (c - a).head<2>().norm(),
                   to_c = area / (a - b).head<2>().norm();
      for_each_sample_of_triangle(
          grid_, a, b, c, [&](int x, int y, double depth, double u, double v) {
            Vector normal = face;
            if (!normals.empty()) {
              normal = side * (u * normals[t[0]] + v * normals[t[1]] + (1 - u - v) * normals[t[2]]);
              // Where a smooth normal faces away though the triangle does not, use a normal across
              // the view.
              if (normal.z() < 0) normal.z() = 0;
              normal.normalize();
            }
            Colour shown = colour;
            double gloss = coat.gloss;
            if (half_width > 0) {
              const double rim = std::min({u * to_a, v * to_b, (1 - u - v) * to_c});
              const double face_share = smooth_step(rim - half_width + 0.5);
              shown = mixed(coat.edge, colour, face_share);
              gloss *= face_share;
            }
            put(x, y, depth, normal, shown, gloss);
          });
    }
  }

  // Puts samples of one colour.
  auto putter(const Colour& colour) {
    return [this, &colour](int x, int y, double depth, const Vector& normal) {
      constexpr double gloss = 0.35;
      put(x, y, depth, normal, colour, gloss);
    };
  }

  void draw(const Ball& ball) {
    const Vector centre = camera_.seen(ball.centre);
    const double radius = ball.radius * camera_.scale;
    occluders_.balls.push_back({centre, radius});
    for_each_sample_of_ball(grid_, centre, radius, putter(ball.colour));
  }

  void draw(const Stick& stick) {
    const Vector from = camera_.seen(stick.from), to = camera_.seen(stick.to);
    const double radius = stick.radius * camera_.scale;
    occluders_.sticks.push_back({from, to, radius});
    for_each_sample_of_stick(grid_, from, to, radius, putter(stick.colour));
  }

  // The points to light: one in each pixel for each surface visible in it.
  std::vector<Spot> spots() {
    std::vector<Spot> spots;
    const double step = 2.0 * fine_;  // farther from the plane of a spot is another surface
    for (int py = 0; py < grid_.height; py += fine_) {
      for (int px = 0; px < grid_.width; px += fine_) {
        const std::size_t first = spots.size();
        for (int y = py; y < py + fine_; ++y) {
          for (int x = px; x < px + fine_; ++x) {
            Sample& sample = at(x, y);
            if (sample.is_empty()) continue;
            const Eigen::Vector3f position(static_cast<float>(x) + 0.5F,
                                           static_cast<float>(y) + 0.5F, sample.depth);
            const Eigen::Vector3f normal(sample.value[0], sample.value[1], sample.value[2]);
            std::size_t s = first;
            while (s < spots.size() &&
                   !(spots[s].normal.dot(normal) > 0.9F &&
                     std::abs(spots[s].normal.dot(position - spots[s].position)) < step / 4)) {
              ++s;
            }
            if (s == spots.size()) spots.push_back({position, normal});
            sample.spot = static_cast<std::uint32_t>(s);
          }
        }
      }
    }
    return spots;
  }

  void shade() {
    const std::vector<Spot> lit = spots();
    const int resolution = std::clamp(std::max(grid_.width, grid_.height) / 2, 64, 1100);
    const Illumination light = illuminated(occluders_, lit, resolution, style_.shadows);
    std::array<double, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
      linear[i] = to_linear(static_cast<double>(i) / 255);
    }
    const Vector half = (lamp_direction() + Vector::UnitZ()).normalized();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      Sample& sample = samples_[i];
      if (sample.is_empty()) continue;
      constexpr double sharpness = 42, max_shine = 0.55;  // of the highlight
      constexpr double ambient = 0.06;                    // where neither sky nor lamp is seen
      const Vector normal = sample.vector();
      const double shine = max_shine * sample.gloss / 255.0 * light.lamp[sample.spot] *
                           std::pow(std::max(0.0, normal.dot(half)), sharpness);
      Vector colour;
      for (std::size_t k = 0; k < 3; ++k) {
        const double own = linear[sample.coat[k]] * (ambient + light.diffuse[sample.spot]);
        colour[static_cast<Eigen::Index>(k)] =
            to_displayed(std::min(1.0, own + shine * (1 - std::min(1.0, own))));
      }
      const bool is_rim = !is_rim_.empty() && is_rim_[i];
      sample.set((is_rim ? 1 - style_.outline : 1) * colour);
    }
  }

  // Samples just behind the rim of something nearer, or at a rim against the background: where a
  // neighbour is nearer than the linear continuation of the surface.
  void find_rims() {
    if (style_.outline <= 0) return;
    is_rim_.resize(samples_.size());
    const int radius = std::max(1, static_cast<int>(std::lround(0.7 * fine_ * style_.unit)));
    const double step = 4 * radius;
    for (int y = 0; y < grid_.height; ++y) {
      for (int x = 0; x < grid_.width; ++x) {
        const Sample& sample = at(x, y);
        if (sample.is_empty()) continue;
        constexpr double min_z = 0.05;
        const Vector n = sample.vector() / std::max(sample.vector().z(), min_z);
        for (const auto [dx, dy] :
             {std::array{radius, 0}, {-radius, 0}, {0, radius}, {0, -radius}}) {
          const int i = x + dx, j = y + dy;
          if (i < 0 || j < 0 || i >= grid_.width || j >= grid_.height) continue;
          const Sample& other = at(i, j);
          const double rise = std::abs(n.x() * dx + n.y() * dy);
          if (other.is_empty() || other.depth > sample.depth + rise + step) {
            is_rim_[static_cast<std::size_t>(&sample - samples_.data())] = true;
          }
        }
      }
    }
  }

  void draw(const Line& line) {
    const double half_width = line.width * style_.unit * fine_ / 2;
    const double dash = line.dash * style_.unit * fine_;
    double walked = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Vector a = camera_.seen(line.points[i - 1]), b = camera_.seen(line.points[i]);
      const Eigen::Vector2d d = (b - a).head<2>();
      const double squared = d.squaredNorm();
      const Range rows = samples_between(std::min(a.y(), b.y()) - half_width,
                                         std::max(a.y(), b.y()) + half_width, grid_.height);
      const Range columns = samples_between(std::min(a.x(), b.x()) - half_width,
                                            std::max(a.x(), b.x()) + half_width, grid_.width);
      for (int y = rows.first; y < rows.last; ++y) {
        const Range span = span_of_strip(a, d, half_width, y, columns);
        for (int x = span.first; x < span.last; ++x) {
          const Eigen::Vector2d p = Eigen::Vector2d(x + 0.5, y + 0.5) - a.head<2>();
          const double t = squared > 0 ? std::clamp(p.dot(d) / squared, 0.0, 1.0) : 0;
          if ((p - t * d).norm() > half_width) continue;
          if (dash > 0 && std::fmod(walked + t * std::sqrt(squared), 2 * dash) > dash) continue;
          Sample& sample = at(x, y);
          const double depth = a.z() + t * (b.z() - a.z()) + line.lift * camera_.scale;
          if (!line.is_on_top && depth < sample.depth) continue;
          if (sample.is_empty()) sample.depth = static_cast<float>(depth);
          sample.set(Vector(line.colour.r, line.colour.g, line.colour.b));
        }
      }
      walked += std::sqrt(squared);
    }
  }

  Image resolved() {
    const int width = grid_.width / fine_, height = grid_.height / fine_;
    Image image(width, height, style_.background);
    const Vector background(style_.background.r, style_.background.g, style_.background.b);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        Vector sum = Vector::Zero();
        for (int j = 0; j < fine_; ++j) {
          for (int i = 0; i < fine_; ++i) {
            const Sample& sample = at(x * fine_ + i, y * fine_ + j);
            sum += sample.is_empty() ? background : sample.vector();
          }
        }
        sum /= fine_ * fine_;
        image.at(x, y) = {sum.x(), sum.y(), sum.z()};
      }
    }
    return image;
  }

  const Scene& scene_;
  Style style_;
  int fine_;
  Camera camera_;
  Grid grid_;
  std::vector<Sample> samples_;
  std::vector<bool> is_rim_;
  Occluders occluders_;
};

}  // namespace

Image render(const Scene& scene, const Camera& camera, const Style& style) {
  Image image = Painter(scene, camera, style).painted();
  for (const Label& label : scene.labels) {
    const Vector at = camera.seen(label.at);
    const Vector2 shift = style.unit * label.shift;
    draw_text(image, Vector2(at.x() + shift.x(), at.y() + shift.y()), label.text,
              style.unit * label.size, Align::Centre, label.colour, style.unit * label.size / 6);
  }
  return image;
}

}  // namespace morskin::pictures

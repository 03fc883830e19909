#include "app/pictures/canvas.h"

#include <algorithm>
#include <cmath>

namespace morskin::pictures {
namespace {

// The covered share of each pixel in a rectangle; overlapping strokes count once.
class Coverage {
 public:
  Coverage(const Image& image, std::span<const Stroke> strokes, double margin) {
    double left = image.width(), top = image.height(), right = 0, bottom = 0;
    for (const Stroke& stroke : strokes) {
      for (const Vector2& p : stroke) {
        left = std::min(left, p.x() - margin);
        right = std::max(right, p.x() + margin);
        top = std::min(top, p.y() - margin);
        bottom = std::max(bottom, p.y() + margin);
      }
    }
    x0_ = static_cast<int>(std::clamp(std::floor(left), 0.0, 1.0 * image.width()));
    y0_ = static_cast<int>(std::clamp(std::floor(top), 0.0, 1.0 * image.height()));
    x1_ = static_cast<int>(std::clamp(std::ceil(right), 1.0 * x0_, 1.0 * image.width()));
    y1_ = static_cast<int>(std::clamp(std::ceil(bottom), 1.0 * y0_, 1.0 * image.height()));
    share_.resize(static_cast<std::size_t>(x1_ - x0_) * static_cast<std::size_t>(y1_ - y0_));
  }

  // Covers the points nearer to the segment than half the width.
  void add(const Vector2& a, const Vector2& b, double width) {
    const double margin = width / 2 + 1;
    const int left = std::max(x0_, floored(std::min(a.x(), b.x()) - margin));
    const int right = std::min(x1_, floored(std::max(a.x(), b.x()) + margin) + 1);
    const int top = std::max(y0_, floored(std::min(a.y(), b.y()) - margin));
    const int bottom = std::min(y1_, floored(std::max(a.y(), b.y()) + margin) + 1);
    const Vector2 d = b - a;
    const double squared = d.squaredNorm();
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vector2 p = Vector2(x + 0.5, y + 0.5) - a;
        const double t = squared > 0 ? std::clamp(p.dot(d) / squared, 0.0, 1.0) : 0;
        const double share = std::clamp(width / 2 + 0.5 - (p - t * d).norm(), 0.0, 1.0);
        double& most = share_[index(x, y)];
        most = std::max(most, std::min(share, width));
      }
    }
  }

  void cover(Image& image, const Colour& colour) const {
    for (int y = y0_; y < y1_; ++y) {
      for (int x = x0_; x < x1_; ++x) image.cover(x, y, colour, share_[index(x, y)]);
    }
  }

 private:
  static int floored(double x) { return static_cast<int>(std::floor(std::clamp(x, -1e6, 1e6))); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y0_) * static_cast<std::size_t>(x1_ - x0_) +
           static_cast<std::size_t>(x - x0_);
  }

  int x0_, y0_, x1_, y1_;
  std::vector<double> share_;
};

// The dashes of a polyline.
std::vector<Stroke> dashes(std::span<const Vector2> points, double length) {
  std::vector<Stroke> result;
  double left = length;
  bool is_drawn = true;
  Stroke dash{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    Vector2 from = points[i - 1];
    for (double rest = (points[i] - from).norm(); rest > 0;) {
      const double step = std::min(rest, left);
      from += step / rest * (points[i] - from);
      dash.push_back(from);
      rest -= step;
      left -= step;
      if (left > 0) continue;
      if (is_drawn) result.push_back(dash);
      is_drawn = !is_drawn;
      dash.assign({from});
      left = length;
    }
  }
  if (is_drawn) result.push_back(dash);
  return result;
}

void draw_strokes(Image& image, std::span<const Stroke> strokes, double width,
                  const Colour& colour) {
  Coverage coverage(image, strokes, width / 2 + 1);
  for (const Stroke& stroke : strokes) {
    if (stroke.size() == 1) coverage.add(stroke[0], stroke[0], 1.5 * width);
    for (std::size_t i = 1; i < stroke.size(); ++i) coverage.add(stroke[i - 1], stroke[i], width);
  }
  coverage.cover(image, colour);
}

}  // namespace

void draw_line(Image& image, std::span<const Vector2> points, const Pen& pen) {
  if (points.empty()) return;
  std::vector<Stroke> strokes;
  if (pen.dash > 0) {
    strokes = dashes(points, pen.dash);
  } else {
    strokes.emplace_back(points.begin(), points.end());
  }
  draw_strokes(image, strokes, pen.width, pen.colour);
}

void draw_circle(Image& image, const Vector2& centre, double radius, const Pen& pen) {
  constexpr int sides = 180;
  Stroke circle;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    circle.push_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  draw_line(image, circle, pen);
}

void fill_disk(Image& image, const Vector2& centre, double radius, const Colour& colour) {
  draw_strokes(image, std::array{Stroke{centre, centre}}, 2 * radius, colour);
}

void draw_box(Image& image, const Box& box, const Pen& pen) {
  const std::array<Vector2, 5> corners{Vector2(box.left, box.top), Vector2(box.right, box.top),
                                       Vector2(box.right, box.bottom),
                                       Vector2(box.left, box.bottom), Vector2(box.left, box.top)};
  draw_line(image, corners, pen);
}

void draw_border(Image& image, const Pen& pen) {
  draw_box(image, {1, 1, image.width() - 1.0, image.height() - 1.0}, pen);
}

void draw_text(Image& image, const Vector2& at, std::string_view text, double size, Align align,
               const Colour& colour, double halo) {
  Lettering line = lettering(text);
  const double shift = align == Align::Left ? 0 : (align == Align::Centre ? 0.5 : 1) * line.width;
  for (Stroke& stroke : line.strokes) {
    for (Vector2& p : stroke) p = at + size * Vector2(p.x() - shift, -p.y());
  }
  const double width = 0.13 * size;
  if (halo > 0) draw_strokes(image, line.strokes, width + 2 * halo, white);
  draw_strokes(image, line.strokes, width, colour);
}

}  // namespace morskin::pictures

// Figure 9: the cross section of a real skin with its sandwiching balls, the tangent disk, and the
// longest edge that can come of it.

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "app/figures/figures.h"
#include "app/figures/panels.h"
#include "morskin/prepared_skin.h"

namespace morskin::figures {
namespace {

// The plane z = 0 as it is drawn, the tangent at a vertex level and its normal upwards.
struct Section {
  Vector2 middle;     // Angstrom
  Vector2 right, up;  // unit
  double scale;       // pixels per Angstrom
  int width, height;

  Vector2 seen(const Vector2& p) const {
    const Vector2 d = p - middle;
    return {width / 2.0 + scale * right.dot(d), height / 2.0 - scale * up.dot(d)};
  }
  Point point(double x, double y) const {
    const Vector2 p = middle + ((x - width / 2.0) * right - (y - height / 2.0) * up) / scale;
    return {p.x(), p.y(), 0};
  }
};

struct Scenario {
  morskin::PreparedSkin skin;
  surface::SurfacePoint a;
};

// Two balls about the x axis; `a` lies on the neck between them, off its waist.
Scenario scenario() {
  std::vector<geometry::WeightedPoint> balls{{{-1.62, 0, 0}, 2 * 1.15 * 1.15},
                                             {{1.5, 0, 0}, 2 * 1.3 * 1.3}};
  morskin::PreparedSkin skin = morskin::prepare_skin(std::move(balls));
  const auto a = skin.surface.project(Point(0.12, 0.75, 0), geometry::CellId{});
  return {std::move(skin), *a};
}

// Fills the body and draws its boundary: the sign and the size of G at every pixel.
void draw_body(Image& image, const morskin::PreparedSkin& skin, const Section& section,
               double pen) {
  const Colour body = Colour::of(0xdbe8f3), line = Colour::of(0x1d4e7e);
  constexpr int fine = 3;
  geometry::CellId cell{};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      double inside = 0, on_line = 0;
      for (int k = 0; k < fine * fine; ++k) {
        const Point p = section.point(x + (k % fine + 0.5) / fine, y + (k / fine + 0.5) / fine);
        cell = skin.surface.locate(p, cell);
        const skin::Patch& patch = skin.surface.complex().patch(cell);
        // |grad G| = 2 rho: G / (2 rho) is the distance to first order.
        const double distance = patch.value(p) / (2 * patch.half_gradient(p).norm());
        inside += distance < 0;
        on_line += std::abs(distance) * section.scale < pen / 2;
      }
      image.cover(x, y, body, inside / (fine * fine));
      image.cover(x, y, line, on_line / (fine * fine));
    }
  }
}

Image section_of(const Scenario& s, const Section& section, double scale, bool is_detail) {
  Image image(section.width, section.height);
  draw_body(image, s.skin, section, 2.6 * scale);
  const auto flat = [](const Vector& v) { return Vector2(v.x(), v.y()); };
  const Vector2 a = flat(s.a.position), n = flat(s.a.normal);
  const Vector2 t(n.y(), -n.x());  // along the surface, to the right
  const double rho = s.a.length_scale;
  const certify::Sizing sizing;
  const double half_edge = sizing.C * sizing.Q / (1 + 2 * sizing.C * sizing.Q) * rho;
  const double theta = std::asin(half_edge / rho);
  const double r = sizing.tangent_disk_share() * rho;
  const auto at = [&](const Vector2& p) { return section.seen(p); };
  const pictures::Pen ball{Colour::of(0xb0702a), 1.8 * scale, 7 * scale};
  const pictures::Pen thin{pictures::ink, 1.5 * scale};
  for (const double side : {-1.0, 1.0}) {
    draw_circle(image, at(a + side * rho * n), section.scale * rho, ball);
  }
  const std::array disk{at(a - r * t), at(a + r * t)};
  draw_line(image, std::array{at(a - 1.9 * r * t), at(a + 1.9 * r * t)},
            {Colour::of(0x8a8f98), 1.2 * scale, 5 * scale});
  draw_line(image, disk, {maximum_green, 4 * scale});
  // q, its projection b, and the b of the longest edge, on the sandwiching ball.
  const Vector2 q = a + r * t;
  const auto b = s.skin.surface.project(Point(q.x(), q.y(), 0), s.a.cell);
  const Vector2 longest = a + 2 * half_edge * (std::cos(theta) * t + std::sin(theta) * n);
  draw_line(image, std::array{at(a), at(longest)}, {front_red, 2.2 * scale});
  draw_line(image, std::array{at(q), at(longest)}, thin);
  draw_line(image, std::array{at(q), at(flat(b->position))}, thin);
  const double dot = 4.2 * scale, size = 15 * scale;
  const auto mark = [&](const Vector2& p, std::string_view text, double dx, double dy) {
    fill_disk(image, at(p), dot, pictures::ink);
    draw_text(image, at(p) + scale * Vector2(dx, dy), text, size, pictures::Align::Centre,
              pictures::ink, 2.5 * scale);
  };
  if (is_detail) {
    mark(a, "a", 0, 30);
    mark(q, "q", 0, 30);
    mark(longest, "b, on the ball", -10, -16);
    const Vector2 note = at(flat(b->position)) + scale * Vector2(44, 40);
    draw_line(image, std::array{at(flat(b->position)), note}, {pictures::ink, 1 * scale});
    draw_text(image, note + scale * Vector2(4, 12), "b, on the skin", size);
    mark(flat(b->position), "", 0, 0);
    draw_text(image, at(a + 0.5 * r * t) + scale * Vector2(0, 24), "r_a", size,
              pictures::Align::Centre, maximum_green, 2.5 * scale);
    draw_text(image, at(a + 0.5 * (longest - a)) + scale * Vector2(-8, -12), "2R_{ab}", size,
              pictures::Align::Centre, front_red, 2.5 * scale);
    draw_text(image,
              at(a + 0.8 * r * (std::cos(theta / 2) * t + std::sin(theta / 2) * n)) +
                  scale * Vector2(0, 5),
              "θ", 12 * scale, pictures::Align::Centre, pictures::ink, 2 * scale);
  } else {
    for (const double side : {-1.0, 1.0}) {
      const Vector2 centre = a + side * rho * n;
      draw_line(image, std::array{at(centre), at(a)}, thin);
      fill_disk(image, at(centre), dot, ball.colour);
      draw_text(image, at(a + 0.55 * side * rho * n) + scale * Vector2(34, 6), "ρ(a)", size,
                pictures::Align::Centre, pictures::ink, 2.5 * scale);
    }
    mark(a, "a", -22, -6);
    draw_text(image, at(a + 1.55 * rho * t - 1.6 * rho * n), "body", size, pictures::Align::Centre,
              Colour::of(0x1d4e7e));
  }
  return image;
}

}  // namespace

Image sandwiching_ball(double scale) {
  const Scenario s = scenario();
  const Vector2 a(s.a.position.x(), s.a.position.y());
  const Vector2 n(s.a.normal.x(), s.a.normal.y()), t(n.y(), -n.x());
  const double rho = s.a.length_scale;
  const auto pixels = [&](double length) { return static_cast<int>(std::lround(length * scale)); };
  const Section whole{a, t, n, 96 * scale / rho, pixels(430), pixels(430)};
  const Section detail{
      a + 0.138 * rho * t + 0.006 * rho * n, t, n, 1900 * scale / rho, pixels(640), pixels(430)};
  std::array panels{section_of(s, whole, scale, false), section_of(s, detail, scale, true)};
  const Vector2 middle = whole.seen(detail.middle);
  const double zoom = whole.scale / detail.scale / 2;
  const double w = zoom * detail.width, h = zoom * detail.height;
  draw_box(panels[0], {middle.x() - w, middle.y() - h, middle.x() + w, middle.y() + h},
           {pictures::ink, 1.5 * scale});
  draw_border(panels[1], {pictures::ink, 1.5 * scale});
  return captioned(panels,
                   std::array<std::string_view, 2>{"two balls between which the skin passes",
                                                   "the tangent disk of radius r_a"},
                   scale, 2);
}

}  // namespace morskin::figures

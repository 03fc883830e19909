// Figure 9: the cross section of a real skin with its sandwiching balls, the tangent disk, and the
// longest edge that can come of it.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

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

// The vertex and what is drawn about it, in the plane.
struct Construction {
  Vector2 a, n, t;  // the vertex, its normal, and along the surface to the right
  double rho;
  double r;                 // of the tangent disk
  double half_edge, theta;  // of the longest edge, and its angle with the tangent
  Vector2 q, b, longest;    // on the disk's rim, its projection, and the b of the longest edge
};

Construction construction(const Scenario& s) {
  const auto flat = [](const Vector& v) { return Vector2(v.x(), v.y()); };
  Construction c;
  c.a = flat(s.a.position);
  c.n = flat(s.a.normal);
  c.t = Vector2(c.n.y(), -c.n.x());
  c.rho = s.a.length_scale;
  const certify::Sizing sizing;
  c.r = sizing.tangent_disk_share() * c.rho;
  c.half_edge = sizing.C * sizing.Q / (1 + 2 * sizing.C * sizing.Q) * c.rho;
  c.theta = std::asin(c.half_edge / c.rho);
  c.q = c.a + c.r * c.t;
  c.b = flat(s.skin.surface.project(Point(c.q.x(), c.q.y(), 0), s.a.cell)->position);
  // On the sandwiching ball.
  c.longest = c.a + 2 * c.half_edge * (std::cos(c.theta) * c.t + std::sin(c.theta) * c.n);
  return c;
}

const Colour ball_brown = Colour::of(0xb0702a);

// One section, drawn in its own coordinates; widths and offsets in pixels of scale 1.
struct Drawing {
  const Section& section;
  double scale;
  Image image;

  Vector2 at(const Vector2& p, const Vector2& offset = Vector2::Zero()) const {
    return section.seen(p) + scale * offset;
  }
  void line(const Vector2& p, const Vector2& q, double width, const Colour& colour) {
    draw_line(image, std::array{at(p), at(q)}, {colour, width * scale});
  }
  void dot(const Vector2& p, const Colour& colour = pictures::ink) {
    fill_disk(image, at(p), 4.2 * scale, colour);
  }
  void text(const Vector2& p, const Vector2& offset, std::string_view text,
            const Colour& colour = pictures::ink) {
    draw_text(image, at(p, offset), text, 15 * scale, pictures::Align::Centre, colour, 2.5 * scale);
  }
  void mark(const Vector2& p, const Vector2& offset, std::string_view name) {
    dot(p);
    text(p, offset, name);
  }
};

// The balls, the disk, and where its rim goes on either ball at most, and on the skin.
void draw_construction(Drawing& drawing, const Construction& c) {
  const double scale = drawing.scale;
  for (const double side : {-1.0, 1.0}) {
    draw_circle(drawing.image, drawing.at(c.a + side * c.rho * c.n), drawing.section.scale * c.rho,
                {ball_brown, 1.8 * scale, 7 * scale});
  }
  const Vector2 tangent = 1.9 * c.r * c.t;
  draw_line(drawing.image, std::array{drawing.at(c.a - tangent), drawing.at(c.a + tangent)},
            {Colour::of(0x8a8f98), 1.2 * scale, 5 * scale});
  drawing.line(c.a - c.r * c.t, c.q, 4, maximum_green);
  drawing.line(c.a, c.longest, 2.2, front_red);
  drawing.line(c.q, c.longest, 1.5, pictures::ink);
  drawing.line(c.q, c.b, 1.5, pictures::ink);
}

// On the section of both balls.
void name_radii(Drawing& drawing, const Construction& c) {
  for (const double side : {-1.0, 1.0}) {
    const Vector2 centre = c.a + side * c.rho * c.n;
    drawing.line(centre, c.a, 1.5, pictures::ink);
    drawing.dot(centre, ball_brown);
    drawing.text(c.a + 0.55 * side * c.rho * c.n, {34, 6}, "ρ(a)");
  }
  drawing.mark(c.a, {-22, -6}, "a");
  draw_text(drawing.image, drawing.at(c.a + 1.55 * c.rho * c.t - 1.6 * c.rho * c.n), "body",
            15 * drawing.scale, pictures::Align::Centre, Colour::of(0x1d4e7e));
}

// On the section of the tangent disk.
void name_points(Drawing& drawing, const Construction& c) {
  const double scale = drawing.scale;
  drawing.mark(c.a, {0, 30}, "a");
  drawing.mark(c.q, {0, 30}, "q");
  drawing.mark(c.longest, {-10, -16}, "b, on the ball");
  const Vector2 beside(44, 40);
  draw_line(drawing.image, std::array{drawing.at(c.b), drawing.at(c.b, beside)},
            {pictures::ink, 1 * scale});
  draw_text(drawing.image, drawing.at(c.b, beside + Vector2(4, 12)), "b, on the skin", 15 * scale);
  drawing.dot(c.b);
  drawing.text(c.a + 0.5 * c.r * c.t, {0, 24}, "r_a", maximum_green);
  drawing.text(c.a + 0.5 * (c.longest - c.a), {-8, -12}, "2R_{ab}", front_red);
  const Vector2 between = std::cos(c.theta / 2) * c.t + std::sin(c.theta / 2) * c.n;
  draw_text(drawing.image, drawing.at(c.a + 0.8 * c.r * between, {0, 5}), "θ", 12 * scale,
            pictures::Align::Centre, pictures::ink, 2 * scale);
}

Drawing section_of(const Scenario& s, const Construction& c, const Section& section, double scale) {
  Drawing drawing{section, scale, Image(section.width, section.height)};
  draw_body(drawing.image, s.skin, section, 2.6 * scale);
  draw_construction(drawing, c);
  return drawing;
}

}  // namespace

Image sandwiching_ball(double scale) {
  const Scenario s = scenario();
  const Construction c = construction(s);
  const auto pixels = [&](double length) { return static_cast<int>(std::lround(length * scale)); };
  const Section whole{c.a, c.t, c.n, 96 * scale / c.rho, pixels(430), pixels(430)};
  const Section detail{c.a + 0.138 * c.rho * c.t + 0.006 * c.rho * c.n,
                       c.t,
                       c.n,
                       1900 * scale / c.rho,
                       pixels(640),
                       pixels(430)};
  Drawing balls = section_of(s, c, whole, scale), disk = section_of(s, c, detail, scale);
  name_radii(balls, c);
  name_points(disk, c);
  std::array panels{std::move(balls.image), std::move(disk.image)};
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

#pragma once

/// The laws of surface::Surface, for any surface.

#include "surface/surface.h"
#include "tests/support/test.h"

namespace morskin::support {

/// Where a surface's enclosures have to be finite.
enum class Enclosed { Everywhere, NearTheSurface };

/// Tries a surface's laws at random points of its bounding ball.
/// @param rounding  of G, Angstrom^2
class SurfaceLaws {
 public:
  SurfaceLaws(const surface::Surface& surface, unsigned seed, double rounding, Enclosed enclosed)
      : surface_(surface), random_(seed), rounding_(rounding), enclosed_(enclosed) {}

  void check() {
    for (int i = 0; i < 40; ++i) {
      half_gradient_is_lipschitz();
      enclosures_hold();
      segments_cross_where_sides_change();
      const auto p = some_point();
      if (!p) continue;
      CHECK(is_enclosed(p->position));
      projection_settles(*p);
      balls_are_free(*p);
      length_scale_is_lipschitz(*p);
    }
    samples_lie_on_the_surface();
  }

 private:
  using Point = geometry::Point;

  Point anywhere() {
    const surface::BoundingBall ball = surface_.bounding_ball();
    return ball.centre + ball.radius * random_.uniform() * random_.direction();
  }
  surface::CellId cell_at(const Point& x) const { return surface_.locate(x, surface::CellId{0U}); }
  surface::Jet jet(const Point& x) const { return surface_.jet(x, cell_at(x)); }
  /// A point of F: where some segment crosses it.
  std::optional<surface::SurfacePoint> some_point() {
    const auto found = surface_.crossings(anywhere(), anywhere(), surface::CellId{0U}).all;
    if (found.empty()) return std::nullopt;
    const auto& crossing = found[random_.below(found.size())];
    return surface_.project(crossing.position, crossing.cell);
  }

  void samples_lie_on_the_surface() {
    const surface::Samples samples = surface_.samples();
    CHECK(samples.each > 0);
    for (const surface::SurfacePoint& p : samples.points) {
      CHECK(surface_.is_in(p.position, p.cell));
      CHECK(std::abs(jet(p.position).value) <= rounding_);
      CHECK(p.length_scale == surface_.at(p.position, p.cell).length_scale);
    }
  }

  bool is_enclosed(const Point& x) const {
    return std::isfinite(surface_.enclose(x, cell_at(x)).error);
  }

  void half_gradient_is_lipschitz() {
    const Point x = anywhere();
    const double reach = 2 * jet(x).half_gradient.norm();
    const Point y = enclosed_ == Enclosed::Everywhere
                        ? Point(x + (anywhere() - x) * std::pow(random_.uniform(), 3))
                        : Point(x + reach * random_.uniform() * random_.direction());
    if (!is_enclosed(x)) return;
    const double distance = (x - y).norm();
    CHECK((jet(x).half_gradient - jet(y).half_gradient).norm() <= distance * (1 + 1e-9) + 1e-9);
  }

  void enclosures_hold() {
    const Point x = anywhere();
    const surface::Jet at_x = jet(x);
    if (enclosed_ == Enclosed::NearTheSurface && !is_enclosed(x)) return;
    for (const surface::CellId hint : {cell_at(x), cell_at(anywhere())}) {
      const surface::Enclosure about = surface_.enclose(x, hint);
      CHECK(about.low <= at_x.value + rounding_);
      CHECK(about.high >= at_x.value - rounding_);
      CHECK(about.high - about.low <= rounding_);
      CHECK((about.half_gradient - at_x.half_gradient).norm() <= about.error + 1e-9);
      CHECK(about.error <= std::sqrt(2 * rounding_) + 1e-9);
    }
  }

  void segments_cross_where_sides_change() {
    const Point p = anywhere(), q = anywhere();
    const surface::LineCrossings found = surface_.crossings(p, q, cell_at(p));
    CHECK(found.is_complete);
    const bool changes = (jet(p).value > 0) != (jet(q).value > 0);
    CHECK((found.all.size() % 2 == 1) == changes);
    for (const surface::LineCrossing& crossing : found.all) {
      CHECK(std::abs(jet(crossing.position).value) <= rounding_);
    }
  }

  void projection_settles(const surface::SurfacePoint& p) {
    const Point x = p.position + 0.4 * p.length_scale * random_.direction();
    const auto once = surface_.project(x, p.cell), again = surface_.project(x, p.cell);
    REQUIRE(once.has_value());
    REQUIRE(again.has_value());
    CHECK(once->position == again->position);
    CHECK(once->cell == again->cell);
    CHECK(std::abs(surface_.jet(once->position, once->cell).value) <=
          surface_.residual_bound(once->length_scale));
    CHECK(surface_.is_in(once->position, once->cell));
    const surface::SurfacePoint same = surface_.at(once->position, once->cell);
    CHECK(same.length_scale == once->length_scale);
    CHECK(same.normal == once->normal);
  }

  void balls_are_free(const surface::SurfacePoint& p) {
    for (const double side : {1.0, -1.0}) {
      const Point centre = p.position + side * p.length_scale * p.normal;
      const Point x = centre + 0.999 * p.length_scale * random_.uniform() * random_.direction();
      CHECK(side * jet(x).value > -rounding_);
    }
  }

  void length_scale_is_lipschitz(const surface::SurfacePoint& p) {
    const auto q =
        surface_.project(p.position + 0.5 * p.length_scale * random_.direction(), p.cell);
    if (!q) return;
    const double distance = (p.position - q->position).norm();
    CHECK(std::abs(p.length_scale - q->length_scale) <= distance * (1 + 1e-9) + 1e-9);
  }

  const surface::Surface& surface_;
  Random random_;
  double rounding_;
  Enclosed enclosed_;
};

inline void check_surface_laws(const surface::Surface& surface, unsigned seed, double rounding,
                               Enclosed enclosed = Enclosed::Everywhere) {
  SurfaceLaws(surface, seed, rounding, enclosed).check();
}

}  // namespace morskin::support

#include "implicit/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morskin::implicit {

namespace {

/// Above the rounding of the few operations that follow.
constexpr double up = 1 + 1e-12;
/// Of a few operations and a function of the C library.
constexpr double rounding = 0x1p-48;

/// The surface's part in a box of the cover, by the share of its side that it faces along the axis:
/// it is counted in the one box of a column in which f changes sign along the middle line.
double area_estimate(const Function& f, const CoverBox& b) {
  const Vector along = b.box.half * Vector::Unit(b.axis);
  const bool is_crossed =
      (f.at(b.box.centre - along).value > 0) != (f.at(b.box.centre + along).value > 0);
  if (!is_crossed) return 0;
  const Vector gradient = f.at(b.box.centre).gradient;
  return 4 * b.box.half * b.box.half * gradient.norm() / std::abs(gradient[b.axis]);
}

}  // namespace

ImplicitSurface::ImplicitSurface(std::shared_ptr<const Function> f, Cover cover,
                                 const Levelling& levelling, Room room, double M)
    : f_(std::move(f)),
      cover_(std::move(cover)),
      levelling_(levelling),
      room_(std::move(room)),
      body_(cover_.bounding_ball()),
      M_(M),
      max_length_scale_(up * cover_.max_gradient() / M) {
  double widest = 0;
  for (const CoverBox& b : cover_.boxes) {
    max_integral_ += b.max_area() * (M_ / b.min_gradient) * (M_ / b.min_gradient);
    widest = std::max(widest, f_->enclose(b.box.centre).value.width());
  }
  error_ = 4 * 2 * widest / M_;
  rounding_ = 0x1p-51 * (body_.centre.cwiseAbs().maxCoeff() + body_.radius);
}

surface::Jet ImplicitSurface::jet(const Point& x, CellId) const {
  const auto [value, gradient] = f_->at(x);
  return {2 * levelling_.value(value) / M_, (levelling_.slope(value) / M_) * gradient};
}

surface::Enclosure ImplicitSurface::enclose(const Point& x, CellId) const {
  const Jet<Interval, 1> f = f_->enclose(x);
  const auto levelled = [&](double value, double side) {
    const double G = 2 * levelling_.value(value) / M_;
    return G + side * rounding * std::abs(G);
  };
  const Interval slope = levelling_.slope(f.value);
  surface::Enclosure result{levelled(f.value.low, -1), levelled(f.value.high, 1), {}, 0};
  Triple<Interval> radii;
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval n = slope * f.gradient[k] / Interval(M_);
    result.half_gradient[static_cast<int>(k)] = n.middle();
    radii[k] = n.radius();
  }
  result.error = max_norm(radii);
  // A conclusion about x reaches no farther than a triangle's circumradius and a path of the flow,
  // each shorter than |N|.
  const double reach = 2 * up * (result.half_gradient.norm() + result.error);
  if (!room_.contains(x, reach)) {
    return {-Interval::infinity, Interval::infinity, result.half_gradient, Interval::infinity};
  }
  return result;
}

/// With n = |N| and g = |G|, the step s towards the surface solves 2 n s + s^2 = g. Along it |G|
/// falls by 2 n s - s^2 to 2 n s + s^2, so what is left has the same sign and is at most 2 s^2. As
/// n falls by no more than s, q = g / n^2 becomes at most 2 (a - 1)^2 / (2 - a)^2, a^2 = 1 + q:
/// less than q if q < 1, and less than q^2 if q < 1/4. So it arrives from all of the tube.
std::optional<surface::SurfacePoint> ImplicitSurface::project(const Point& x, CellId cell) const {
  constexpr int max_steps = 60;
  Point at = x;
  for (int step = 0; step < max_steps; ++step) {
    const auto [G, N] = jet(at, cell);
    const double n = N.norm(), g = std::abs(G);
    if (!(n > 0) || !std::isfinite(g)) return std::nullopt;
    if (g <= residual_bound(n)) return surface::SurfacePoint{at, N / n, n, CellId{0U}};
    const double s = g / (n + std::sqrt(n * n + g));
    at -= (G > 0 ? s : -s) / n * N;
  }
  return std::nullopt;
}

surface::LineCrossings ImplicitSurface::crossings(const Point& p, const Point& q, CellId) const {
  surface::LineCrossings result;
  const double length = (q - p).norm();
  if (!(length > 0)) return result;
  // Outside of the body's ball there are none.
  const auto chord = body_.chord(p, (q - p) / length);
  if (!chord) return result;
  const double low = std::max(0.0, chord->low / length), high = std::min(1.0, chord->high / length);
  if (low < high) halve(p, q, low, high, result);
  return result;
}

/// A piece is settled once it is far from the cover. In the room it is settled once its ends tell
/// that it stays on one side, or once G is monotone on it: N is 1-Lipschitz, so along the piece its
/// part keeps its sign where it is longer than the piece. One that touches the surface within
/// rounding is never, and is halved no further than to `min_share`: its ends count.
void ImplicitSurface::halve(const Point& p, const Point& q, double low, double high,
                            surface::LineCrossings& found) const {
  const Point a = p + low * (q - p), b = p + high * (q - p);
  const double length = (b - a).norm();
  if (!room_.may_meet_cover((a + b) / 2, length / 2)) return;
  const double middle = (low + high) / 2;
  constexpr double min_share = 1e-12;
  if (high - low > min_share && !room_.contains((a + b) / 2, length / 2)) {
    halve(p, q, low, middle, found);
    return halve(p, q, middle, high, found);
  }
  const surface::Jet at_a = jet(a, CellId{0U}), at_b = jet(b, CellId{0U});
  const bool is_one_side = (at_a.value > 0) == (at_b.value > 0);
  if (is_one_side && surface::is_certainly_clear(length, std::sqrt(std::abs(at_a.value)),
                                                 std::sqrt(std::abs(at_b.value)))) {
    return;
  }
  const bool is_monotone = std::abs(at_a.half_gradient.dot(b - a)) > length * length;
  if (is_monotone || high - low < min_share) {
    if (!is_one_side) found.all.push_back(zero(p, q, low, high, at_a.value > 0));
    return;
  }
  halve(p, q, low, middle, found);
  halve(p, q, middle, high, found);
}

surface::LineCrossing ImplicitSurface::zero(const Point& p, const Point& q, double low, double high,
                                            bool is_outside_at_low) const {
  constexpr int halvings = 60;
  for (int step = 0; step < halvings; ++step) {
    const double middle = (low + high) / 2;
    const bool is_outside = jet(p + middle * (q - p), CellId{0U}).value > 0;
    (is_outside == is_outside_at_low ? low : high) = middle;
  }
  return {high, p + high * (q - p), CellId{0U}};
}

surface::Samples ImplicitSurface::samples() const {
  constexpr double most = 4096;
  std::vector<double> integral;  // by box
  double whole = 0, met = 0;     // met: boxes that seem to be
  for (const CoverBox& b : cover_.boxes) {
    const double n = std::sqrt(b.min_gradient * b.max_gradient) / M_;
    integral.push_back(area_estimate(*f_, b) / (n * n));
    whole += integral.back();
    met += integral.back() > 0 ? 1 : 0;
  }
  surface::Samples result{{}, whole / std::max(1.0, std::min(most, met))};
  double due = 0;
  for (std::size_t i = 0; i < cover_.boxes.size(); ++i) {
    due += integral[i];
    if (!(due > result.each / 2)) continue;
    const auto p = project(cover_.boxes[i].box.centre, CellId{0U});
    for (; due > result.each / 2; due -= result.each) {
      if (p) result.points.push_back(*p);
    }
  }
  return result;
}

}  // namespace morskin::implicit

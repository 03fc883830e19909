#include "implicit/gaussians.h"

#include <cmath>
#include <utility>

#include "geometry/error.h"

namespace morskin::implicit {

namespace {

constexpr double fine_tail = 0x1p-60, coarse_tail = 0x1p-24;

Interval square_norm(const Triple<Interval>& v) {
  return square(v[0]) + square(v[1]) + square(v[2]);
}

Triple<Interval> difference(const Point& a, const Point& b) {
  return {Interval(a.x()) - b.x(), Interval(a.y()) - b.y(), Interval(a.z()) - b.z()};
}

}  // namespace

Gaussians::Gaussians(std::vector<Ball> balls, const GaussianOptions& options)
    : balls_(std::move(balls)), options_(options) {
  const auto& [decay, level] = options_;
  if (balls_.empty()) throw geometry::RefusedInput("a Gaussian surface needs an atom");
  if (!(decay >= 1e-3 && decay <= 1e3)) {
    throw geometry::RefusedInput("the decay must be from 0.001 to 1000 per square Angstrom");
  }
  if (!(level >= 1e-6 && level <= 1e6)) {
    throw geometry::RefusedInput("the level must be from 1e-6 to 1e6");
  }
  Point low = balls_.front().centre, high = low;
  double largest = 0;
  for (const Ball& ball : balls_) {
    low = low.cwiseMin(ball.centre);
    high = high.cwiseMax(ball.centre);
    largest = std::max(largest, ball.radius);
  }
  // At a distance t from all centres the sum is at most n exp(-decay (t^2 - r^2)).
  const double n = static_cast<double>(balls_.size());
  const double squared = largest * largest + std::max(0.0, std::log(n / level)) / decay;
  constexpr double room = 1.01;  // over rounding, and so that f is well above zero outside
  const double half = room * ((high - low).maxCoeff() / 2 + std::sqrt(squared)) + 1e-3;
  // A power of two about a point of a coarse grid is halved without rounding.
  const auto on_grid = [](double x) { return std::round(x * 16) / 16; };
  extent_ = {((low + high) / 2).unaryExpr(on_grid), std::exp2(std::ceil(std::log2(half + 0.1)))};
  farthest_ = 4 * extent_.half;
  for (std::uint32_t i = 0; i < balls_.size(); ++i) all_.push_back(i);
  constexpr double usual_side = 1;  // Angstrom
  constexpr double most = 48;
  voxels_ = static_cast<int>(std::clamp(2 * extent_.half / usual_side, 1.0, most));
  voxel_side_ = 2 * extent_.half / voxels_;
  fill_grids();
}

double Gaussians::sum_at(double f) const { return options_.level * std::exp(-options_.decay * f); }

/// A ball may be left out where its power distance exceeds another's so much, all over the part of
/// space, that n of its kind have no more than the tail.
std::vector<std::uint32_t> Gaussians::counting(Ids ids, const Point& middle, double radius,
                                               double tail) const {
  const double gap = std::log(static_cast<double>(balls_.size()) / tail) / options_.decay;
  std::vector<double> distances;
  distances.reserve(ids.size());
  double least = Interval::infinity;
  for (const std::uint32_t id : ids) {
    const Ball& ball = balls_[id];
    const double far = distances.emplace_back((middle - ball.centre).norm()) + radius;
    least = std::min(least, far * far - ball.radius * ball.radius);
  }
  const double most = least + gap;
  std::vector<std::uint32_t> result;
  result.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Ball& ball = balls_[ids[i]];
    const double near = std::max(0.0, distances[i] - radius);
    if (near * near - ball.radius * ball.radius < most) result.push_back(ids[i]);
  }
  return result;
}

/// What counts in a voxel counts in a cube of voxels too, whose ball is wider by far more than
/// rounding; and so does the ball that the others are held against.
void Gaussians::fill_grids() {
  constexpr int side = 6;         // of a cube, in voxels
  constexpr double round = 0.87;  // of a cube's circumscribed ball, over its side, with a margin
  const Point corner = extent_.centre - Vector::Constant(extent_.half);
  const int cubes = (voxels_ + side - 1) / side;
  const auto for_each = [](int count, auto visit) {
    for (int k = 0; k < count; ++k) {
      for (int j = 0; j < count; ++j) {
        for (int i = 0; i < count; ++i) visit(i, j, k);
      }
    }
  };
  std::vector<std::vector<std::uint32_t>> in_cube;
  for_each(cubes, [&](int i, int j, int k) {
    const Point middle = corner + side * voxel_side_ * (Vector(i, j, k) + Vector::Constant(0.5));
    in_cube.push_back(counting(all_, middle, side * voxel_side_ * round, fine_tail));
    in_cube.back().shrink_to_fit();
  });
  fine_.tail = fine_tail;
  coarse_.tail = coarse_tail;
  for_each(voxels_, [&](int i, int j, int k) {
    const Point middle = corner + voxel_side_ * (Vector(i, j, k) + Vector::Constant(0.5));
    const int cube = (k / side * cubes + j / side) * cubes + i / side;
    Ids ids = in_cube[static_cast<std::size_t>(cube)];
    std::vector<std::uint32_t> kept;
    for (Grid* const grid : {&fine_, &coarse_}) {  // of what counts in the one, in the other
      kept = counting(ids, middle, voxel_side_ * round, grid->tail);
      ids = kept;
      grid->first.push_back(grid->ids.size());
      grid->ids.insert(grid->ids.end(), kept.begin(), kept.end());
    }
  });
  for (Grid* const grid : {&fine_, &coarse_}) grid->first.push_back(grid->ids.size());
}

std::size_t Gaussians::voxel(const Point& x) const {
  const Vector at = (x - extent_.centre).array() + extent_.half;
  std::size_t result = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const double i = std::floor(at[axis] / voxel_side_);
    if (!(i >= 0 && i < voxels_)) return voxel_count();
    result = result * static_cast<std::size_t>(voxels_) + static_cast<std::size_t>(i);
  }
  return result;
}

Gaussians::Ids Gaussians::near(const Box& box, const Grid& grid) const {
  const Vector to_corner = Vector::Constant(box.half);
  const std::size_t v = voxel(box.centre - to_corner);
  const bool is_in_one = v < voxel_count() && v == voxel(box.centre + to_corner);
  if (!is_in_one) return all_;
  return Ids(grid.ids).subspan(grid.first[v], grid.first[v + 1] - grid.first[v]);
}

double Gaussians::least_power(const Point& x, Ids ids) const {
  double least = Interval::infinity;
  for (const std::uint32_t id : ids) {
    const Ball& ball = balls_[id];
    least = std::min(least, (x - ball.centre).squaredNorm() - ball.radius * ball.radius);
  }
  return least;
}

Function::Value Gaussians::at(const Point& x) const {
  const Ids ids = near({x, 0}, fine_);
  const auto& [decay, level] = options_;
  const double least = least_power(x, ids);
  double sum = 0;
  Vector mean = Vector::Zero();  // of x - a
  for (const std::uint32_t id : ids) {
    const Ball& ball = balls_[id];
    const Vector off = x - ball.centre;
    const double weight =
        std::exp(-decay * (off.squaredNorm() - ball.radius * ball.radius - least));
    sum += weight;
    mean += weight * off;
  }
  return {least - std::log(sum / level) / decay, (2 / sum) * mean};
}

/// exp(-decay (power - shift)) by ball, and their sum, by which the mean and the value are found.
struct Gaussians::Terms {
  double shift;
  Point reference;  ///< nearly the mean of the centres
  std::vector<Interval> weights;
  Interval sum;
  Triple<Interval> mean;  ///< less the reference
};

Gaussians::Terms Gaussians::terms(const Point& x, Ids ids, double tail) const {
  Terms result{least_power(x, ids), x - at(x).gradient / 2, {}, 0.0, {}};
  result.weights.reserve(ids.size());
  for (const std::uint32_t id : ids) {
    const auto& [centre, radius] = balls_[id];
    const Interval power = square_norm(difference(x, centre)) - square(Interval(radius));
    const Interval weight = exp(Interval(-options_.decay) * (power - result.shift));
    result.weights.push_back(weight);
    result.sum += weight;
    const Triple<Interval> off = difference(centre, result.reference);
    for (std::size_t k = 0; k < 3; ++k) result.mean[k] += weight * off[k];
  }
  for (Interval& m : result.mean) m = m / result.sum + Interval::about(0, 2 * tail * farthest_);
  return result;
}

Jet<Interval, 1> Gaussians::enclose(const Point& x) const {
  const auto [shift, reference, weights, sum, mean] = terms(x, near({x, 0}, fine_), fine_tail);
  Jet<Interval, 1> result;
  static_assert(2 * fine_tail < 0x1p-52);  // so that up() counts the balls that are left out
  const Interval whole_sum{sum.low, Interval::up(sum.high)};
  result.value =
      Interval(shift) - log(whole_sum / Interval(options_.level)) / Interval(options_.decay);
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    result.gradient[k] = Interval(2.0) * (Interval(x[axis]) - reference[axis] - mean[k]);
  }
  return result;
}

/// With b near the mean at the centre c, the shares at c + v are those at c times exp(t), over the
/// mean of exp(t) by the shares at c, t = -2 decay (b - a) . v. That mean is at least the
/// exponential of the mean of t, which is small as b - mean is, and no more than that of exp |t|.
std::vector<Interval> Gaussians::shares(double half, const Terms& at_centre,
                                        std::span<const Triple<Interval>> off) const {
  const Interval reach = Interval(2 * options_.decay) * Interval(half);
  std::vector<Interval> growth;  // exp |t| at most
  growth.reserve(off.size());
  Interval most = 0.0;
  for (std::size_t i = 0; i < off.size(); ++i) {
    const Interval length = off[i][0].max_abs() + off[i][1].max_abs() + off[i][2].max_abs();
    growth.push_back(exp(reach * Interval(Interval::up(length.high * (1 + 0x1p-50)))));
    most += at_centre.weights[i] * growth[i];
  }
  const Triple<Interval>& mean = at_centre.mean;
  const double off_mean = mean[0].max_abs() + mean[1].max_abs() + mean[2].max_abs();
  const Interval least = at_centre.sum * exp(-(reach * Interval(off_mean * (1 + 0x1p-50))));
  std::vector<Interval> result;
  result.reserve(off.size());
  for (std::size_t i = 0; i < off.size(); ++i) {
    const double low = (at_centre.weights[i] / (growth[i] * most)).low;
    const double high = (at_centre.weights[i] * growth[i] / least).high;
    result.emplace_back(std::max(0.0, low), std::min(1.0, high));
  }
  return result;
}

Jet<Interval, 2> Gaussians::over(const Box& box) const {
  constexpr double small = 0x1p-8;  // Angstrom: bounds over such a box are meant to be narrow
  const Grid& grid = box.half < small ? fine_ : coarse_;
  const double tail = grid.tail, decay = options_.decay;
  const Ids ids = near(box, grid);
  const Terms at_centre = terms(box.centre, ids, tail);
  std::vector<Triple<Interval>> off;  // centres less the reference
  off.reserve(ids.size());
  for (const std::uint32_t id : ids)
    off.push_back(difference(balls_[id].centre, at_centre.reference));
  const std::vector<Interval> share = shares(box.half, at_centre, off);
  Triple<Interval> first;  // moments of the centres
  std::array<Interval, 6> second;
  for (std::size_t i = 0; i < off.size(); ++i) {
    const Triple<Interval>& y = off[i];
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] += share[i] * y[k];
      for (std::size_t l = k; l < 3; ++l) {
        second[symmetric_index[k][l]] += share[i] * (k == l ? square(y[k]) : y[k] * y[l]);
      }
    }
  }
  Jet<Interval, 2> result;
  result.value = Interval::whole();
  const Interval first_tail = Interval::about(0, 2 * tail * farthest_);
  const Interval second_tail = Interval::about(0, 4 * tail * farthest_ * farthest_);
  for (std::size_t k = 0; k < 3; ++k) first[k] += first_tail;
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    result.gradient[k] = Interval(2.0) * (box.side(axis) - at_centre.reference[axis] - first[k]);
    for (std::size_t l = k; l < 3; ++l) {
      const std::size_t at = symmetric_index[k][l];
      const Interval product = k == l ? square(first[k]) : first[k] * first[l];
      const Interval covariance = second[at] + second_tail - product;
      result.hessian[at] = Interval(k == l ? 2.0 : 0.0) - Interval(4 * decay) * covariance;
    }
  }
  return result;
}

}  // namespace morskin::implicit

#include "skin/enclosure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace morskin::skin {

namespace {

using geometry::AtomId;
using geometry::Point;
using geometry::Vector;
using geometry::WeightedPoint;
using surface::Enclosure;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Above all that squares which are rounded to subnormal numbers can lose.
constexpr double underflow = 0x1p-1000;

/// An atom seen from x.
struct Seen {
  Vector u;      ///< z - x
  double power;  ///< |u|^2 - w
  double size;   ///< |u|^2 + |w|
};

Seen seen(const WeightedPoint& atom, const Point& x) {
  const Vector u = atom.position - x;
  const double square = u.x() * u.x() + u.y() * u.y() + u.z() * u.z();
  return {u, square - atom.weight, square + std::abs(atom.weight)};
}

/// Shares of up to four atoms. Multiples of 2^-50 between 0 and 1, so that sums of them are exact;
/// they add up to one.
using Shares = std::array<double, 4>;

/// The nearest shares to barycentric coordinates of which all but the first are given; nothing
/// where one is no number.
std::optional<Shares> shares(Shares s, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!std::isfinite(s[i])) return std::nullopt;
    s[i] = std::clamp(s[i], 0.0, 1.0);
    sum += s[i];
  }
  const double scale = sum > 1 ? 1 / sum : 1;
  s[0] = 1;
  for (std::size_t i = 1; i < count; ++i) {
    s[i] = std::min(std::round(s[i] * scale * 0x1p50) * 0x1p-50, s[0]);
    s[0] -= s[i];
  }
  return s;
}

/// The shares that make U least on the span of one to four atoms, moved into their hull if they lie
/// outside. There m changes along no edge e from the first atom without changing the powers' part
/// as much: 2 e . m = power of the first less that of the other.
std::optional<Shares> best_shares(std::span<const Seen> atoms) {
  Shares s{};
  std::array<Vector, 3> edge;
  std::array<double, 3> along{};  // of m, times the edge
  for (std::size_t i = 1; i < atoms.size(); ++i) {
    edge[i - 1] = atoms[i].u - atoms[0].u;
    along[i - 1] = (atoms[0].power - atoms[i].power) / 2;
  }
  const auto& [e, f, g] = edge;
  if (atoms.size() == 4) {
    const Vector fg = f.cross(g), ge = g.cross(e), ef = e.cross(f);
    const double volume = e.dot(fg);
    const Vector m = (along[0] * fg + along[1] * ge + along[2] * ef) / volume;
    const Vector from_first = m - atoms[0].u;
    s = {0, from_first.dot(fg) / volume, from_first.dot(ge) / volume, from_first.dot(ef) / volume};
  } else if (atoms.size() == 3) {
    const double a = along[0] - e.dot(atoms[0].u), b = along[1] - f.dot(atoms[0].u);
    const double squared_area = e.cross(f).squaredNorm();
    s = {0, (a * f.squaredNorm() - b * e.dot(f)) / squared_area,
         (b * e.squaredNorm() - a * e.dot(f)) / squared_area, 0};
  } else if (atoms.size() == 2) {
    s[1] = (along[0] - e.dot(atoms[0].u)) / e.squaredNorm();
  }
  return shares(s, atoms.size());
}

/// A convex combination and the bound on G(x) that it gives.
///
/// With u = 2^-53 and size = sum s_i (|u_i|^2 + |w_i|), the computed m is off by at most 5 u
/// sqrt(size): a difference, a product, three sums. The computed bound is off by 14 u size.
struct Upper {
  Vector m = Vector::Zero();
  double bound = infinity;
  double size = 0;
};

Upper upper(std::span<const Seen> atoms, const Shares& s) {
  Upper result;
  double powers = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    result.m += s[i] * atoms[i].u;
    powers += s[i] * atoms[i].power;
    result.size += s[i] * atoms[i].size;
  }
  const Vector& m = result.m;
  const double square = m.x() * m.x() + m.y() * m.y() + m.z() * m.z();
  result.bound = (square + powers) / 2 + 0x1p-49 * result.size + underflow;
  return result;
}

/// L for a stored q, given a lower bound on all powers there.
double lower_bound(const Point& x, const Point& q, double least_power) {
  const Vector d = x - q;
  const double square = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  const double half = least_power / 2;
  return half - square - (0x1p-49 * square + 0x1p-52 * std::abs(half) + underflow);
}

/// Atoms that were tried, and what they gave.
class Search {
 public:
  Search(std::span<const WeightedPoint> points, const PowerTree& tree, const Point& x)
      : points_(points), tree_(tree), x_(x) {}

  /// Tries the first atoms as they are.
  void begin(std::span<const AtomId> atoms) {
    for (const AtomId a : atoms) add(a);
    nearest_ = atoms.front();
    if (const auto s = best_shares({seen_.data(), count_})) take(upper({seen_.data(), count_}, *s));
  }

  /// Whether the bounds are narrow: beside N, or as narrow as rounding lets them be. At a corner of
  /// q's power cell the least power falls as far as q is moved, by an edge's length each way.
  bool is_narrow() const {
    constexpr double narrow = 0x1p-17;
    if (best_.error < narrow * best_.half_gradient.norm()) return true;
    const double moved = 0x1p-51 * x_.cwiseAbs().maxCoeff();
    return best_.high - best_.low < 0x1p-46 * size_ + moved * std::sqrt(size_);
  }

  /// Tries again with the atom of least power, which no atom tried before had.
  /// @return false if that can lead no further
  bool improve() {
    const bool is_new = std::find(ids_.begin(), ids_.begin() + count_, nearest_) ==
                        ids_.begin() + static_cast<std::ptrdiff_t>(count_);
    if ((is_exhausted_ && !is_new) || count_ == max_atoms) return false;
    if (is_new) add(nearest_);
    is_exhausted_ = true;
    take(best_of_subsets());
    return true;
  }

  const Enclosure& best() const { return best_; }

 private:
  static constexpr std::size_t max_atoms = 12;

  void add(AtomId a) {
    ids_[count_] = a;
    seen_[count_++] = seen(points_[a.index()], x_);
  }

  /// Bounds by a combination and its best q; kept if they are the narrowest so far.
  void take(const Upper& found) {
    if (!std::isfinite(found.bound)) return;
    const Point q = x_ - found.m;
    const PowerTree::Least least = tree_.least(q, nearest_, points_[nearest_.index()]);
    nearest_ = least.atom;
    const double low = std::max(lower_bound(x_, q, least.lower_bound), best_.low);
    const double error =
        std::sqrt(2 * (found.bound - low)) * (1 + 0x1p-50) + 0x1p-50 * std::sqrt(found.size);
    best_.low = low;
    best_.high = std::min(found.bound, best_.high);
    if (!(error < best_.error)) return;
    best_.error = error;
    best_.half_gradient = -found.m;
    size_ = found.size;
  }

  /// The least bound by one to four of the atoms: the best combination is one of so few, and
  /// simplices so flat that their shares are lost to rounding have others beside them.
  Upper best_of_subsets() const {
    Upper best;
    for (std::uint32_t subset = 1; subset < 1U << count_; ++subset) {
      const auto size = static_cast<std::size_t>(std::popcount(subset));
      if (size > 4) continue;
      std::array<Seen, 4> atoms;
      for (std::size_t i = 0, k = 0; i < count_; ++i) {
        if ((subset >> i & 1) != 0) atoms[k++] = seen_[i];
      }
      const std::span<const Seen> some(atoms.data(), size);
      const auto s = best_shares(some);
      if (!s) continue;
      const Upper found = upper(some, *s);
      if (found.bound < best.bound) best = found;
    }
    return best;
  }

  const std::span<const WeightedPoint> points_;
  const PowerTree& tree_;
  const Point& x_;
  std::array<AtomId, max_atoms> ids_;
  std::array<Seen, max_atoms> seen_;
  std::size_t count_ = 0;
  AtomId nearest_ = AtomId{0U};
  bool is_exhausted_ = false;
  double size_ = 0;  ///< of the combination behind the bounds
  Enclosure best_{-infinity, infinity, Vector::Zero(), infinity};
};

}  // namespace

Enclosure enclose(std::span<const WeightedPoint> points, const PowerTree& tree, const Point& x,
                  std::span<const AtomId> atoms) {
  constexpr double max_coordinate = 0x1p500;  // beyond, squares may overflow
  Search search(points, tree, x);
  for (const double coordinate : x) {
    if (!(std::abs(coordinate) <= max_coordinate)) return search.best();
  }
  search.begin(atoms);
  while (!search.is_narrow() && search.improve()) {
  }
  return search.best();
}

}  // namespace morskin::skin

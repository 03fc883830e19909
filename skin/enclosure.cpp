#include "skin/enclosure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "skin/quad.h"

namespace morskin::skin {

namespace {

using geometry::AtomId;
using geometry::Point;
using geometry::Vector;
using geometry::WeightedPoint;
using surface::Enclosure;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Bounds on N this narrow beside it are not made narrower.
constexpr double narrow = 0x1p-17;
/// Where doubles leave N less certain than this, quadruple precision is used: near necks of some
/// 10^-5 Angstrom, and critical points.
constexpr double wide = 0x1p-12;

/// An atom seen from x.
template <class Real>
struct Seen {
  Vector3<Real> u;  ///< z - x
  Real power;       ///< |u|^2 - w
  Real size;        ///< |u|^2 + |w|
};

template <class Real>
Seen<Real> seen(const WeightedPoint& atom, const Point& x) {
  const Vector3<Real> u = atom.position.cast<Real>() - x.cast<Real>();
  const Real square = u.x() * u.x() + u.y() * u.y() + u.z() * u.z();
  return {u, square - Real(atom.weight), square + Real(std::abs(atom.weight))};
}

/// Shares of up to four atoms. Multiples of 8 u between 0 and 1, so that sums of them are exact;
/// they add up to one.
template <class Real>
using Shares = std::array<Real, 4>;

/// The nearest shares to barycentric coordinates of which all but the first are given; nothing
/// where one is no number.
template <class Real>
std::optional<Shares<Real>> shares(Shares<Real> s, std::size_t count) {
  Real sum = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!is_finite(s[i])) return std::nullopt;
    s[i] = std::clamp<Real>(s[i], 0, 1);
    sum += s[i];
  }
  const Real scale = sum > 1 ? 1 / sum : Real(1);
  s[0] = 1;
  for (std::size_t i = 1; i < count; ++i) {
    const Real rounded = s[i] * scale + 6 - 6;  // between 4 and 8 numbers are multiples of 8 u
    s[i] = std::min(rounded, s[0]);
    s[0] -= s[i];
  }
  return s;
}

/// The shares that make U least on the span of one to four atoms, moved into their hull if they lie
/// outside. There m changes along no edge e from the first atom without changing the powers' part
/// as much: 2 e . m = power of the first less that of the other.
template <class Real>
std::optional<Shares<Real>> best_shares(std::span<const Seen<Real>> atoms) {
  Shares<Real> s{};
  std::array<Vector3<Real>, 3> edge;
  std::array<Real, 3> along{};  // of m, times the edge
  for (std::size_t i = 1; i < atoms.size(); ++i) {
    edge[i - 1] = atoms[i].u - atoms[0].u;
    along[i - 1] = (atoms[0].power - atoms[i].power) / 2;
  }
  const auto& [e, f, g] = edge;
  if (atoms.size() == 4) {
    const Vector3<Real> fg = f.cross(g), ge = g.cross(e), ef = e.cross(f);
    const Real volume = e.dot(fg);
    const Vector3<Real> m = (along[0] * fg + along[1] * ge + along[2] * ef) / volume;
    const Vector3<Real> from_first = m - atoms[0].u;
    s = {0, from_first.dot(fg) / volume, from_first.dot(ge) / volume, from_first.dot(ef) / volume};
  } else if (atoms.size() == 3) {
    const Real a = along[0] - e.dot(atoms[0].u), b = along[1] - f.dot(atoms[0].u);
    const Real squared_area = e.cross(f).squaredNorm();
    s = {0, (a * f.squaredNorm() - b * e.dot(f)) / squared_area,
         (b * e.squaredNorm() - a * e.dot(f)) / squared_area, 0};
  } else if (atoms.size() == 2) {
    s[1] = (along[0] - e.dot(atoms[0].u)) / e.squaredNorm();
  }
  return shares<Real>(s, atoms.size());
}

/// A convex combination and the bound on G(x) that it gives.
///
/// With size = sum s_i (|u_i|^2 + |w_i|), the computed m is off by at most 5 u sqrt(size): a
/// difference, a product, three sums. The computed bound is off by 14 u size.
template <class Real>
struct Upper {
  Vector3<Real> m = Vector3<Real>::Zero();
  Vector3<Real> main_atom = Vector3<Real>::Zero();  ///< u of the one with the largest share
  Real bound = infinity;
  Real size = 0;
};

template <class Real>
Upper<Real> upper(std::span<const Seen<Real>> atoms, const Shares<Real>& s) {
  Upper<Real> result;
  Real powers = 0, largest = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (s[i] > largest) {
      largest = s[i];
      result.main_atom = atoms[i].u;
    }
    result.m += s[i] * atoms[i].u;
    powers += s[i] * atoms[i].power;
    result.size += s[i] * atoms[i].size;
  }
  const Vector3<Real>& m = result.m;
  const Real square = m.x() * m.x() + m.y() * m.y() + m.z() * m.z();
  result.bound = (square + powers) / 2 + 16 * unit_roundoff<Real> * result.size + underflow;
  return result;
}

/// A q for L. The best one, x - m, is as near to all atoms of the combination, so rounding cannot
/// tell the nearest. Moved by t v, v from the middle of the combination to one of its atoms, it
/// comes nearer to that one than to another by 2 t v . (edge between them), for t |v|^2 off L.
template <class Real>
Vector3<Real> near_one_atom(const Point& x, const Upper<Real>& combination, double cost) {
  const Vector3<Real> best = x.cast<Real>() - combination.m;
  const Vector3<Real> v = combination.main_atom - combination.m;
  const Real square = v.squaredNorm();
  if (!(square > cost)) return best;  // else the square of the step would cost more
  return best + Real(cost) / square * v;
}

/// L for a stored q, given a lower bound on all powers there.
template <class Real>
Real lower_bound(const Point& x, const Vector3<Real>& q, Real least_power) {
  constexpr Real u = unit_roundoff<Real>;
  const Vector3<Real> d = x.cast<Real>() - q;
  const Real square = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  const Real half = least_power / 2;
  return half - square - (16 * u * square + 4 * u * magnitude(half) + underflow);
}

/// Atoms that were tried, and what they gave.
template <class Real>
class Search {
 public:
  Search(std::span<const WeightedPoint> points, const LeastPower& powers, const Point& x)
      : points_(points), powers_(powers), x_(x) {}

  /// Tries the first atoms as they are.
  void begin(std::span<const AtomId> atoms) {
    for (const AtomId a : atoms) add(a);
    const std::span<const Seen<Real>> first(seen_.data(), count_);
    if (const auto s = best_shares(first)) take(upper(first, *s));
  }

  /// Whether the bounds are narrow beside N, or as narrow as rounding lets them be.
  bool is_narrow() const {
    if (best_.error < narrow * best_.half_gradient.norm()) return true;
    return best_.high - best_.low < 4 * rounding(Real(size_));
  }

  /// Tries all combinations of the atoms so far, and of that of least power if it is none of them.
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
  static constexpr auto u = static_cast<double>(unit_roundoff<Real>);

  /// What rounding takes from L, in bad cases: of the powers, and of q as it is stored. At a corner
  /// of q's power cell the least power falls as far as q is moved, by an edge's length each way.
  double rounding(Real size) const {
    const auto at = static_cast<double>(size);
    return 64 * u * at + 4 * u * x_.cwiseAbs().maxCoeff() * std::sqrt(at);
  }

  void add(AtomId a) {
    ids_[count_] = a;
    seen_[count_++] = seen<Real>(points_[a.index()], x_);
  }

  /// Bounds by a combination and its best q; kept if they are the narrowest so far.
  void take(const Upper<Real>& found) {
    if (!is_finite(found.bound)) return;
    // Half of it tells the atoms apart as a rule, and all would widen the bounds.
    const Vector3<Real> q = near_one_atom<Real>(x_, found, rounding(found.size) / 2);
    const auto least = powers_.at(q, std::span(ids_.data(), count_));
    nearest_ = least.atom;
    low_ = std::max(lower_bound(x_, q, least.lower_bound), low_);
    best_.low = rounded_down(low_);
    best_.high = std::min(rounded_up(found.bound), best_.high);
    const Vector m = found.m.template cast<double>();
    const double stored = (found.m - m.cast<Real>()).template cast<double>().norm();
    const auto size = static_cast<double>(found.size);
    const double error = std::sqrt(2 * rounded_up(found.bound - low_)) * (1 + 0x1p-50) +
                         8 * u * std::sqrt(size) + stored * (1 + 0x1p-50);
    if (!(error < best_.error)) return;
    best_.error = error;
    best_.half_gradient = -m;
    size_ = size;
  }

  /// The least bound by one to four of the atoms: the best combination is one of so few, and
  /// simplices so flat that their shares are lost to rounding have others beside them.
  Upper<Real> best_of_subsets() const {
    Upper<Real> best;
    for (std::uint32_t subset = 1; subset < 1U << count_; ++subset) {
      const auto size = static_cast<std::size_t>(std::popcount(subset));
      if (size > 4) continue;
      std::array<Seen<Real>, 4> atoms;
      for (std::size_t i = 0, k = 0; i < count_; ++i) {
        if ((subset >> i & 1) != 0) atoms[k++] = seen_[i];
      }
      const std::span<const Seen<Real>> some(atoms.data(), size);
      const auto s = best_shares(some);
      if (!s) continue;
      const Upper<Real> found = upper(some, *s);
      if (found.bound < best.bound) best = found;
    }
    return best;
  }

  const std::span<const WeightedPoint> points_;
  const LeastPower& powers_;
  const Point& x_;
  std::array<AtomId, max_atoms> ids_;
  std::array<Seen<Real>, max_atoms> seen_;
  std::size_t count_ = 0;
  AtomId nearest_ = AtomId{0U};
  bool is_exhausted_ = false;
  double size_ = 0;  ///< of the combination behind the bounds
  Real low_ = -infinity;
  Enclosure best_{-infinity, infinity, Vector::Zero(), infinity};
};

template <class Real>
Enclosure search(std::span<const WeightedPoint> points, const LeastPower& powers, const Point& x,
                 std::span<const AtomId> atoms) {
  Search<Real> search(points, powers, x);
  search.begin(atoms);
  while (!search.is_narrow() && search.improve()) {
  }
  return search.best();
}

}  // namespace

Enclosure enclose(std::span<const WeightedPoint> points, const LeastPower& powers, const Point& x,
                  std::span<const AtomId> atoms) {
  constexpr double max_coordinate = 0x1p500;  // beyond, squares may overflow
  for (const double coordinate : x) {
    if (!(std::abs(coordinate) <= max_coordinate))
      return {-infinity, infinity, Vector::Zero(), infinity};
  }
  const Enclosure in_doubles = search<double>(points, powers, x, atoms);
  if (in_doubles.error < wide * in_doubles.half_gradient.norm()) return in_doubles;
  const Enclosure close = search<Quad>(points, powers, x, atoms);
  return close.error < in_doubles.error ? close : in_doubles;
}

}  // namespace morskin::skin

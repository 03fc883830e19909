#include "implicit/critical_heights.h"

#include "geometry/orthogonal.h"
#include "geometry/parallel.h"
#include "implicit/linear_algebra.h"

namespace morskin::implicit {

namespace {

/// Times that a box of the cover is halved.
constexpr int max_depth = 26;
/// Boxes of one that may be open at once; on a curve of critical points there are ever more.
constexpr std::size_t max_open = 256;
/// The test's box over the one it is for, so that a zero on a face lies well inside.
constexpr double inflation = 1.25;

/// A box of a zero narrows to rounding at once, or by next to nothing where the gradient turns much
/// in it; halves of that one narrow. By this share one tells.
constexpr double narrow_share = 0x1p-10;

/// F of one f and two directions.
class HeightSystem {
 public:
  HeightSystem(const Function& f, const LevelDirections& directions)
      : f_(f), u_(directions.u), v_(directions.v) {}

  /// Whether F has no zero in a box, by the values alone.
  bool excludes(const Jet<Interval, 2>& bounds) const {
    return !bounds.value.contains(0) || !dot(bounds.gradient, u_).contains(0) ||
           !dot(bounds.gradient, v_).contains(0);
  }
  SystemBounds system(const Box& box, const Jet<Interval, 2>& bounds) const {
    const Jet<Interval, 1> at_centre = f_.enclose(box.centre);
    return {{at_centre.value, dot(at_centre.gradient, u_), dot(at_centre.gradient, v_)},
            {bounds.gradient, times(bounds.hessian, u_), times(bounds.hessian, v_)}};
  }
  Jet<Interval, 2> bounds(const Box& box) const { return f_.bounds(box); }

  /// The index of a zero in a box, where the signs tell: the surface's height over its tangent
  /// plane has the Hessian -H / |grad f| on it, by the side on which the gradient points.
  std::optional<int> index(const Box& box) const {
    const Jet<Interval, 2> b = f_.bounds(box);
    const Triple<Interval> Hu = times(b.hessian, u_), Hv = times(b.hessian, v_);
    const Interval uu = dot(Hu, u_), uv = dot(Hu, v_), vv = dot(Hv, v_);
    const Interval determinant = uu * vv - square(uv);
    if (determinant.is_negative()) return 1;
    const Interval up = dot(b.gradient, u_.cross(v_)), trace = uu + vv;
    const bool is_known =
        (up.is_positive() || up.is_negative()) && (trace.is_positive() || trace.is_negative());
    if (!determinant.is_positive() || !is_known) return std::nullopt;
    return up.is_positive() == trace.is_negative() ? 0 : 2;
  }

 private:
  static Triple<Interval> times(const std::array<Interval, 6>& H, const Vector& w) {
    Triple<Interval> result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result[i] += H[symmetric_index[i][j]] * Interval(w[static_cast<int>(j)]);
      }
    }
    return result;
  }

  const Function& f_;
  const Vector u_, v_;
};

/// A box in which there is exactly one zero, and a smaller one in which it is.
struct Isolated {
  Box only, at;
  int index;
};

bool meet(const Box& a, const Box& b) {
  return (a.centre - b.centre).cwiseAbs().maxCoeff() <= a.half + b.half;
}

struct Findings {
  std::vector<Isolated> zeros;
  std::vector<Point> undecided;
};

class Search {
 public:
  explicit Search(const HeightSystem& system) : system_(system) {}

  /// Decides a box, by halving it.
  void search(const Box& whole, Findings& found) const {
    std::vector<Box> boxes{whole};
    for (int depth = 0; !boxes.empty(); ++depth) {
      if (depth > max_depth || boxes.size() > max_open) {
        found.undecided.push_back(boxes.front().centre);
        return;
      }
      std::vector<Box> open;
      for (const Box& box : boxes) {
        if (is_decided(box, found)) continue;
        if (!box.is_halved_exactly()) {
          found.undecided.push_back(box.centre);
          return;
        }
        for (int k = 0; k < 8; ++k) open.push_back(box.octant(k));
      }
      boxes = std::move(open);
    }
  }

 private:
  bool is_decided(const Box& box, Findings& found) const {
    const Jet<Interval, 2> bounds = system_.bounds(box);
    if (system_.excludes(bounds)) return true;
    const Box inflated{box.centre, inflation * box.half};
    const Krawczyk test = krawczyk(inflated, system_.system(inflated, system_.bounds(inflated)));
    if (test.verdict == Krawczyk::Verdict::None) return true;
    if (test.verdict == Krawczyk::Verdict::Undecided) return false;
    Isolated zero{inflated, box_about(test.zeros), 0};
    if (!narrow(zero) || !(zero.at.half < narrow_share * box.half)) return false;
    const std::optional<int> index = system_.index(zero.at);
    if (!index) return false;
    zero.index = *index;
    found.zeros.push_back(zero);
    return true;
  }
  /// Narrows the box around a zero by the same test, as far as rounding lets it.
  bool narrow(Isolated& zero) const {
    for (int step = 0; step < 60; ++step) {
      const Krawczyk test = krawczyk(zero.at, system_.system(zero.at, system_.bounds(zero.at)));
      if (test.verdict == Krawczyk::Verdict::None) return false;  // rounding alone could say so
      if (test.verdict != Krawczyk::Verdict::One) return true;
      const Box at = box_about(test.zeros);
      if (!(at.half < 0.9 * zero.at.half)) return true;
      zero.at = at;
    }
    return true;
  }

  const HeightSystem& system_;
};

/// Takes zeros found from neighbouring boxes once. Two are one where one's small box lies in the
/// other's box of one zero, two where the small boxes are apart; else it is left undecided.
void merge(const std::vector<Isolated>& zeros, CriticalHeights& result) {
  std::vector<Isolated> kept;
  for (const Isolated& zero : zeros) {
    bool is_new = true;
    for (const Isolated& other : kept) {
      if (!meet(zero.at, other.at)) continue;
      if (!other.only.contains(zero.at) && !zero.only.contains(other.at)) {
        result.undecided.push_back(zero.at.centre);
      }
      is_new = false;
      break;
    }
    if (!is_new) continue;
    kept.push_back(zero);
    result.points.push_back({zero.at.centre, zero.at.radius(), zero.index});
  }
}

}  // namespace

LevelDirections LevelDirections::of(const Vector& height) {
  const geometry::TangentFrame frame(height.normalized());
  return {frame.first, frame.second};
}

std::array<std::size_t, 3> CriticalHeights::counts() const {
  std::array<std::size_t, 3> result{};
  for (const CriticalHeight& p : points) ++result[static_cast<std::size_t>(p.index)];
  return result;
}

long CriticalHeights::euler_characteristic() const {
  const auto [minima, saddles, maxima] = counts();
  return static_cast<long>(minima + maxima) - static_cast<long>(saddles);
}

CriticalHeights critical_heights(const Function& f, const Cover& cover,
                                 const LevelDirections& directions, const geometry::Run& run) {
  const HeightSystem system(f, directions);
  const Search search(system);
  constexpr std::size_t block_size = 64;
  std::vector<Findings> parts(geometry::block_count(cover.boxes.size(), block_size));
  const auto search_block = [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t i = begin; i < end; ++i) search.search(cover.boxes[i].box, parts[block]);
  };
  geometry::for_each_block(run.threads(), cover.boxes.size(), search_block, block_size);
  CriticalHeights result{directions, {}, {}};
  std::vector<Isolated> zeros;
  for (const Findings& part : parts) {
    zeros.insert(zeros.end(), part.zeros.begin(), part.zeros.end());
    result.undecided.insert(result.undecided.end(), part.undecided.begin(), part.undecided.end());
  }
  merge(zeros, result);
  return result;
}

}  // namespace morskin::implicit

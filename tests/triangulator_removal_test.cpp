#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/regular_triangulation.h"
#include "geometry/triangulator.h"
#include "tests/support/ball_sets.h"

namespace morskin::geometry {
namespace {

using Points = std::vector<WeightedPoint>;
using Corner = Triangulator::Corner;
using Tetrahedra = std::vector<std::array<Corner, 4>>;

constexpr std::uint32_t none = 0xffffffff;

/// A triangulation under insertions, removals and moves, and what it should be: the points by
/// corner, which are also their ids.
class History {
 public:
  explicit History(const Points& first) : triangulator(first) {
    points.resize(first.size());
    is_in.assign(first.size(), 1);
    // The constructor reorders the points: number them by corner.
    for (std::size_t c = 0; c < first.size(); ++c) {
      id_.push_back(triangulator.atom(static_cast<Corner>(c))->value);
      points[c] = first[id_[c]];
    }
    for (std::uint32_t t = 0; t < triangulator.tetrahedra().size(); ++t) note(t);
  }

  /// Whether the point went in.
  bool add(const WeightedPoint& p, std::uint32_t hint) {
    const auto corner = triangulator.add(p, {hint, hint});
    if (!corner) return false;
    if (*corner == points.size()) {
      points.emplace_back();
      is_in.push_back(0);
      id_.push_back(*corner);
    }
    CHECK(is_in[*corner] == 0);
    CHECK(triangulator.atom(*corner)->value == id_[*corner]);
    points[*corner] = p;
    is_in[*corner] = 1;
    for (const std::uint32_t t : triangulator.added()) note(t);
    return true;
  }
  bool remove(Corner c) {
    if (!triangulator.remove(c, star_[c])) return false;
    is_in[c] = 0;
    for (const std::uint32_t t : triangulator.added()) note(t);
    return true;
  }
  bool move(Corner c, const WeightedPoint& to) {
    if (!triangulator.move(c, to, star_[c])) return false;
    points[c] = to;
    return true;
  }
  Corner any(std::mt19937_64& random) const {
    for (;;) {
      const auto c = static_cast<Corner>(random() % points.size());
      if (is_in[c] != 0) return c;
    }
  }
  std::uint32_t star(Corner c) const { return star_[c]; }
  std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(is_in, 1)); }

  /// By corner, sorted.
  Tetrahedra tetrahedra() const {
    Tetrahedra result;
    for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
      if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
      result.push_back(t.corners);
      std::ranges::sort(result.back());
    }
    std::ranges::sort(result);
    return result;
  }
  /// Those of a triangulation made at once of the points that are in, with their order of ids.
  Tetrahedra fresh_tetrahedra() const {
    std::vector<Corner> corners;
    for (Corner c = 0; c < points.size(); ++c) {
      if (is_in[c] != 0) corners.push_back(c);
    }
    std::ranges::sort(corners, {}, [&](Corner c) { return id_[c]; });
    Points left;
    for (const Corner c : corners) left.push_back(points[c]);
    Tetrahedra result;
    for (const auto& tetrahedron : regular_triangulation(left).tetrahedra) {
      auto& t = result.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) t[k] = corners[tetrahedron[k].index()];
      std::ranges::sort(t);
    }
    std::ranges::sort(result);
    return result;
  }
  /// Whether every facet's neighbour has the same facet, ghosts included.
  bool is_closed() const {
    for (std::uint32_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      if (!triangulator.is_live(i)) continue;
      for (std::uint32_t k = 0; k < 4; ++k) {
        const Triangulator::Facet g = triangulator.tetrahedra()[i].neighbours[k];
        const std::uint32_t there = Triangulator::tetrahedron_of(g);
        if (!triangulator.is_live(there)) return false;
        if (triangulator.tetrahedra()[there].neighbours[Triangulator::index_of(g)] != (i << 2 | k))
          return false;
        if (opposite_corners(i, k) != opposite_corners(there, Triangulator::index_of(g)))
          return false;
      }
    }
    return true;
  }

  Triangulator triangulator;
  Points points;
  std::vector<char> is_in;

 private:
  void note(std::uint32_t t) {
    if (!triangulator.is_live(t)) return;
    star_.resize(points.size(), none);
    for (const Corner c : triangulator.tetrahedra()[t].corners) {
      if (c < star_.size()) star_[c] = t;
    }
  }
  std::array<Corner, 3> opposite_corners(std::uint32_t t, std::size_t place) const {
    auto corners = triangulator.tetrahedra()[t].corners;
    std::swap(corners[place], corners[3]);
    std::sort(corners.begin(), corners.begin() + 3);
    return {corners[0], corners[1], corners[2]};
  }

  std::vector<std::uint32_t> id_;
  std::vector<std::uint32_t> star_;
};

WeightedPoint at(double x, double y, double z) { return {{x, y, z}, 0}; }

/// Points of one kind: the same seed gives the same stream.
class Source {
 public:
  Source(unsigned kind, unsigned seed) : kind_(kind), random_(seed) {}

  WeightedPoint next() {
    switch (kind_) {
      case 0:  // in a cube
        return at(random_.uniform(), random_.uniform(), random_.uniform());
      case 1: {  // of a small lattice: flat and cospherical, and many equal
        const auto whole = [&] { return static_cast<double>(random_.below(4)); };
        const double x = whole(), y = whole();
        return at(x, y, whole());
      }
      case 2: {  // on a sphere, to rounding: all on the hull, all nearly tied
        const Vector v = random_.direction();
        return {v, 0};
      }
      case 3: {  // on a sphere exactly: |x|^2 = 81, or its centre
        static const std::vector<Vector> on_sphere = whole_points_of_sphere();
        const std::size_t i = random_.below(on_sphere.size() + 1);
        return i == on_sphere.size() ? at(0, 0, 0) : WeightedPoint{on_sphere[i], 0};
      }
      case 4: {  // in two planes
        const auto whole = [&] { return static_cast<double>(random_.below(6)); };
        const double x = whole(), y = whole();
        return at(x, y, random_.uniform() < 0.8 ? 0 : 3);
      }
      default: {  // on a saddle, as samples of a surface are
        const double x = random_.between(-1, 1), y = random_.between(-1, 1);
        return at(x, y, x * x - y * y);
      }
    }
  }
  static constexpr unsigned kinds = 6;

  static std::vector<Vector> whole_points_of_sphere() {
    std::vector<Vector> result;
    for (int x = -9; x <= 9; ++x) {
      for (int y = -9; y <= 9; ++y) {
        for (int z = -9; z <= 9; ++z) {
          if (x * x + y * y + z * z == 81) result.emplace_back(x, y, z);
        }
      }
    }
    return result;
  }

 private:
  unsigned kind_;
  support::Random random_;
};

/// Points of a source until they span space.
Points spanning(Source& source) {
  Points points;
  while (points.size() < 4 || regular_triangulation(points).dimension < 3 ||
         !regular_triangulation(points).hidden.empty()) {
    points.push_back(source.next());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].position == points.back().position) {
        points.pop_back();
        break;
      }
    }
  }
  return points;
}

/// Seeds [0, count).
void check_insertions_and_removals(unsigned count) {
  std::size_t refused = 0, removed = 0;
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    Source source(seed % Source::kinds, seed);
    std::mt19937_64 random(seed);
    History history(spanning(source));
    const std::size_t most = 10 + seed % 60;
    for (int step = 0; step < 100; ++step) {
      const bool grows = random() % 100 < (history.count() < most ? 70 : 35);
      if (grows) {
        history.add(source.next(), history.star(history.any(random)));
      } else {
        const bool is_done = history.remove(history.any(random));
        ++(is_done ? removed : refused);
      }
      if (step % 10 == 9 || !grows) {
        REQUIRE(history.is_closed());
        REQUIRE(history.tetrahedra() == history.fresh_tetrahedra());
      }
    }
  }
  CHECK(removed > 25 * count);
  CHECK(refused > count / 20);  // the points left would have been flat
}

void check_removals_to_the_last(unsigned count) {
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    Source source(seed % Source::kinds, seed);
    std::mt19937_64 random(seed);
    History history(spanning(source));
    for (int i = 0; i < 60; ++i) history.add(source.next(), history.star(history.any(random)));
    const std::size_t corners = history.points.size();
    for (int step = 0; step < 300 && history.count() > 4; ++step) {
      history.remove(history.any(random));
      REQUIRE(history.tetrahedra() == history.fresh_tetrahedra());
    }
    // One tetrahedron, or a flat set with one point off its plane.
    Corner last = history.any(random);
    if (history.count() == 4) CHECK_FALSE(history.remove(last));
    CHECK(history.is_closed());
    for (int i = 0; i < 60; ++i) {
      history.add(source.next(), history.star(history.any(random)));
      REQUIRE(history.tetrahedra() == history.fresh_tetrahedra());
      if (history.points.size() > corners) break;
    }
    CHECK(history.count() <= history.points.size());
  }
}

void check_moves(unsigned count) {
  std::size_t moved = 0, refused = 0;
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    Source source(seed % Source::kinds, seed);
    support::Random random(seed);
    std::mt19937_64 picks(seed);
    History history(spanning(source));
    for (unsigned i = 0; i < 10 + seed % 40; ++i) {
      history.add(source.next(), history.star(history.any(picks)));
    }
    for (int step = 0; step < 60; ++step) {
      const Corner c = history.any(picks);
      const WeightedPoint before = history.points[c];
      WeightedPoint to = before;
      const double size = std::pow(10.0, -random.between(0, 12));
      to.position += size * random.direction();
      if (random.uniform() < 0.3) to = source.next();
      if (random.uniform() < 0.1) to.position = before.position.array().round().matrix();
      to.position = to.position.unaryExpr(&on_exact_grid);
      const Tetrahedra old = history.tetrahedra();
      history.points[c] = to;
      const bool is_same = history.fresh_tetrahedra() == old;
      history.points[c] = before;
      // Two points at one place: one of them would be hidden.
      bool is_taken = false;
      for (Corner other = 0; other < history.points.size(); ++other) {
        is_taken = is_taken || (other != c && history.is_in[other] != 0 &&
                                history.points[other].position == to.position);
      }
      const bool is_done = history.move(c, to);
      REQUIRE(is_done == (is_same && !is_taken));
      ++(is_done ? moved : refused);
      REQUIRE(history.tetrahedra() == old);
      REQUIRE(history.is_closed());
    }
  }
  CHECK(moved > 8 * count);
  CHECK(refused > 8 * count);
}

}  // namespace

TEST_CASE("after insertions and removals the tetrahedra are those of the points left") {
  check_insertions_and_removals(60);
}

TEST_CASE("points can be taken out down to the last tetrahedron, and no corner is lost") {
  check_removals_to_the_last(60);
}

TEST_CASE("a move goes through exactly if it changes no tetrahedron") { check_moves(60); }

TEST_CASE("a point with a hundred or a thousand neighbours can be taken out") {
  support::Random random(1);
  Points on_sphere;
  for (int i = 0; i < 1000; ++i) on_sphere.push_back({random.direction(), 0});
  Points tied;  // whole points of one sphere
  for (const Vector& v : Source::whole_points_of_sphere()) tied.push_back({v, 0});
  REQUIRE(tied.size() > 100);
  for (Points points : {on_sphere, tied}) {
    points.push_back(at(0, 0, 0));
    History history(points);
    Corner centre = 0;
    while (history.points[centre].position != Point(0, 0, 0)) ++centre;
    CHECK(history.remove(centre));
    CHECK(history.is_closed());
    CHECK(history.tetrahedra() == history.fresh_tetrahedra());
    CHECK(history.add(at(0, 0, 0), history.star(centre == 0 ? 1 : 0)));
    CHECK(history.tetrahedra() == history.fresh_tetrahedra());
  }
}

TEST_SUITE("slow") {
  TEST_CASE("removals and moves keep the triangulation over hundreds of seeds") {
    check_insertions_and_removals(300);
    check_removals_to_the_last(240);
    check_moves(300);
  }
}

}  // namespace morskin::geometry

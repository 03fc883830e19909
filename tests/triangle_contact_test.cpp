#include "geometry/triangle_contact.h"

#include "geometry/predicates.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

/// Whole numbers, so that the oracle is exact.
using Whole = Eigen::Matrix<std::int64_t, 3, 1>;
using Wholes = std::vector<Whole>;

Whole cross(const Whole& a, const Whole& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Whether the hulls of two small sets meet: no direction parts them. For points, segments and
/// triangles a parting direction, if any, is among the edges, their products, and the products of
/// those with edges.
bool hulls_meet(const Wholes& a, const Wholes& b) {
  Wholes edges, axes;
  for (const Wholes* hull : {&a, &b}) {
    for (const Whole& p : *hull) {
      for (const Whole& q : *hull) edges.push_back(p - q);
    }
  }
  edges.push_back(a[0] - b[0]);
  for (const Whole& e : edges) {
    axes.push_back(e);
    for (const Whole& f : edges) {
      const Whole n = cross(e, f);
      axes.push_back(n);
      for (const Whole& g : edges) axes.push_back(cross(n, g));
    }
  }
  return std::ranges::none_of(axes, [&](const Whole& axis) {
    const auto along = [&](const Whole& p) { return axis.dot(p); };
    return std::ranges::max(a, {}, along).dot(axis) < std::ranges::min(b, {}, along).dot(axis);
  });
}

/// By the definition, given which corners are shared.
bool oracle(const Wholes& at, const TriangleCorners& s, const TriangleCorners& t) {
  std::vector<std::uint32_t> common, of_s, of_t;
  for (const std::uint32_t v : s) {
    (std::ranges::find(t, v) != t.end() ? common : of_s).push_back(v);
  }
  std::ranges::copy_if(t, std::back_inserter(of_t),
                       [&](std::uint32_t v) { return std::ranges::find(s, v) == s.end(); });
  const auto hull = [&](const auto& ids) {
    Wholes points;
    for (const std::uint32_t v : ids) points.push_back(at[v]);
    return points;
  };
  if (common.size() == 3) return true;
  if (common.size() == 2) {
    const Whole e = at[common[1]] - at[common[0]];
    const Whole m = cross(e, at[of_s[0]] - at[common[0]]);
    const Whole n = cross(e, at[of_t[0]] - at[common[0]]);
    return cross(m, n).isZero() && m.dot(n) > 0;
  }
  if (common.size() == 1) {
    return hulls_meet(hull(of_s), hull(t)) || hulls_meet(hull(of_t), hull(s));
  }
  return hulls_meet(hull(s), hull(t));
}

bool is_flat(const Wholes& at, const TriangleCorners& t) {
  return cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]).isZero();
}

std::vector<Point> as_points(const Wholes& at, double scale = 1) {
  std::vector<Point> result;
  for (const Whole& p : at) result.push_back(scale * p.cast<double>());
  return result;
}

constexpr TriangleCorners first{0, 1, 2};
constexpr TriangleCorners partners[] = {{3, 4, 5}, {0, 4, 5}, {4, 1, 5}, {4, 5, 2},
                                        {0, 1, 5}, {1, 5, 0}, {2, 0, 5}, {5, 2, 1}};

}  // namespace

TEST_CASE("improper contact of triangles on a small lattice is what parting directions say") {
  std::size_t met = 0, asked = 0;
  for_seeds<Random>(4000, [&](unsigned seed, Random& random) {
    const std::size_t size = 3 + seed % 5;
    const std::size_t height = seed % 3 == 0 ? 1 : size;  // often in one plane
    Wholes at;
    for (int i = 0; i < 6; ++i) {
      at.emplace_back(random.below(size), random.below(size), random.below(height));
    }
    const std::vector<Point> points = as_points(at);
    const ExactPositions positions(points);
    for (const TriangleCorners& t : partners) {
      if (is_flat(at, first) || is_flat(at, t)) continue;
      CAPTURE(&t - partners);
      const bool expected = oracle(at, first, t);
      REQUIRE(is_improper_contact(positions, first, t) == expected);
      met += expected;
      ++asked;
    }
  });
  CHECK(met > asked / 5);
  CHECK(met < asked * 4 / 5);
}

TEST_CASE("contact does not depend on the order of triangles, corners, or on the unit of length") {
  for_seeds<Random>(500, [&](Random& random) {
    Wholes at;
    for (int i = 0; i < 6; ++i) {
      at.emplace_back(random.below(5), random.below(5), random.below(5));
    }
    const std::vector<Point> points = as_points(at);
    const ExactPositions positions(points);
    for (const TriangleCorners& t : partners) {
      if (is_flat(at, first) || is_flat(at, t)) continue;
      const bool expected = is_improper_contact(positions, first, t);
      TriangleCorners s = first, turned = t;
      do {
        CHECK(is_improper_contact(positions, turned, s) == expected);
        std::ranges::next_permutation(turned);
      } while (std::ranges::next_permutation(s).found);
      for (const double scale : {0x1p-1000, 0x1p-300, 0x1p900}) {
        CAPTURE(scale);
        const std::vector<Point> scaled = as_points(at, scale);
        CHECK(is_improper_contact(ExactPositions(scaled), first, t) == expected);
      }
    }
  });
}

TEST_CASE("triangles nearer than a rounding are told apart from triangles that touch") {
  const double up = std::nextafter(1.0, 2.0), down = std::nextafter(1.0, 0.0);
  for (const double height : {down, 1.0, up}) {
    CAPTURE(height);
    // The tip of the second stands on the first, which lies in the plane z = 1.
    const std::vector<Point> points{{0, 0, 1},      {4, 0, 1}, {0, 4, 1},
                                    {1, 1, height}, {1, 2, 3}, {2, 1, 3}};
    CHECK(is_improper_contact(ExactPositions(points), first, {3, 4, 5}) == (height <= 1));
  }
}

TEST_CASE("positions out of the exact range keep their order and their collinear triples") {
  const std::vector<Point> huge{
      {1e300, 2e300, -3e300}, {2e300, 4e300, -6e300}, {4e300, 8e300, -12e300}, {4e300, 8e300, 0}};
  const ExactPositions scaled(huge);
  for (const Point& p : scaled.all()) CHECK(p.cwiseAbs().maxCoeff() <= 0x1p30);
  CHECK(scaled[0].x() < scaled[1].x());
  CHECK(scaled[2].z() < scaled[1].z());
  CHECK(geometry::are_collinear(scaled[0], scaled[1], scaled[2]));
  CHECK_FALSE(geometry::are_collinear(scaled[0], scaled[1], scaled[3]));
  const std::vector<Point> ordinary{{0.1, -2, 1e-20}, {3, 4, 5}};
  CHECK(ExactPositions(ordinary).all().data() == ordinary.data());
}

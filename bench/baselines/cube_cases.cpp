#include "bench/baselines/cube_cases.h"

namespace morskin::baselines {

namespace {

constexpr std::size_t none = 0xFF;

constexpr std::size_t bit(std::size_t axis) { return std::size_t{1} << axis % 3; }

/// The edge between two corners that differ in one coordinate.
constexpr std::size_t edge_between(std::size_t p, std::size_t q) {
  const std::size_t axis = (p ^ q) == 1 ? 0 : (p ^ q) == 2 ? 1 : 2;
  const std::size_t low = p & q;
  const std::size_t first = (low & bit(axis + 1)) != 0, second = (low & bit(axis + 2)) != 0;
  return 4 * axis + first + 2 * second;
}

/// The corners of a face, counter-clockwise seen from outside the cube.
constexpr std::array<std::size_t, 4> face_corners(std::size_t axis, bool is_upper) {
  const std::size_t u = bit(axis + 1), v = bit(axis + 2);
  if (is_upper) return {bit(axis), bit(axis) | u, bit(axis) | u | v, bit(axis) | v};
  return {0, v, u | v, u};
}

/// Whether two edges of the cube lie on a common face.
constexpr bool share_face(std::size_t e, std::size_t f) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const CubeEdge a = cube_edge(e), b = cube_edge(f);
    if (a.axis != axis && b.axis != axis && ((a.corner ^ b.corner) & bit(axis)) == 0) return true;
  }
  return false;
}

using NextEdge = std::array<std::size_t, cube_edge_count>;

/// For each crossed edge the next on its loop: round every face, from where a run of inside corners
/// is entered to where it is left. Each edge is entered by on one of its faces, left by on the
/// other.
constexpr NextEdge next_edges(std::size_t inside) {
  NextEdge next{};
  next.fill(none);
  const auto is_inside = [inside](std::size_t corner) { return (inside >> corner & 1) != 0; };
  for (std::size_t face = 0; face < 6; ++face) {
    const auto corners = face_corners(face / 2, face % 2 != 0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_inside(corners[k]) || !is_inside(corners[(k + 1) % 4])) continue;
      std::size_t last = k + 1;
      while (is_inside(corners[(last + 1) % 4])) ++last;
      next[edge_between(corners[k], corners[(k + 1) % 4])] =
          edge_between(corners[last % 4], corners[(last + 1) % 4]);
    }
  }
  return next;
}

/// A closed loop of crossed edges, to be cut into triangles.
struct Loop {
  std::array<std::size_t, cube_edge_count> edges{};
  std::size_t size = 0;

  /// Whether a cut from edge i to edge j would lie on a face.
  constexpr bool is_bad_cut(std::size_t i, std::size_t j) const {
    const bool is_side = j == i + 1 || (i == 0 && j + 1 == size);
    return !is_side && share_face(edges[i], edges[j]);
  }

  /// Adds triangles for the part from edge i to edge j, without bad cuts; false, with nothing
  /// added, where all cuts are bad.
  constexpr bool cut(std::size_t i, std::size_t j, CubeCase& result) const {
    if (j < i + 2) return true;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (is_bad_cut(i, k) || is_bad_cut(k, j)) continue;
      const std::uint8_t before = result.count;
      const auto at = [this](std::size_t e) { return static_cast<std::uint8_t>(edges[e]); };
      result.triangles[result.count++] = {at(i), at(k), at(j)};
      if (cut(i, k, result) && cut(k, j, result)) return true;
      result.count = before;
    }
    return false;
  }
};

constexpr CubeCase make_case(std::size_t inside) {
  CubeCase result;
  NextEdge next = next_edges(inside);
  for (std::size_t first = 0; first < cube_edge_count; ++first) {
    Loop loop;
    for (std::size_t e = first; next[e] != none;) {
      loop.edges[loop.size++] = e;
      const std::size_t after = next[e];
      next[e] = none;
      e = after;
    }
    if (loop.size > 0 && !loop.cut(0, loop.size - 1, result)) throw "a loop without a cut";
  }
  return result;
}

constexpr std::array<CubeCase, 256> make_cases() {
  std::array<CubeCase, 256> cases;
  for (std::size_t inside = 0; inside < cases.size(); ++inside) cases[inside] = make_case(inside);
  return cases;
}

}  // namespace

constexpr std::array<CubeCase, 256> cube_cases = make_cases();

}  // namespace morskin::baselines

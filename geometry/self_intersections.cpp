#include "geometry/self_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/box_tree.h"
#include "geometry/edge_fan.h"
#include "geometry/predicates.h"
#include "geometry/spatial_order.h"
#include "geometry/triangle_contact.h"

namespace morskin::geometry {

namespace {

/// Leaves with keys to sort them by.
class LeafOrder {
 public:
  LeafOrder(const Eigen::AlignedBox3d& box, std::size_t count)
      : low_(box.min()), extent_(box.sizes().maxCoeff()) {
    keyed_.reserve(count);
  }

  /// Adds a triangle at a point of the box. Those with the same exempt corners become neighbours,
  /// so that whole nodes of the tree share them.
  template <class IsExempt>
  void add(const Point& p, const BoxTree::Leaf& leaf, const TriangleCorners& corners,
           const IsExempt& is_exempt) {
    TriangleCorners exempt{no_index, no_index, no_index};
    std::ranges::copy_if(corners, exempt.begin(), is_exempt);
    std::ranges::sort(exempt);
    keyed_.push_back({std::uint64_t{exempt[0]} << 32 | exempt[1], along_curve(p), leaf});
  }

  std::vector<BoxTree::Leaf> leaves() {
    std::ranges::sort(keyed_, {}, [](const Keyed& k) {
      return std::tuple(k.group, k.along_curve, k.leaf.triangle);
    });
    std::vector<BoxTree::Leaf> result;
    result.reserve(keyed_.size());
    for (const Keyed& k : keyed_) result.push_back(k.leaf);
    return result;
  }

 private:
  struct Keyed {
    std::uint64_t group, along_curve;
    BoxTree::Leaf leaf;
  };

  std::uint64_t along_curve(const Point& p) const {
    constexpr int bits = 20;
    constexpr double last = (1 << bits) - 1;
    const auto cell = [&](Eigen::Index k) {
      const double share = extent_ > 0 ? (p[k] - low_[k]) / extent_ : 0;
      return static_cast<std::uint32_t>(std::clamp(share * last, 0.0, last));
    };
    return hilbert_index(cell(0), cell(1), cell(2), bits);
  }

  Point low_;
  double extent_;
  std::vector<Keyed> keyed_;
};

/// Axes along the normals of the largest triangles, so that the boxes of large parallel triangles
/// are flat, however these are tilted.
Eigen::Matrix3d frame_of(const IndexedMesh& mesh, const ExactPositions& at) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (const int k : {0, 1}) {
    constexpr double across = 0.5;  // most of the second normal along the first axis
    double largest = 0;
    Vector best = Vector::Zero();
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector doubled = (at[b] - at[a]).cross(at[c] - at[a]);
      const double area = doubled.norm();
      if (area <= largest) continue;
      if (k == 1 && std::abs(doubled.dot(axes.row(0))) > across * area) continue;
      largest = area;
      best = doubled;
    }
    if (!(largest > 0)) return Eigen::Matrix3d::Identity();
    if (k == 1) best -= best.dot(axes.row(0)) * axes.row(0).transpose();
    axes.row(k) = best.normalized();
  }
  axes.row(2) = axes.row(0).cross(axes.row(1));
  return axes;
}

/// Visits every pair of triangles that may be in contact. Boxes of triangles that share a corner
/// always meet, so a crowded corner, with many triangles, has a search of its own, among directions
/// from it; and so has a crowded edge, with its triangles by the angle about it.
///
/// A pair belongs to the least crowded corner v that both have. If both have a crowded edge at v,
/// it belongs to that with the least other end.
class Search {
 public:
  Search(const IndexedMesh& mesh, const SelfIntersectionLimits& limits)
      : mesh_(mesh), at_(mesh.positions), limits_(limits), degree_(mesh.positions.size()) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const TriangleCorners& corners = mesh.triangles[t];
      const auto& [a, b, c] = corners;
      if (repeats_a_corner(corners) || are_collinear(at_[a], at_[b], at_[c])) continue;
      solid_.push_back(t);
      for (const std::uint32_t v : corners) ++degree_[v];
    }
  }

  SelfIntersections run() {
    if (search_corners()) search_apart();
    std::sort_heap(result_.pairs.begin(), result_.pairs.end());
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t crowd = 64;  // triangles

  bool is_crowded(std::uint32_t v) const { return degree_[v] >= crowd; }

  /// Notes a contact. @return false if there are as many as shall be counted
  bool note(std::uint32_t s, std::uint32_t t) {
    if (result_.count == limits_.counted) return result_.is_complete = false;
    ++result_.count;
    // Lists the smallest pairs: a heap with the largest on top.
    std::vector<std::pair<std::uint32_t, std::uint32_t>>& smallest = result_.pairs;
    smallest.emplace_back(std::min(s, t), std::max(s, t));
    std::push_heap(smallest.begin(), smallest.end());
    if (smallest.size() > limits_.listed) {
      std::pop_heap(smallest.begin(), smallest.end());
      smallest.pop_back();
    }
    return true;
  }

  bool note_if_improper(std::uint32_t s, std::uint32_t t) {
    return !is_improper_contact(at_, mesh_.triangles[s], mesh_.triangles[t]) || note(s, t);
  }

  template <class IsExempt>
  bool search(LeafOrder order, const IsExempt& is_exempt) {
    return BoxTree(order.leaves(), mesh_.triangles)
        .for_each_pair(is_exempt,
                       [this](std::uint32_t s, std::uint32_t t) { return note_if_improper(s, t); });
  }

  /// Pairs without a crowded corner in common.
  void search_apart() {
    const Eigen::Matrix3d frame = frame_of(mesh_, at_);
    Eigen::AlignedBox3d box;
    for (const Point& p : at_.all()) box.extend(Point(frame * p));
    const auto is_exempt = [this](std::uint32_t v) { return is_crowded(v); };
    LeafOrder order(box, solid_.size());
    constexpr double rounding = 0x1p-49;  // of a product with the frame, over |p|_1; with a margin
    for (const std::uint32_t t : solid_) {
      BoxTree::Leaf leaf{t, {}};
      Point sum = Point::Zero();
      for (const std::uint32_t v : mesh_.triangles[t]) {
        const Point p = frame * at_[v];
        leaf.box.add(p, rounding * at_[v].lpNorm<1>());
        sum += p;
      }
      order.add(sum / 3, leaf, mesh_.triangles[t], is_exempt);
    }
    search(std::move(order), is_exempt);
  }

  /// Pairs with a crowded corner in common.
  bool search_corners() {
    if (std::ranges::none_of(degree_, [](std::uint32_t n) { return n >= crowd; })) return true;
    std::vector<std::vector<std::uint32_t>> stars(degree_.size());
    for (const std::uint32_t t : solid_) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (is_crowded(v)) stars[v].push_back(t);
      }
    }
    shared_.assign(degree_.size(), 0);
    for (std::uint32_t v = 0; v < stars.size(); ++v) {
      if (is_crowded(v) && !search_star(v, stars[v])) return false;
    }
    return true;
  }

  bool search_star(std::uint32_t v, const std::vector<std::uint32_t>& star) {
    const auto for_each_other = [&](auto visit) {
      for (const std::uint32_t t : star) {
        for (const std::uint32_t w : mesh_.triangles[t]) {
          if (w != v) visit(w);
        }
      }
    };
    std::vector<std::uint32_t> edges;  // crowded ones, by their other ends
    for_each_other([&](std::uint32_t w) {
      if (++shared_[w] == crowd && w > v) edges.push_back(w);
    });
    std::ranges::sort(edges);
    bool goes_on = true;
    for (std::size_t i = 0; i < edges.size() && goes_on; ++i)
      goes_on = search_fan(v, edges[i], star);
    goes_on = goes_on && search_directions(v, star);
    for_each_other([&](std::uint32_t w) { shared_[w] = 0; });
    return goes_on;
  }

  /// Pairs that share v and no crowded edge: their directions from v are arcs on a sphere.
  bool search_directions(std::uint32_t v, const std::vector<std::uint32_t>& star) {
    const auto is_exempt = [&](std::uint32_t w) {
      return w != v && (shared_[w] >= crowd || (w < v && is_crowded(w)));
    };
    LeafOrder order(Eigen::AlignedBox3d(Point(-1, -1, -1), Point(1, 1, 1)), star.size());
    for (const std::uint32_t t : star) {
      std::vector<Vector> ends;
      for (const std::uint32_t w : mesh_.triangles[t]) {
        if (w != v) ends.push_back((at_[w] - at_[v]).stableNormalized());
      }
      // No point of the arc is farther from its chord.
      const Vector middle = (ends[0] + ends[1]) / 2;
      constexpr double rounding = 1e-12;
      const double margin = std::max(0.0, 1 - middle.norm()) + rounding;
      BoxTree::Leaf leaf{t, {}};
      for (const Vector& end : ends) leaf.box.add(end, margin);
      order.add(middle, leaf, mesh_.triangles[t], is_exempt);
    }
    return search(std::move(order), is_exempt);
  }

  /// Pairs that share the edge vw: improper if they lie in one half-plane.
  bool search_fan(std::uint32_t v, std::uint32_t w, const std::vector<std::uint32_t>& star);

  const IndexedMesh& mesh_;
  const ExactPositions at_;
  const SelfIntersectionLimits limits_;
  SelfIntersections result_;
  std::vector<std::uint32_t> solid_;   ///< triangles that are not degenerate
  std::vector<std::uint32_t> degree_;  ///< by vertex, how many of them have it
  std::vector<std::uint32_t> shared_;  ///< by vertex, how many of the star at work; else 0
};

bool Search::search_fan(std::uint32_t v, std::uint32_t w, const std::vector<std::uint32_t>& star) {
  EdgeFan fan(at_, v, w);
  for (const std::uint32_t t : star) {
    const auto& [a, b, c] = mesh_.triangles[t];
    if (a == w || b == w || c == w) fan.add(t, a ^ b ^ c ^ v ^ w);
  }
  // Copies of a triangle belong to the least of its edges.
  const auto is_exempt = [&](std::uint32_t apex) {
    return (apex < v && is_crowded(apex)) || (apex < w && shared_[apex] >= crowd);
  };
  const std::vector<EdgeFan::Blade>& blades = fan.sorted();
  for (std::size_t i = 0; i < blades.size(); ++i) {
    for (std::size_t j = i + 1; j < blades.size() && fan.are_alike(blades[i], blades[j]); ++j) {
      if (blades[i].apex == blades[j].apex && is_exempt(blades[i].apex)) continue;
      if (!note(blades[i].triangle, blades[j].triangle)) return false;
    }
  }
  return true;
}

}  // namespace

SelfIntersections self_intersections(const IndexedMesh& mesh,
                                     const SelfIntersectionLimits& limits) {
  return Search(mesh, limits).run();
}

}  // namespace morskin::geometry

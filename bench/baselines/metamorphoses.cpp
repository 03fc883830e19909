#include "bench/baselines/metamorphoses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace morskin::baselines {

namespace {

using geometry::CellId;
using skin::Patch;
using skin::Point;
using skin::SkinSurface;
using skin::Vector;
using skin::Wall;

/// The ball of this many h about the orthocentre must lie in the cell: the hot sphere, at most 1.15
/// of its radius; the triangles that leave it; and 0.1 h by which the jump moves them. Spheres of
/// radius h stay inside at 2 h.
double clearance_over_half_width(Kind kind, double longest_edge) {
  return kind == Kind::Birth || kind == Kind::Void ? 2
                                                   : 1.15 * (1 + longest_edge) * hot_radius + 0.1;
}

class Finder {
 public:
  Finder(const SkinSurface& skin, double end, double longest_edge)
      : skin_(skin),
        end_(end),
        longest_edge_(longest_edge),
        min_half_width_(min_half_width(skin)),
        clearance_(skin.complex().size()),
        is_taken_(skin.complex().size(), 0) {
    for (std::size_t c = 0; c < clearance_.size(); ++c) clearance_[c] = clearance(CellId{c});
  }

  std::vector<Metamorphosis> run() {
    for (std::size_t c = 0; c < clearance_.size(); ++c) {
      if (is_near_wall(CellId{c}) && is_taken_[c] == 0) add_cluster(CellId{c});
    }
    for (std::size_t c = 0; c < clearance_.size(); ++c) {
      if (clearance_[c] > 5 * min_half_width_ && is_taken_[c] == 0)
        add(CellId{c}, clearance_[c], {CellId{c}});
    }
    std::sort(found_.begin(), found_.end(), [](const Metamorphosis& a, const Metamorphosis& b) {
      return std::tie(a.time, a.cell) < std::tie(b.time, b.cell);
    });
    return std::move(found_);
  }

 private:
  /// How far inside its own cell an orthocentre lies; negative outside.
  double clearance(CellId cell) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : skin_.complex().walls(cell)) {
      nearest = std::min(nearest, wall.offset - wall.normal.dot(skin_.patch(cell).centre));
    }
    return nearest;
  }
  bool is_near_wall(CellId cell) const {
    return std::abs(clearance_[cell.index()]) <= 5 * min_half_width_;
  }

  void add(CellId cell, double clearance, const std::vector<CellId>& cells) {
    Metamorphosis m;
    m.cell = cell;
    m.cells = cells;
    m.time = -2 * skin_.patch(cell).half_weight;
    m.kind = static_cast<Kind>(skin_.complex().dimension(cell));
    if (m.time >= end_) return;
    // After the jump most of the time is still to come; and a single ball has no wall at all.
    m.half_width = std::min(clearance / clearance_over_half_width(m.kind, longest_edge_),
                            std::sqrt((end_ - m.time) / 16));
    found_.push_back(m);
  }

  /// The cells whose orthocentres are this cell's but for rounding: one quadric of them may hold in
  /// a whole ball.
  void add_cluster(CellId first) {
    std::vector<CellId> members{first};
    is_taken_[first.index()] = 1;
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (const Wall& wall : skin_.complex().walls(members[i])) {
        const double apart =
            (skin_.patch(wall.beyond).centre - skin_.patch(members[i]).centre).norm();
        if (apart > 20 * min_half_width_ || is_taken_[wall.beyond.index()] != 0) continue;
        is_taken_[wall.beyond.index()] = 1;
        members.push_back(wall.beyond);
      }
    }
    std::sort(members.begin(), members.end());
    double extent = 0;
    for (const CellId cell : members) {
      for (const Wall& wall : skin_.complex().walls(cell)) {
        extent = std::max(extent, wall.offset - wall.normal.dot(skin_.patch(cell).centre));
      }
    }
    if (!std::isfinite(extent)) extent = 1;
    for (double radius = extent; radius > 5 * min_half_width_; radius *= 0.75) {
      for (const CellId cell : members) {
        if (!holds_in_ball(cell, radius)) continue;
        add(cell, radius, members);
        return;
      }
    }
  }

  /// Whether the cell's quadric describes the skin in a ball about its orthocentre, as far as 300
  /// samples of the gradient tell, which is 1-Lipschitz.
  bool holds_in_ball(CellId cell, double radius) const {
    constexpr int directions = 100;
    const Patch& patch = skin_.patch(cell);
    for (int i = 0; i < directions; ++i) {
      const double z = 1 - (2 * i + 1.0) / directions, azimuth = 2.399963229728653 * i;
      const double r = std::sqrt(1 - z * z);
      const Vector d(r * std::cos(azimuth), r * std::sin(azimuth), z);
      CellId here = cell;
      for (const double share : {0.25, 0.5, 1.0}) {
        const Point x = patch.centre + share * radius * d;
        here = skin_.locate(x, here);
        const Vector difference = skin_.patch(here).half_gradient(x) - patch.half_gradient(x);
        if (difference.norm() > 0.01 * share * radius) return false;
      }
    }
    return true;
  }

  const SkinSurface& skin_;
  const double end_;
  const double longest_edge_;
  const double min_half_width_;
  std::vector<double> clearance_;
  std::vector<char> is_taken_;
  std::vector<Metamorphosis> found_;
};

}  // namespace

double min_half_width(const SkinSurface& skin) {
  double largest = 0;
  for (const auto& p : skin.points()) largest = std::max(largest, std::abs(p.weight));
  return std::ldexp(std::sqrt(largest), -21);
}

std::vector<Metamorphosis> find_metamorphoses(const SkinSurface& skin, double end,
                                              double longest_edge) {
  return Finder(skin, end, longest_edge).run();
}

}  // namespace morskin::baselines

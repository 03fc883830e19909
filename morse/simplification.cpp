#include "morse/simplification.h"

#include <optional>
#include <span>

#include "geometry/grouped.h"
#include "morse/overlaps.h"
#include "morse/quadrangles.h"

namespace morskin::morse {

namespace {

/// The path from each cancelled extremum to its heir along the lines of cancelled saddles. Each
/// such saddle is an edge between the two extrema of its old arcs; together they are trees with one
/// survivor each, so the path is unique.
class HeirPaths {
 public:
  HeirPaths(const MorseSmaleComplex& complex, const std::vector<bool>& survives,
            std::span<const Cancellation> cancelled)
      : complex_(complex), next_(complex.points.size()) {
    const std::vector<ArcId> leaving = arcs_of_cancelled(cancelled);
    const auto arriving = geometry::grouped<ArcId>(complex.points.size(), [&](auto visit) {
      for (const ArcId arc : leaving) visit(complex.arcs[arc.index()].extremum.index(), arc);
    });
    std::vector<CriticalId> reached;
    for (std::size_t i = 0; i < complex.points.size(); ++i) {
      if (survives[i] && complex.points[i].index != 1) reached.push_back(CriticalId{i});
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const CriticalId here = reached[i];
      for (const ArcId arc : arriving.of(here.index())) {
        const ArcId away = opposite(arc);
        if (next_[here.index()] == arc) continue;  // where it was reached from
        const CriticalId beyond = complex.arcs[away.index()].extremum;
        next_[beyond.index()] = away;
        reached.push_back(beyond);
      }
    }
  }

  /// Appends the line of an arc of a surviving saddle and the path on from its end.
  void append_line(ArcId arc, std::vector<Point>& points) const {
    const std::span<const Point> line = complex_.line(arc);
    points.insert(points.end(), line.begin(), line.end());
    CriticalId end = complex_.arcs[arc.index()].extremum;
    while (next_[end.index()]) {
      const ArcId to_saddle = *next_[end.index()], from_saddle = opposite(to_saddle);
      const std::span<const Point> up = complex_.line(to_saddle), down = complex_.line(from_saddle);
      points.insert(points.end(), up.rbegin() + 1, up.rend());
      points.insert(points.end(), down.begin() + 1, down.end());
      end = complex_.arcs[from_saddle.index()].extremum;
    }
  }

 private:
  /// The other arc of the same saddle to the same kind of extremum.
  static ArcId opposite(ArcId arc) { return ArcId{arc.value ^ 2U}; }

  /// For every cancelled saddle the two arcs to extrema of the kind cancelled with it.
  std::vector<ArcId> arcs_of_cancelled(std::span<const Cancellation> cancelled) const {
    std::vector<std::optional<std::uint32_t>> side(complex_.points.size());
    for (const Cancellation& c : cancelled) {
      side[c.saddle.index()] = complex_.points[c.extremum.index()].index == 0 ? 0U : 1U;
    }
    std::vector<ArcId> result;
    for (std::size_t i = 0; i < complex_.arcs.size(); i += 4) {
      if (const auto kind = side[complex_.arcs[i].saddle.index()]) {
        result.push_back(ArcId{i + *kind});
        result.push_back(ArcId{i + *kind + 2});
      }
    }
    return result;
  }

  const MorseSmaleComplex& complex_;
  std::vector<std::optional<ArcId>> next_;  ///< by extremum: the arc back to the saddle to cross
};

/// Cancels some of a complex's persistence pairs.
class Simplifier {
 public:
  Simplifier(const MorseSmaleComplex& complex, double radius_share)
      : complex_(complex), quadrangles_(complex), full_(full_radii(complex.points, radius_share)) {
    result_.overlaps_before = overlapping_spheres(complex.points, full_).size();
  }

  const std::vector<double>& radii() const { return full_; }

  /// Whether the other extremum is no younger than the one to cancel: it may be if it belongs to a
  /// pair that was not cancelled.
  bool leads_to_elder(const PersistencePair& pair) const {
    const auto heir = quadrangles_.other_end(pair.saddle, pair.extremum);
    if (!heir) return false;
    return is_lower(complex_, *heir, pair.extremum) ==
           (complex_.points[pair.extremum.index()].index == 0);
  }

  void cancel(const PersistencePair& pair) {
    const CriticalId heir = *quadrangles_.other_end(pair.saddle, pair.extremum);
    const double distance = (complex_.points[pair.saddle.index()].point.position -
                             complex_.points[pair.extremum.index()].point.position)
                                .norm();
    quadrangles_.cancel(pair.saddle, pair.extremum);
    result_.cancelled.push_back({pair.saddle, pair.extremum, heir, pair.persistence, distance});
  }

  Simplification finish() {
    const std::size_t n = complex_.points.size();
    result_.radius = full_;
    for (std::size_t i = 0; i < n; ++i) {
      result_.survives.push_back(quadrangles_.survives(CriticalId{i}));
      if (!result_.survives[i]) result_.radius[i] = 0;
    }
    const auto left = overlapping_spheres(complex_.points, result_.radius);
    result_.overlaps_left = left.size();
    result_.radius = shrunk_apart(complex_.points, result_.radius, left);
    for (std::size_t i = 0; i < n; ++i) {
      result_.shrunk += result_.survives[i] && result_.radius[i] < full_[i];
    }
    gather_complex();
    return std::move(result_);
  }

 private:
  void gather_complex() {
    result_.complex = quadrangles_.remaining();
    MorseSmaleComplex& left = result_.complex;
    if (complex_.first_point.empty()) return;  // the input has no polylines
    const HeirPaths paths(complex_, result_.survives, result_.cancelled);
    left.first_point.push_back(0);
    for (std::size_t i = 0; i < complex_.arcs.size(); ++i) {
      if (!result_.survives[complex_.arcs[i].saddle.index()]) continue;
      paths.append_line(ArcId{i}, left.line_points);
      left.first_point.push_back(static_cast<std::uint32_t>(left.line_points.size()));
    }
  }

  const MorseSmaleComplex& complex_;
  Quadrangles quadrangles_;
  std::vector<double> full_;
  Simplification result_;
};

}  // namespace

Simplification contract_short_arcs(const MorseSmaleComplex& complex, double radius_share) {
  Simplifier simplifier(complex, radius_share);
  const std::vector<double>& radii = simplifier.radii();
  const auto overlap = [&](CriticalId a, CriticalId b) {
    const double radii_sum = radii[a.index()] + radii[b.index()];
    return (complex.points[a.index()].point.position - complex.points[b.index()].point.position)
               .squaredNorm() < radii_sum * radii_sum;
  };
  // A pair that stays forbids those around it for good, so one pass in order is enough.
  std::vector<bool> holds_a_pair(complex.points.size(), false);  // the component of an extremum
  for (const PersistencePair& pair : persistence_pairs(complex)) {
    if (overlap(pair.saddle, pair.extremum) && !holds_a_pair[pair.extremum.index()] &&
        simplifier.leads_to_elder(pair)) {
      simplifier.cancel(pair);
    } else {
      holds_a_pair[pair.elder.index()] = true;
    }
  }
  return simplifier.finish();
}

Simplification cancel_up_to(const MorseSmaleComplex& complex, double persistence,
                            double radius_share) {
  Simplifier simplifier(complex, radius_share);
  for (const PersistencePair& pair : persistence_pairs(complex)) {
    if (pair.persistence > persistence) break;
    simplifier.cancel(pair);
  }
  return simplifier.finish();
}

Simplification keep_all(const MorseSmaleComplex& complex, double radius_share) {
  return Simplifier(complex, radius_share).finish();
}

}  // namespace morskin::morse

#include "refine/delaunay_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/predicates.h"
#include "refine/circumcentre.h"

namespace morskin::refine {

namespace {

using geometry::Triangulator;
using geometry::WeightedPoint;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Buckets of work, one to an octave of the circumradius over the largest that [U] allows.
constexpr std::size_t buckets = 8;

WeightedPoint unweighted(const Point& p) { return {p, 0}; }

}  // namespace

DelaunayRefinement::DelaunayRefinement(const surface::Surface& surface, const Sizing& sizing,
                                       std::span<const SurfacePoint> seeds, double min_angle_deg)
    : surface_(surface),
      sizing_(sizing),
      min_squared_sine_(std::pow(std::sin(min_angle_deg * M_PI / 180), 2)),
      body_(surface.bounding_ball()),
      delaunay_([&] {
        std::vector<WeightedPoint> points;
        for (const SurfacePoint& p : seeds) points.push_back(unweighted(p.position));
        return points;
      }()),
      work_(buckets) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    samples_.push_back(seeds[delaunay_.atom(static_cast<Corner>(i))->index()]);
  }
  counts_.seeds = seeds.size();
}

void DelaunayRefinement::run(const geometry::Run& run) {
  if (delaunay_.dimension() < 3) return;  // no tetrahedra of samples only, no facets
  ++now_;
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < delaunay_.tetrahedra().size(); ++t) {
    if (delaunay_.is_live(t)) all.push_back(t);
  }
  duals_.resize(delaunay_.tetrahedra().size());
  inspect_new(all);
  do {
    insert_all(run);
  } while (!is_endless() && (follow_dual_edges() || make_disks()));
  work_ = std::vector<std::vector<Work>>(buckets);  // all done; gives the memory back
}

/// Notes which side of the skin the circumcentre lies on and how far, in the sense of
/// is_certainly_clear(). Beyond the ball that contains the body it is outside; very far out the
/// walk there is not worth its cost.
void DelaunayRefinement::find_dual(std::uint32_t t, CellId start) {
  constexpr double far = 100;
  Dual& dual = duals_[t];
  dual = {Point::Zero(), infinity, start, now_};
  if (is_ghost(t)) return;
  const auto& corners = delaunay_.tetrahedra()[t].corners;
  dual.centre = circumcentre({&samples_[corners[0]].position, &samples_[corners[1]].position,
                              &samples_[corners[2]].position, &samples_[corners[3]].position});
  dual.root = 0;
  if (!((dual.centre - body_.centre).squaredNorm() < far * far * body_.radius * body_.radius))
    return;
  dual.cell = surface_.locate(dual.centre, start);
  const double g = surface_.jet(dual.centre, dual.cell).value;
  dual.root = std::copysign(std::sqrt(std::abs(g)), g);
}

/// A cell near the circumcentre of a new tetrahedron: a neighbour's that is known, else a corner's.
geometry::CellId DelaunayRefinement::near_dual(std::uint32_t t) const {
  const Triangulator::Tetrahedron& tetrahedron = delaunay_.tetrahedra()[t];
  for (const Facet f : tetrahedron.neighbours) {
    const Dual& neighbour = duals_[Triangulator::tetrahedron_of(f)];
    if (neighbour.born != 0 && neighbour.root < infinity) return neighbour.cell;
  }
  return samples_[tetrahedron.corners[0]].cell;
}

void DelaunayRefinement::inspect_new(std::span<const std::uint32_t> tetrahedra) {
  counts_.tetrahedra += tetrahedra.size();
  for (const std::uint32_t t : tetrahedra) find_dual(t, near_dual(t));
  for (const std::uint32_t t : tetrahedra) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t other = Triangulator::tetrahedron_of(behind(t << 2 | k));
      if (duals_[other].born == now_ && other < t) continue;  // seen from there
      push(t << 2 | k);
    }
  }
}

/// Queues a facet if it is restricted. Most facets go as their surroundings are refined: so nothing
/// more than the circumradius is computed before they are looked at.
void DelaunayRefinement::push(Facet f) {
  const Facet g = behind(f);
  const bool is_inner = is_inside(Triangulator::tetrahedron_of(f));
  if (is_inner == is_inside(Triangulator::tetrahedron_of(g))) return;
  const Facet inner = is_inner ? f : g;
  const FacetGeometry facet = geometry_of(inner);
  const int octave = std::ilogb(facet.circle.radius / facet.largest);
  constexpr int last = static_cast<int>(buckets) - 1;
  std::vector<Work>& work = work_[static_cast<std::size_t>(std::clamp(octave, -1, last - 1) + 1)];
  if (work.size() == work.capacity()) {
    std::erase_if(work, [this](const Work& w) { return !stands(w); });
    if (work.size() > work.capacity() / 2) work.reserve(2 * work.capacity());
  }
  work.push_back(work_on(inner));
}

DelaunayRefinement::Work DelaunayRefinement::work_on(Facet facet) const {
  return {facet, duals_[Triangulator::tetrahedron_of(facet)].born,
          duals_[Triangulator::tetrahedron_of(behind(facet))].born};
}

/// Whether the facet is still there: both its tetrahedra live.
bool DelaunayRefinement::stands(const Work& work) const {
  const std::uint32_t inner = Triangulator::tetrahedron_of(work.facet);
  if (!delaunay_.is_live(inner) || duals_[inner].born != work.born) return false;
  return duals_[Triangulator::tetrahedron_of(behind(work.facet))].born == work.born_behind;
}

/// Makes a surface ball's centre a sample point.
/// @return false where there is a sample already, the centre is not found on the skin, or the ball
///         keeps off and [L] forbids it
bool DelaunayRefinement::insert(const Ball& ball, Facet facet) {
  std::optional<SurfacePoint> x = surface_.project(ball.centre, ball.cell);
  if (!x) return false;
  if (ball.keeps_off) {
    for (const std::uint32_t corner : triangle(facet)) {
      if (sizing_.is_too_short(samples_[corner], *x)) return false;
    }
  }
  x->position = x->position.unaryExpr(&geometry::on_exact_grid);
  // The centre lies in the circumball of the tetrahedron on whose side of the facet it is.
  std::array<std::uint32_t, 2> hints{Triangulator::tetrahedron_of(facet),
                                     Triangulator::tetrahedron_of(behind(facet))};
  if (ball.height > 0) std::swap(hints[0], hints[1]);
  if (!delaunay_.add(unweighted(x->position), hints)) return false;
  samples_.push_back(*x);
  counts_.misplaced += is_misplaced(ball);
  ++now_;
  duals_.resize(delaunay_.tetrahedra().size());
  inspect_new(delaunay_.added());
  return true;
}

/// The well placed samples come to an end, those that are not may beget others for ever. Some are
/// harmless.
bool DelaunayRefinement::is_endless() const {
  constexpr std::size_t harmless = 64, largest_share = 16;
  return counts_.misplaced > harmless + samples_.size() / largest_share;
}

/// Whether the last sample is nearer to another than a surface ball's centre can be: the ball is
/// empty, so that is its radius. Rounding has the better of it then, as where a neck is so narrow
/// that it leaves the sign of G at the circumcentres to chance.
bool DelaunayRefinement::is_misplaced(const Ball& ball) const {
  constexpr double clearly_nearer = 0.5;
  const auto newest = static_cast<Corner>(samples_.size() - 1);
  const Point& x = samples_[newest].position;
  const double least = clearly_nearer * clearly_nearer * ball.radius * ball.radius;
  return std::ranges::any_of(delaunay_.added(), [&](std::uint32_t t) {
    return !is_ghost(t) && std::ranges::any_of(delaunay_.tetrahedra()[t].corners, [&](Corner c) {
      return c != newest && (samples_[c].position - x).squaredNorm() < least;
    });
  });
}

/// @return whether the facet stood and is broken
bool DelaunayRefinement::break_facet(const Work& work, const Ball& ball) {
  if (!stands(work)) return false;
  if (!insert(ball, work.facet)) {
    ++counts_.refused;
    return false;
  }
  ++(ball.ratio < 1 && !ball.keeps_off ? counts_.thin : counts_.too_big);
  return true;
}

/// Looks at the facets that wait, the biggest first, and breaks those that must not stay.
void DelaunayRefinement::insert_all(const geometry::Run& run) {
  for (std::size_t bucket = buckets; bucket-- > 0;) {
    while (!work_[bucket].empty() && !is_endless()) {
      const Work work = work_[bucket].back();
      work_[bucket].pop_back();
      if (!stands(work)) continue;
      const std::optional<Ball> ball = ball_to_break(work.facet);
      if (!ball || !break_facet(work, *ball)) continue;
      constexpr std::size_t samples_between_reports = 4096;
      if (samples_.size() % samples_between_reports == 0) {
        run.report(geometry::unknown_share, std::to_string(samples_.size()) + " samples");
      }
      bucket = buckets;
      break;
    }
  }
}

}  // namespace morskin::refine

#include "front/subdomains.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>

#include "front/sweep_plan.h"
#include "front/sweep_progress.h"
#include "geometry/parallel.h"

namespace morskin::front {

namespace {

/// About how many triangles a surface is swept with: a few per cent more than equilateral ones with
/// edges of a disk's radius.
double expected_triangles(const surface::Samples& samples, const TangentDisk& disk) {
  constexpr double measured = 1.08;
  double triangles = 0;
  for (const SurfacePoint& x : samples.points) {
    const double edge = disk.radius(x.length_scale) / x.length_scale;
    triangles += measured * samples.each / (std::sqrt(3.0) / 4 * edge * edge);
  }
  return triangles;
}

std::vector<Point> positions(const surface::Samples& samples) {
  std::vector<Point> result;
  for (const SurfacePoint& x : samples.points) result.push_back(x.position);
  return result;
}

/// Sweeps the boxes of a dissection from the leaves up.
class Sweeps {
 public:
  /// @param triangles  so many are expected in all
  Sweeps(const surface::Surface& surface, const morse::Guide& guide, const SweepOptions& options,
         const Dissection& dissection, double triangles, LaidTriangles& laid)
      : surface_(surface),
        guide_(guide),
        options_(options),
        dissection_(dissection),
        disk_(surface, options.sizing, options.spacing),
        vertices_of_leaf_(triangles / 2 / static_cast<double>(dissection.leaf_count())),
        sweeps_(dissection.size()),
        progress_(dissection.size(), geometry::Apart<ProgressObserver>(laid)),
        is_half_done_(dissection.size()) {}

  SweepResult run(const std::vector<SweepPart>& parts,
                  const std::optional<CoarseningOptions>& coarsening, unsigned threads) {
    geometry::for_each_task(threads, dissection_.leaf_count(), [&](std::size_t leaf) {
      std::size_t k = dissection_.first_leaf() + leaf;
      sweep(k, parts[k], coarsening);
      // Whoever is the second to be done with a half of a box goes on with the box.
      while (k > 0 && is_half_done_[Dissection::parent(k)].exchange(true)) {
        k = Dissection::parent(k);
        sweep(k, parts[k], coarsening);
      }
    });
    SweepResult result = sweeps_[0]->take_result();
    result.subdomains = dissection_.leaf_count();
    result.seam_triangles = seam_triangles_;
    return result;
  }

 private:
  /// @pre the halves of box k have been swept
  void sweep(std::size_t k, const SweepPart& part,
             const std::optional<CoarseningOptions>& coarsening) {
    const geometry::Traced traced(geometry::TaskTrace::Kind::Box, {}, k);
    if (dissection_.is_leaf(k)) {
      sweeps_[k] = std::make_unique<PartialSweep>(surface_, guide_, options_, coarsening,
                                                  std::vector<SweepObserver*>{&progress_[k]});
      // How many triangles coarsening leaves is not known beforehand.
      if (!coarsening) sweeps_[k]->reserve(room(k));
    } else {
      unite_halves(k);
    }
    const std::size_t before = sweeps_[k]->triangles_laid();
    sweeps_[k]->run(part.region, bowls_of(part, guide_.function, disk_));
    if (!dissection_.is_leaf(k)) seam_triangles_ += sweeps_[k]->triangles_laid() - before;
  }
  /// As many vertices as the largest box is to have whose lowest leaf this is: its mesh takes in
  /// those of the others, and need not move.
  std::size_t room(std::size_t leaf) const {
    constexpr double spare = 1.125;  // refinement adds one to every fourteen
    constexpr double most = static_cast<double>(geometry::SurfaceMesh::max_triangles) / 2;
    double vertices = spare * vertices_of_leaf_;
    for (std::size_t k = leaf; k > 0 && Dissection::is_lower_half(k); k = Dissection::parent(k)) {
      vertices *= 2;
    }
    return static_cast<std::size_t>(std::min(vertices, most));
  }
  void unite_halves(std::size_t k) {
    std::unique_ptr<PartialSweep> other = std::move(sweeps_[Dissection::upper_half(k)]);
    sweeps_[k] = std::move(sweeps_[Dissection::lower_half(k)]);
    sweeps_[k]->absorb(*other);
  }

  const surface::Surface& surface_;
  const morse::Guide& guide_;
  const SweepOptions& options_;
  const Dissection& dissection_;
  const TangentDisk disk_;
  const double vertices_of_leaf_;
  std::vector<std::unique_ptr<PartialSweep>> sweeps_;
  std::vector<geometry::Apart<ProgressObserver>> progress_;
  std::vector<std::atomic<bool>> is_half_done_;
  std::atomic<std::size_t> seam_triangles_ = 0;
};

}  // namespace

SweepResult sweep_once(const surface::Surface& surface, const morse::Guide& guide,
                       const SweepOptions& options,
                       const std::optional<CoarseningOptions>& coarsening,
                       const std::vector<SweepObserver*>& observers, const geometry::Run& run) {
  const TangentDisk disk(surface, options.sizing, options.spacing);
  LaidTriangles laid(run.is_watched() ? expected_triangles(surface.samples(), disk) : 0, run);
  ProgressObserver progress(laid);
  std::vector<SweepObserver*> all{&progress};
  all.insert(all.end(), observers.begin(), observers.end());
  PartialSweep sweep(surface, guide, options, coarsening, all);
  sweep.run({}, minima_of(guide));
  return sweep.take_result();
}

std::size_t usual_subdomains(double triangles) {
  // Small enough for eight of a small mesh, but no smaller than their seams are worth
  // (papers/4.1-algorithm.md).
  constexpr double least = 2500, usual = 40'000, enough = 8;
  const double count = std::max(std::min(triangles / least, enough), triangles / usual);
  constexpr double most = max_subdomains;
  return std::bit_floor(static_cast<std::size_t>(std::clamp(count, 1.0, most)));
}

SweepResult sweep_subdomains(const surface::Surface& surface, const morse::Guide& guide,
                             const SweepOptions& options,
                             const std::optional<CoarseningOptions>& coarsening,
                             const geometry::Run& run, std::optional<std::size_t> subdomains) {
  const TangentDisk disk(surface, options.sizing, options.spacing);
  const surface::Samples samples = surface.samples();
  const double expected = expected_triangles(samples, disk);
  const std::size_t count = subdomains.value_or(usual_subdomains(expected));
  const Dissection dissection(positions(samples), static_cast<int>(std::bit_width(count)) - 1);
  LaidTriangles laid(expected, run);
  return Sweeps(surface, guide, options, dissection, expected, laid)
      .run(sweep_plan(dissection, guide, samples, disk), coarsening, run.threads());
}

}  // namespace morskin::front

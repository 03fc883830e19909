#include "refine/smoothing.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/sort_unique.h"
#include "refine/vertex_mover.h"

namespace morskin::refine {

namespace {

/// How often the triangles that are left are tried. After each round only those next to a moved
/// vertex are tried again, so later rounds are short.
constexpr int max_rounds = 8;

class Smoothing {
 public:
  Smoothing(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
            const AngleGoal& goal, std::size_t least_to_each, const geometry::Run& run)
      : surface_(surface),
        sizing_(sizing),
        mesh_(mesh),
        goal_(goal),
        boxes_(std::bit_floor(std::clamp<std::size_t>(
            mesh.surface.triangle_count() / std::max<std::size_t>(least_to_each, 1), 1,
            max_boxes))),
        run_(run) {}

  SmoothingCounts run() {
    SmoothingCounts counts;
    std::vector<TriangleId> waiting = find_all();
    counts.below = waiting.size();
    if (boxes_ > 1 && !waiting.empty()) {
      parts_ = geometry::parts_by_boxes(
          mesh_.surface, boxes_, [this](VertexId v) -> const Point& { return mesh_.position(v); },
          run_.threads());
    }
    std::vector<TriangleId> seen = waiting;
    for (int round = 0; round < max_rounds && !waiting.empty(); ++round) {
      Work work = improve_all(waiting);
      counts.moved += work.moved;
      std::vector<TriangleId>& next = work.changed;
      keep_those_that_miss(next);
      seen.insert(seen.end(), next.begin(), next.end());
      waiting = std::move(next);
    }
    keep_those_that_miss(seen);
    counts.left = std::move(seen);
    return counts;
  }

 private:
  static constexpr std::size_t max_boxes = 64;

  bool misses_goal(TriangleId t) const { return !goal_.is_met(mesh_, t); }

  std::vector<TriangleId> find_all() const {
    const std::size_t count = mesh_.surface.triangle_count();
    std::vector<std::vector<TriangleId>> found(geometry::block_count(count));
    geometry::for_each_block(run_.threads(), count, [&](auto begin, auto end, auto block) {
      for (std::size_t t = begin; t < end; ++t) {
        const TriangleId later{std::min(t + geometry::prefetch_ahead, end - 1)};
        for (const VertexId v : mesh_.surface.corners(later)) geometry::prefetch(&mesh_.at(v));
        if (misses_goal(TriangleId{t})) found[block].push_back(TriangleId{t});
      }
    });
    for (std::size_t k = 1; k < found.size(); ++k) {
      found[0].insert(found[0].end(), found[k].begin(), found[k].end());
    }
    return std::move(found[0]);
  }

  /// In the order of their ids, each once.
  void keep_those_that_miss(std::vector<TriangleId>& triangles) const {
    std::erase_if(triangles, [this](TriangleId t) { return !misses_goal(t); });  // most of them
    geometry::sort_unique(triangles);
  }

  /// What came of some triangles.
  struct Work {
    std::size_t moved = 0;
    std::vector<TriangleId> changed;  ///< next to a moved vertex, that miss the goal
    std::vector<TriangleId> left;     ///< with a vertex that was not theirs to move

    void add(const Work& other) {
      moved += other.moved;
      changed.insert(changed.end(), other.changed.begin(), other.changed.end());
    }
  };

  /// Improves the triangles box by box, as many boxes at once as there are threads, and afterwards
  /// those at the borders of boxes. The boxes are the same for any number of threads.
  Work improve_all(const std::vector<TriangleId>& triangles) {
    if (parts_.empty()) return improve(triangles, {});
    std::vector<std::vector<TriangleId>> of_box(boxes_);
    std::vector<TriangleId> left;
    for (const TriangleId t : triangles) {
      const geometry::Part part = geometry::part_of(mesh_.surface, parts_, t);
      (part == geometry::no_part ? left : of_box[part]).push_back(t);
    }
    std::vector<Work> found(boxes_);
    geometry::for_each_task(run_.threads(), boxes_, [&](std::size_t box) {
      found[box] = improve(of_box[box], {parts_, static_cast<geometry::Part>(box)});
    });
    Work whole;
    for (const Work& part : found) {
      whole.add(part);
      left.insert(left.end(), part.left.begin(), part.left.end());
    }
    whole.add(improve(left, {}));
    return whole;
  }

  Work improve(std::span<const TriangleId> triangles, const Subdomain& subdomain) {
    Work work;
    VertexMover mover(surface_, sizing_, mesh_, goal_, subdomain);
    for (const TriangleId t : triangles) improve(t, mover, work);
    keep_those_that_miss(work.changed);
    return work;
  }

  /// Moves the corners of t in turn until it is good enough.
  void improve(TriangleId t, VertexMover& mover, Work& work) const {
    bool is_left = false;
    for (const VertexId v : mesh_.surface.corners(t)) {
      if (!misses_goal(t)) return;
      const VertexMover::Moved moved = mover.move(v);
      is_left |= moved == VertexMover::Moved::NotMine;
      if (moved != VertexMover::Moved::Yes) continue;
      ++work.moved;
      mesh_.surface.for_each_outgoing(
          v, [&](HalfEdgeId h) { work.changed.push_back(SurfaceMesh::triangle(h)); });
    }
    if (is_left && misses_goal(t)) work.left.push_back(t);
  }

  const surface::Surface& surface_;
  const Sizing sizing_;
  Mesh& mesh_;
  const AngleGoal goal_;
  const std::size_t boxes_;
  const geometry::Run run_;
  geometry::Parts parts_;  ///< none where all is one box
};

}  // namespace

SmoothingCounts smooth(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                       const AngleGoal& goal, const geometry::Run& run, std::size_t least_to_each) {
  return Smoothing(surface, sizing, mesh, goal, least_to_each, run).run();
}

}  // namespace morskin::refine

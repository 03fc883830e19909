#include "refine/smoothing.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geometry/parallel.h"
#include "refine/vertex_mover.h"

namespace morskin::refine {

namespace {

/// How often the triangles that are left are tried. After each round only those next to a moved
/// vertex are tried again, so later rounds are short.
constexpr int max_rounds = 8;

class Smoothing {
 public:
  Smoothing(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
            const AngleGoal& goal, std::size_t min_block, const geometry::Run& run)
      : surface_(surface),
        sizing_(sizing),
        mesh_(mesh),
        goal_(goal),
        block_(std::max(min_block, mesh.surface.triangle_count() / max_blocks + 1)),
        run_(run) {}

  SmoothingCounts run() {
    SmoothingCounts counts;
    std::vector<TriangleId> waiting = find_all();
    counts.below = waiting.size();
    if (mesh_.surface.triangle_count() > block_ && !waiting.empty()) {
      parts_ = geometry::parts_by_blocks(mesh_.surface, block_);
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
    counts.left = seen.size();
    return counts;
  }

 private:
  static constexpr std::size_t max_blocks = 16;

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
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::erase_if(triangles, [this](TriangleId t) { return !misses_goal(t); });
  }

  /// What came of some triangles.
  struct Work {
    std::size_t moved = 0;
    std::vector<TriangleId> changed;  ///< next to a moved vertex
    std::vector<TriangleId> left;     ///< with a vertex that was not theirs to move

    void add(const Work& other) {
      moved += other.moved;
      changed.insert(changed.end(), other.changed.begin(), other.changed.end());
    }
  };

  /// Improves the triangles block by block, as many at once as there are threads, and afterwards
  /// those at the borders of blocks. The blocks are the same for any number of threads.
  Work improve_all(const std::vector<TriangleId>& triangles) {
    if (parts_.empty()) return improve(triangles, {});
    std::vector<Work> found((mesh_.surface.triangle_count() - 1) / block_ + 1);
    geometry::for_each_task(run_.threads(), found.size(), [&](std::size_t block) {
      const auto first_of = [&](std::size_t b) {
        return std::ranges::lower_bound(triangles, TriangleId{b * block_});
      };
      found[block] = improve({first_of(block), first_of(block + 1)},
                             {parts_, static_cast<geometry::Part>(block)});
    });
    Work whole;
    std::vector<TriangleId> left;
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
  const std::size_t block_;
  const geometry::Run run_;
  geometry::Parts parts_;  ///< none where all is one block
};

}  // namespace

SmoothingCounts smooth(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                       const AngleGoal& goal, const geometry::Run& run, std::size_t min_block) {
  return Smoothing(surface, sizing, mesh, goal, min_block, run).run();
}

}  // namespace morskin::refine

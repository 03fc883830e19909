#include "refine/angle_improvement.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "geometry/sort_unique.h"
#include "refine/local_operations.h"
#include "refine/vertex_mover.h"

namespace morskin::refine {

namespace {

/// A triangle by its corners, the smallest id first: its own id may change when changes are taken
/// back.
using Corners = std::array<VertexId, 3>;
Corners ordered(Corners corners) {
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

/// Something to try: to take a vertex out, to put one in over a triangle, or to move all vertices
/// around a triangle, so that there is room.
struct Trial {
  enum class Kind { Remove, Insert, MakeRoom } kind;
  VertexId vertex = VertexId::none();  ///< to remove
  Corners triangle{};                  ///< of the other two
};

/// The triangles that miss the goal, found by any of their corners.
class Missing {
 public:
  std::size_t size() const { return by_corner_.size() / 3; }
  bool contains(const Corners& corners) const { return by_corner_.contains({corners[0], corners}); }
  void insert(const Corners& corners) {
    for (const VertexId v : corners) by_corner_.insert({v, corners});
  }
  void erase(const Corners& corners) {
    for (const VertexId v : corners) by_corner_.erase({v, corners});
  }
  /// Those with a corner among some vertices, each once.
  std::set<Corners> at(std::span<const VertexId> vertices) const {
    std::set<Corners> found;
    for (const VertexId v : vertices) {
      for (auto it = by_corner_.lower_bound({v, Corners{}}); it != by_corner_.end(); ++it) {
        if (it->first != v) break;
        found.insert(it->second);
      }
    }
    return found;
  }
  /// In order of their corners.
  std::vector<Corners> all() const {
    std::vector<Corners> result;
    for (const auto& [v, corners] : by_corner_) {
      if (v == corners[0]) result.push_back(corners);
    }
    return result;
  }

 private:
  std::set<std::pair<VertexId, Corners>> by_corner_;
};

class AngleImprovement {
 public:
  AngleImprovement(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                   const AngleGoal& goal, std::span<const TriangleId> below, int repairs)
      : mesh_(mesh),
        goal_(goal),
        repairs_(repairs),
        operations_(surface, sizing, mesh),
        mover_(surface, sizing, mesh, goal, {}),
        strict_mover_(surface, sizing, mesh, goal.stricter(), {}),
        journal_(mesh),
        trials_left_(min_trials + mesh.surface.triangle_count() / triangles_to_a_trial) {
    operations_.record_in(journal_);
    for (const TriangleId t : below) missing_.insert(ordered(mesh.surface.corners(t)));
  }

  AngleImprovementCounts run(const geometry::Run& run) {
    AngleImprovementCounts counts{0, missing_.size()};
    if (missing_.size() > mesh_.surface.triangle_count() / hopeless + 8) return counts;
    for (int depth = 1; depth <= max_depth && missing_.size() > 0; ++depth) {
      const std::vector<Corners> all = missing_.all();
      for (std::size_t i = 0; i < all.size(); ++i) {
        run.report(static_cast<double>(i) / static_cast<double>(all.size()));
        if (missing_.contains(all[i]) && improve(all[i], depth)) {
          counts.changed += journal_.exchanged();
        }
        journal_.clear();
      }
    }
    counts.left = missing_.size();
    return counts;
  }

 private:
  /// So many changes are tried at once.
  static constexpr int max_depth = 4;
  /// So many triangles are moved into shape after each change, so often.
  static constexpr int max_rounds = 8;
  static constexpr std::size_t max_waiting = 100;
  /// With more than one triangle in so many that misses the goal it will not be reached.
  static constexpr std::size_t hopeless = 4;
  /// A budget, for goals that few meshes reach.
  static constexpr std::size_t min_trials = 20000, triangles_to_a_trial = 8;

  /// Tries one change after another at a triangle that misses the goal, with up to depth - 1 more
  /// where that leaves another.
  bool improve(const Corners& corners, int depth) {
    for (const Trial& trial : trials(corners)) {
      if (trials_left_ == 0) return false;
      --trials_left_;
      const std::size_t before = journal_.size();
      if (!carry_out(trial)) continue;
      move_around(before);
      const std::optional<std::vector<Corners>> now = missing_around();
      if (now && accept(*now)) return true;
      if (now && depth > 1 && !now->empty() && improve(now->front(), depth - 1)) return true;
      journal_.undo(before, operations_.free_slots());
    }
    return false;
  }

  /// To take out each corner and each vertex across an edge, those with few neighbours first; to
  /// break the triangle and those across its edges; last to make room.
  std::vector<Trial> trials(const Corners& corners) const {
    const SurfaceMesh& connectivity = mesh_.surface;
    std::vector<VertexId> around(corners.begin(), corners.end());
    std::vector<Trial> result;
    const TriangleId t = SurfaceMesh::triangle(*half_edge(corners));
    for (std::uint32_t k = 0; k < 3; ++k) {
      around.push_back(connectivity.apex(connectivity.twin(SurfaceMesh::half_edge(t, k))));
    }
    std::ranges::stable_sort(around, {}, [&](VertexId v) { return connectivity.degree(v); });
    for (const VertexId v : around) result.push_back({.kind = Trial::Kind::Remove, .vertex = v});
    result.push_back({.kind = Trial::Kind::Insert, .triangle = corners});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId twin = connectivity.twin(SurfaceMesh::half_edge(t, k));
      result.push_back({.kind = Trial::Kind::Insert,
                        .triangle = connectivity.corners(SurfaceMesh::triangle(twin))});
    }
    result.push_back({.kind = Trial::Kind::MakeRoom, .triangle = corners});
    return result;
  }

  bool carry_out(const Trial& trial) {
    if (trial.kind == Trial::Kind::MakeRoom) return make_room(trial.triangle);
    bool is_done = false;
    if (trial.kind == Trial::Kind::Remove) {
      is_done = operations_.remove(trial.vertex);
    } else if (const auto h = half_edge(trial.triangle)) {
      is_done = operations_.insert_ball_centre(SurfaceMesh::triangle(*h),
                                               [](const Insertion&) { return true; });
    }
    operations_.flip_where_needed();
    for (int k = 0; k < repairs_ && is_done && !operations_.work().big.empty(); ++k) {
      operations_.insert_into_big_triangles(operations_.counts().insert + 1);
      operations_.flip_where_needed();
    }
    operations_.work() = {};
    return is_done;
  }

  /// Moves the vertices within two edges of a triangle, those of good triangles too, for a stricter
  /// goal: one that misses by little may have no better place while its neighbours stay.
  bool make_room(const Corners& corners) {
    std::set<VertexId> around(corners.begin(), corners.end());
    for (int ring = 0; ring < 2; ++ring) {
      for (const VertexId v : std::vector(around.begin(), around.end())) {
        mesh_.surface.for_each_outgoing(
            v, [&](HalfEdgeId h) { around.insert(mesh_.surface.target(h)); });
      }
    }
    const std::size_t before = journal_.size();
    for (int round = 0; round < max_rounds; ++round) {
      for (const VertexId v : around) {
        const SurfacePoint from = mesh_.at(v);
        if (strict_mover_.move(v) == VertexMover::Moved::Yes) journal_.note_move(v, from);
      }
    }
    return journal_.size() > before;
  }

  /// A half-edge of the triangle with these corners, if there is one.
  std::optional<HalfEdgeId> half_edge(const Corners& corners) const {
    std::optional<HalfEdgeId> found;
    if (!mesh_.surface.outgoing(corners[0])) return found;
    mesh_.surface.for_each_outgoing(corners[0], [&](HalfEdgeId h) {
      if (mesh_.surface.target(h) == corners[1] && mesh_.surface.apex(h) == corners[2]) found = h;
    });
    return found;
  }

  template <class Visit>
  void for_each_triangle_at(VertexId v, const Visit& visit) const {
    mesh_.surface.for_each_outgoing(v, [&](HalfEdgeId h) { visit(SurfaceMesh::triangle(h)); });
  }

  /// Moves corners of triangles that changed and miss the goal, and so on.
  void move_around(std::size_t before) {
    std::vector<TriangleId> waiting;
    for (const VertexId v : journal_.touched(before)) {
      for_each_triangle_at(v, [&](TriangleId t) { waiting.push_back(t); });
    }
    for (int round = 0; round < max_rounds; ++round) {
      geometry::sort_unique(waiting);
      std::erase_if(waiting, [this](TriangleId t) { return !misses_goal(t); });
      if (waiting.empty() || waiting.size() > max_waiting) return;
      std::vector<TriangleId> next;
      for (const TriangleId t : waiting) {
        for (const VertexId v : mesh_.surface.corners(t)) {
          if (!misses_goal(t)) break;
          const SurfacePoint from = mesh_.at(v);
          if (mover_.move(v) != VertexMover::Moved::Yes) continue;
          journal_.note_move(v, from);
          for_each_triangle_at(v, [&](TriangleId changed) { next.push_back(changed); });
        }
      }
      waiting = std::move(next);
    }
  }

  /// The triangles around all that was touched that miss the goal; nothing where one breaks
  /// [L] or [U].
  std::optional<std::vector<Corners>> missing_around() {
    std::set<Corners> found;
    Work broken;
    for (const VertexId v : journal_.touched()) {
      for_each_triangle_at(v, [&](TriangleId t) {
        operations_.inspect(t, broken);
        if (misses_goal(t)) found.insert(ordered(mesh_.surface.corners(t)));
      });
    }
    if (!broken.big.empty() || !broken.too_short.empty()) return std::nullopt;
    return std::vector(found.begin(), found.end());
  }

  /// Keeps all changes if they leave fewer triangles that miss the goal.
  bool accept(const std::vector<Corners>& now) {
    const std::set<Corners> before = missing_.at(journal_.touched());
    if (now.size() >= before.size()) return false;
    for (const Corners& corners : before) missing_.erase(corners);
    for (const Corners& corners : now) missing_.insert(corners);
    return true;
  }

  bool misses_goal(TriangleId t) const { return !goal_.is_met(mesh_, t); }

  Mesh& mesh_;
  const AngleGoal goal_;
  const int repairs_;
  LocalOperations operations_;
  VertexMover mover_, strict_mover_;
  Journal journal_;
  Missing missing_;
  std::size_t trials_left_;
};

}  // namespace

AngleImprovementCounts improve_angles(const surface::Surface& surface, const Sizing& sizing,
                                      Mesh& mesh, const AngleGoal& goal,
                                      std::span<const TriangleId> below, const geometry::Run& run,
                                      int repairs) {
  const AngleImprovementCounts counts =
      AngleImprovement(surface, sizing, mesh, goal, below, repairs).run(run);
  // Trials that were taken back leave empty slots as well.
  if (!below.empty()) mesh.surface.compact(run.threads());
  return counts;
}

}  // namespace morskin::refine

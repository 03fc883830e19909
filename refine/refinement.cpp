#include "refine/refinement.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "geometry/parallel.h"

namespace morskin::refine {

Refinement::Refinement(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                       const geometry::Run& run)
    : mesh_(mesh),
      surface_(surface),
      sizing_(sizing),
      run_(run),
      operations_(surface, sizing, mesh),
      max_operations_(1000 + mesh.surface.triangle_count()) {}

void Refinement::run() {
  run_.report(0);
  inspect_all();
  operations_.flip_where_needed();
  operations_.contract_short_edges();
  insert_by_boxes();
  finish();
}

void Refinement::run_from_short_edges() {
  for (std::size_t i = 0; i < 3 * mesh_.surface.triangle_count(); ++i) {
    const HalfEdgeId h{i};
    if (mesh_.surface.twin(h) < h) continue;
    const SurfacePoint &p = mesh_.at(mesh_.surface.origin(h)),
                       &q = mesh_.at(mesh_.surface.target(h));
    if (sizing_.is_too_short(p, q)) operations_.work().too_short.push_back(h);
  }
  finish();
}

/// Flips, contracts and inserts until nothing more goes through.
void Refinement::finish() {
  operations_.report_to(run_);
  operations_.flip_where_needed();
  // An operation that was refused may go through once its surroundings have changed.
  const auto changes = [&] { return operations_.counts().contract + operations_.counts().insert; };
  std::size_t before = 0;
  do {
    before = changes();
    operations_.contract_short_edges();
    operations_.insert_into_big_triangles(max_operations_);
  } while (changes() > before && changes() < max_operations_);
  mesh_.surface.compact(run_.threads());
}

RefinementCounts Refinement::counts() const {
  RefinementCounts counts = operations_.counts();
  counts.refused = operations_.work().too_short.size() + operations_.work().big.size();
  return counts;
}

/// Inspects every triangle and edge of the mesh. Each thread takes some of the triangles.
void Refinement::inspect_all() {
  const std::size_t count = mesh_.surface.triangle_count();
  std::vector<Work> found(geometry::block_count(count));
  DelaunayFilter filter(count);
  geometry::for_each_block(run_.threads(), count, [&](auto begin, auto end, auto block) {
    for (std::size_t i = begin; i < end; ++i) {
      const TriangleId t{i}, later{std::min(i + geometry::prefetch_ahead, end - 1)};
      for (const VertexId v : mesh_.surface.corners(later)) geometry::prefetch(&mesh_.at(v));
      operations_.inspect(t, found[block]);
      const auto [a, b, c] = mesh_.surface.corners(t);
      const std::array corners{&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
      filter.note(t, corners, TriangleSides(corners), operations_.max_residual(corners));
    }
  });
  geometry::for_each_block(run_.threads(), count, [&](auto begin, auto end, auto block) {
    find_flips(3 * begin, 3 * end, filter, found[block]);
  });
  Work& work = operations_.work();
  for (const Work& part : found) work.append(part);
  std::sort(work.to_flip.begin(), work.to_flip.end());
}

/// Notes the half-edges [begin, end), and their twins, over which a vertex lies in the ball.
void Refinement::find_flips(std::size_t begin, std::size_t end, const DelaunayFilter& filter,
                            Work& found) const {
  for (std::size_t i = begin; i < end; ++i) {
    const HalfEdgeId h{i}, twin = mesh_.surface.twin(h);
    filter.prefetch(
        mesh_.surface.twin(HalfEdgeId{std::min(i + 3 * geometry::prefetch_ahead, end - 1)}));
    if (twin < h || filter.certainly_delaunay(h, twin)) continue;
    for (const HalfEdgeId side : {h, twin}) {
      const auto [a, b, c] = mesh_.surface.corners(SurfaceMesh::triangle(side));
      const VertexId beyond = mesh_.surface.apex(mesh_.surface.twin(side));
      if (operations_.ball(a, b, c).intrusion(mesh_.position(beyond)).max > 0) {
        found.to_flip.push_back(side);
      }
    }
  }
}

/// Inserts box by box, as many boxes at once as there are threads. Triangles at the borders of
/// boxes wait. The boxes are the same for any number of threads.
void Refinement::insert_by_boxes() {
  constexpr std::size_t least_to_each = 128, max_boxes = 64;
  const std::size_t boxes =
      std::bit_floor(std::min(operations_.work().big.size() / least_to_each, max_boxes));
  if (boxes < 2) return;
  geometry::Parts parts = geometry::parts_by_boxes(
      mesh_.surface, boxes, [this](VertexId v) -> const Point& { return mesh_.position(v); },
      run_.threads());
  std::vector<Work> todo(boxes);
  for (const TriangleId t : std::exchange(operations_.work().big, {})) {
    if (mesh_.surface.is_removed(t)) continue;
    const geometry::Part part = geometry::part_of(mesh_.surface, parts, t);
    (part == geometry::no_part ? operations_.work() : todo[part]).big.push_back(t);
  }

  std::vector<LocalOperations> each;
  each.reserve(boxes);
  for (geometry::Part box = 0; box < boxes; ++box) {
    // A vertex mostly breaks two triangles that were too big, and seldom leaves a new one.
    std::vector<SurfaceMesh::FreeSlots> slots = new_slots(todo[box].big.size() / 8 * 5);
    parts.resize(mesh_.surface.vertex_count(), box);
    each.emplace_back(surface_, sizing_, mesh_, std::move(todo[box]),
                      geometry::Subdomain(parts, box), std::move(slots));
  }
  each.front().report_to(run_);
  geometry::for_each_task(run_.threads(), boxes, [&](std::size_t box) {
    each[box].insert_into_big_triangles(max_operations_);
  });
  for (const LocalOperations& box : each) operations_.absorb(box);
  std::sort(operations_.free_slots().begin(), operations_.free_slots().end(),
            [](const auto& a, const auto& b) { return a.vertex > b.vertex; });
}

/// The lowest ids last, for slots are taken from the end.
std::vector<SurfaceMesh::FreeSlots> Refinement::new_slots(std::size_t count) {
  std::vector<SurfaceMesh::FreeSlots> slots(count);
  for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot) {
    *slot = mesh_.surface.add_free_slots();
  }
  return slots;
}

}  // namespace morskin::refine

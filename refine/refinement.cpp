#include "refine/refinement.h"

#include <algorithm>
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
  insert_in_two_halves();
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
      const Circumcircle circle = operations_.inspect(t, found[block]);
      const auto [a, b, c] = mesh_.surface.corners(t);
      const std::array corners{&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
      filter.note(t, corners, circle, operations_.max_residual(corners));
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

/// Inserts into both halves of the mesh at once: the triangles laid first, and those laid last.
/// Triangles on the border wait. The halves are the same for any number of threads.
void Refinement::insert_in_two_halves() {
  constexpr std::size_t worth_two_threads = 256;
  Work& work = operations_.work();
  if (work.big.size() < worth_two_threads) return;
  const std::size_t count = mesh_.surface.triangle_count(), middle = count / 2;
  std::array<Work, 2> todo;
  for (const TriangleId t : work.big) {
    // Either half may fill the slot of a removed one.
    if (!mesh_.surface.is_removed(t)) todo[t.index() >= middle].big.push_back(t);
  }
  work.big.clear();

  // A vertex mostly breaks two triangles that were too big, and seldom leaves a new one.
  const std::size_t max_big = std::max(todo[0].big.size(), todo[1].big.size());
  geometry::Parts parts = geometry::parts_by_blocks(mesh_.surface, middle);
  const std::array<SlotList, 2> slots = deal_slots(max_big / 8 * 5);
  parts.resize(mesh_.surface.vertex_count(), geometry::no_part);
  for (geometry::Part half = 0; half < 2; ++half) {
    for (const SurfaceMesh::FreeSlots& free : slots[half]) parts[free.vertex] = half;
  }
  geometry::Parts parts_of_last = parts;  // each gives up vertices as it goes

  LocalOperations first(surface_, sizing_, mesh_, std::move(todo[0]), {parts, 0}, slots[0]);
  LocalOperations last(surface_, sizing_, mesh_, std::move(todo[1]), {parts_of_last, 1}, slots[1]);
  first.report_to(run_);
  geometry::do_both(
      run_.threads(), [&] { first.insert_into_big_triangles(max_operations_); },
      [&] { last.insert_into_big_triangles(max_operations_); });
  operations_.absorb(first);
  operations_.absorb(last);
  std::sort(operations_.free_slots().begin(), operations_.free_slots().end(),
            [](const auto& a, const auto& b) { return a.vertex > b.vertex; });
}

/// Gives each half so many free slots, in turn, so that few gaps stay where they have not filled
/// theirs; by blocks, so that two threads seldom write to one cache line.
std::array<Refinement::SlotList, 2> Refinement::deal_slots(std::size_t each) {
  constexpr std::size_t block = 64;
  std::array<SlotList, 2> slots;
  while (slots[1].size() < each) {
    for (SlotList& half : slots) {
      for (std::size_t k = 0; k < block; ++k) half.push_back(mesh_.surface.add_free_slots());
    }
  }
  for (SlotList& half : slots) std::ranges::reverse(half);  // the last is filled first
  const SlotList left = std::exchange(operations_.free_slots(), {});
  slots[0].insert(slots[0].end(), left.begin(), left.end());
  return slots;
}

}  // namespace morskin::refine

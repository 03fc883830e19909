#include "refine/refinement.h"

#include <algorithm>
#include <utility>

#include "geometry/parallel.h"

namespace morskin::refine {

Refinement::Refinement(const surface::Surface& skin, const Sizing& sizing, Mesh& mesh,
                       unsigned threads)
    : mesh_(mesh),
      skin_(skin),
      sizing_(sizing),
      threads_(threads),
      operations_(skin, sizing, mesh),
      most_(1000 + mesh.surface.triangle_count()) {}

void Refinement::run(const geometry::Told& told) {
  if (told) told(0);
  look_everywhere();
  operations_.flip_where_needed();
  operations_.contract_short_edges();
  insert_in_two_halves(told);
  operations_.report_to(told);
  operations_.flip_where_needed();
  // An operation that was refused may go through once its surroundings have changed.
  const auto changes = [&] { return operations_.counts().contract + operations_.counts().insert; };
  std::size_t before = 0;
  do {
    before = changes();
    operations_.contract_short_edges();
    operations_.insert_into_big_triangles(most_);
  } while (changes() > before && changes() < most_);
  mesh_.compact(threads_);
}

RefinementCounts Refinement::counts() const {
  RefinementCounts counts = operations_.counts();
  counts.refused = operations_.work().too_short.size() + operations_.work().big.size();
  return counts;
}

/// Looks at every triangle and edge of the mesh. Each thread takes some of the triangles.
void Refinement::look_everywhere() {
  const std::size_t count = mesh_.surface.triangle_count();
  std::vector<Work> found(geometry::block_count(count));
  DelaunayFilter sure(count);
  geometry::for_each_block(threads_, count, [&](auto begin, auto end, auto block) {
    for (std::size_t i = begin; i < end; ++i) {
      const TriangleId t{i}, later{std::min(i + geometry::prefetch_ahead, end - 1)};
      for (const VertexId v : mesh_.surface.corners(later)) geometry::prefetch(&mesh_.at(v));
      const Circumcircle circle = operations_.look_at(t, found[block]);
      const auto [a, b, c] = mesh_.surface.corners(t);
      const std::array corners{&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
      sure.note(t, corners, circle, operations_.most_residual(corners));
    }
  });
  geometry::for_each_block(threads_, count, [&](auto begin, auto end, auto block) {
    look_for_flips(3 * begin, 3 * end, sure, found[block]);
  });
  Work& work = operations_.work();
  for (const Work& part : found) work.append(part);
  std::sort(work.to_flip.begin(), work.to_flip.end());
}

/// Notes the half-edges [begin, end), and their twins, over which a vertex lies in the ball.
void Refinement::look_for_flips(std::size_t begin, std::size_t end, const DelaunayFilter& sure,
                                Work& found) const {
  for (std::size_t i = begin; i < end; ++i) {
    const HalfEdgeId h{i}, twin = mesh_.surface.twin(h);
    sure.prefetch(
        mesh_.surface.twin(HalfEdgeId{std::min(i + 3 * geometry::prefetch_ahead, end - 1)}));
    if (twin < h || sure.certainly_delaunay(h, twin)) continue;
    for (const HalfEdgeId side : {h, twin}) {
      const auto [a, b, c] = mesh_.surface.corners(SurfaceMesh::triangle(side));
      const VertexId beyond = mesh_.surface.apex(mesh_.surface.twin(side));
      if (operations_.ball(a, b, c).intrusion(mesh_.position(beyond)).max > 0) {
        found.to_flip.push_back(side);
      }
    }
  }
}

/// Insertion at two places at once: among the triangles laid first, and among those laid last. What
/// lies on the border waits. The halves are the same for any number of threads.
void Refinement::insert_in_two_halves(const geometry::Told& told) {
  constexpr std::size_t worth_two_threads = 256;
  Work& work = operations_.work();
  if (work.big.size() < worth_two_threads) return;
  const std::size_t count = mesh_.surface.triangle_count(), middle = count / 2;
  std::array<Work, 2> todo;
  for (const TriangleId t : work.big) {
    // The place of a removed one may be filled by either half.
    if (!mesh_.surface.is_removed(t)) todo[t.index() >= middle].big.push_back(t);
  }
  work.big.clear();

  std::array<Territory, 2> territories;
  geometry::do_both(
      threads_, [&] { territories[0].is_foreign = touched(middle, count); },
      [&] { territories[1].is_foreign = touched(0, middle); });
  // A vertex mostly breaks two triangles that were too big, and seldom leaves a new one.
  const std::size_t most_big = std::max(todo[0].big.size(), todo[1].big.size());
  deal_rooms(most_big / 8 * 5, territories);
  for (Territory& t : territories) {
    t.is_whole = false;
    t.is_foreign.resize(mesh_.surface.vertex_count(), 0);
  }

  LocalOperations first(skin_, sizing_, mesh_, std::move(todo[0]), std::move(territories[0]));
  LocalOperations last(skin_, sizing_, mesh_, std::move(todo[1]), std::move(territories[1]));
  first.report_to(told);
  geometry::do_both(
      threads_, [&] { first.insert_into_big_triangles(most_); },
      [&] { last.insert_into_big_triangles(most_); });
  operations_.take_over(first);
  operations_.take_over(last);
  std::sort(operations_.rooms().begin(), operations_.rooms().end(),
            [](const auto& a, const auto& b) { return a.vertex > b.vertex; });
}

/// Gives each so many rooms, in turn, so that few gaps stay where they have not filled theirs; by
/// blocks, so that two threads seldom write to one cache line.
void Refinement::deal_rooms(std::size_t each, std::array<Territory, 2>& territories) {
  constexpr std::size_t block = 64;
  territories[0].rooms = std::exchange(operations_.rooms(), {});
  std::array<std::vector<SurfaceMesh::Room>, 2> fresh;
  while (fresh[1].size() < each) {
    for (auto& rooms : fresh) {
      for (std::size_t k = 0; k < block; ++k) rooms.push_back(mesh_.add_room());
    }
  }
  // The last is filled first.
  for (std::size_t k = 0; k < 2; ++k) {
    auto& rooms = territories[k].rooms;
    rooms.insert(rooms.begin(), fresh[k].rbegin(), fresh[k].rend());
  }
}

/// By vertex, whether one of the triangles [begin, end) is at it.
std::vector<char> Refinement::touched(std::size_t begin, std::size_t end) const {
  std::vector<char> is_touched(mesh_.surface.vertex_count(), 0);
  for (std::size_t t = begin; t < end; ++t) {
    if (mesh_.surface.is_removed(TriangleId{t})) continue;
    for (const VertexId v : mesh_.surface.corners(TriangleId{t})) is_touched[v.index()] = 1;
  }
  return is_touched;
}

}  // namespace morskin::refine

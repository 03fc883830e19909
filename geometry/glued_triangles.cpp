#include "geometry/glued_triangles.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "geometry/error.h"
#include "geometry/parallel.h"

namespace morskin::geometry {

GluedTriangles::GluedTriangles(std::size_t vertices, std::span<const TriangleCorners> triangles)
    : triangles_(triangles),
      twins_(3 * triangles.size(), HalfEdgeId::none()),
      outgoing_(vertices, HalfEdgeId::none()) {
  if (triangles.size() > SurfaceMesh::max_triangles) {
    fail_for_lack_of_ids(SurfaceMesh::max_triangles, "triangles");
  }
  name_outgoing();
}

void GluedTriangles::name_outgoing() {
  HalfEdgeId h;
  for (const TriangleCorners& triangle : triangles_) {
    for (const std::uint32_t v : triangle) {
      outgoing_[VertexId{v}] = h;
      ++h.value;
    }
  }
}

std::optional<GluedTriangles> GluedTriangles::by_twins(std::size_t vertices,
                                                       std::span<const TriangleCorners> triangles,
                                                       std::vector<HalfEdgeId> twins) {
  if (triangles.size() > SurfaceMesh::max_triangles || twins.size() != 3 * triangles.size()) {
    return std::nullopt;
  }
  if (std::ranges::any_of(triangles, repeats_a_corner)) return std::nullopt;
  GluedTriangles mesh;
  mesh.triangles_ = triangles;
  mesh.twins_ = std::move(twins);
  // Checked from the later of two twins, so that no edge is counted twice.
  const std::size_t count = mesh.twins_.size();
  std::size_t edges = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t later = mesh.twins_[std::min(i + 3 * prefetch_ahead, count - 1)].index();
    if (later < i) {
      prefetch(&mesh.twins_[later]);
      prefetch(&triangles[later / 3]);
    }
    const HalfEdgeId h{i}, g = mesh.twin(h);
    if (g > h) continue;
    if (mesh.twin(g) != h || mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h)) {
      return std::nullopt;
    }
    ++edges;
  }
  if (2 * edges != count) return std::nullopt;
  mesh.outgoing_.resize(vertices, HalfEdgeId::none());
  mesh.name_outgoing();
  return mesh;
}

namespace {

/// Glues each half-edge to its opposite. While a half-edge waits for its twin it stands in a list
/// at the end with the smaller id.
/// @param max_steps  from one waiting half-edge to the next, in all
/// @return whether none is left waiting; nothing if the search took more steps
std::optional<bool> glue_by_lists(GluedTriangles& mesh, std::size_t max_steps) {
  const std::size_t count = 3 * mesh.triangle_count();
  std::vector<std::uint32_t> first(mesh.vertex_count(), no_index);
  const auto next = std::make_unique_for_overwrite<std::uint32_t[]>(count);
  std::size_t waiting = 0, steps = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const VertexId a = mesh.origin(HalfEdgeId{h}), b = mesh.target(HalfEdgeId{h});
    std::uint32_t& list = first[std::min(a, b).index()];
    std::uint32_t* link = &list;
    while (*link != no_index &&
           (mesh.target(HalfEdgeId{*link}) != a || mesh.origin(HalfEdgeId{*link}) != b)) {
      link = &next[*link];
      ++steps;
    }
    if (*link == no_index) {
      next[h] = std::exchange(list, h);
      ++waiting;
    } else {
      mesh.glue(HalfEdgeId{h}, HalfEdgeId{std::exchange(*link, next[*link])});
      --waiting;
    }
    if (steps > max_steps) return std::nullopt;
  }
  return waiting == 0;
}

/// The same by sorting: O(n log n) however many triangles are about a vertex or an edge.
bool glue_by_edges(GluedTriangles& mesh) {
  std::vector<std::tuple<VertexId, VertexId, HalfEdgeId>> order;
  order.reserve(3 * mesh.triangle_count());
  for (std::uint32_t h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const VertexId a = mesh.origin(HalfEdgeId{h}), b = mesh.target(HalfEdgeId{h});
    order.emplace_back(std::min(a, b), std::max(a, b), HalfEdgeId{h});
  }
  std::ranges::sort(order);
  std::vector<HalfEdgeId> waiting;  // all of one edge run the same way
  bool is_all = true;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [low, high, h] = order[i];
    if (i > 0 && (low != std::get<0>(order[i - 1]) || high != std::get<1>(order[i - 1]))) {
      is_all = is_all && waiting.empty();
      waiting.clear();
    }
    if (waiting.empty() || mesh.origin(waiting.back()) == mesh.origin(h)) {
      waiting.push_back(h);
    } else {
      mesh.glue(h, waiting.back());
      waiting.pop_back();
    }
  }
  return is_all && waiting.empty();
}

/// Why some half-edge has no twin, in words: for the first edge that lacks one.
std::string gluing_defect(const GluedTriangles& mesh) {
  const std::size_t count = 3 * mesh.triangle_count();
  std::uint32_t lonely = 0;
  while (!mesh.is_boundary(HalfEdgeId{lonely})) ++lonely;
  const VertexId a = mesh.origin(HalfEdgeId{lonely}), b = mesh.target(HalfEdgeId{lonely});
  std::size_t same = 0, opposite = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const VertexId p = mesh.origin(HalfEdgeId{h}), q = mesh.target(HalfEdgeId{h});
    same += p == a && q == b;
    opposite += p == b && q == a;
  }
  const std::string edge = edge_in_words(a.value, b.value);
  if (same + opposite == 1) return edge + " has only one triangle";
  if (same + opposite > 2) return edge + " has more than two triangles";
  return edge + ": its triangles disagree on orientation";
}

/// A walk round a vertex: how many triangles it meets, and whether two of its edges may lead to the
/// same neighbour, by two bits of each neighbour's id; that is wrong once in hundreds of vertices.
struct Round {
  std::size_t triangles = 0;
  bool may_be_double = false;
};
Round walk_round(const GluedTriangles& mesh, VertexId v) {
  Round round;
  std::uint64_t low = 0, high = 0;
  mesh.for_each_outgoing(v, [&](HalfEdgeId h) {
    const std::uint32_t w = mesh.target(h).value;
    const std::uint64_t low_bit = std::uint64_t{1} << (w % 64);
    const std::uint64_t high_bit = std::uint64_t{1} << (w / 64 % 64);
    round.may_be_double |= ((low & low_bit) != 0) & ((high & high_bit) != 0);
    low |= low_bit;
    high |= high_bit;
    ++round.triangles;
  });
  return round;
}

bool has_double_edge(const GluedTriangles& mesh, VertexId v) {
  std::vector<VertexId> neighbours;
  mesh.for_each_outgoing(v, [&](HalfEdgeId h) { neighbours.push_back(mesh.target(h)); });
  std::sort(neighbours.begin(), neighbours.end());
  return std::adjacent_find(neighbours.begin(), neighbours.end()) != neighbours.end();
}

/// What a check of some vertices finds: the triangles round them, up to the first that has
/// none or is joined twice to a neighbour.
struct Fans {
  std::size_t triangles = 0;
  std::optional<std::size_t> first_bad;
};
Fans walk_all(const GluedTriangles& mesh, std::size_t begin, std::size_t end) {
  Fans fans;
  for (std::size_t i = begin; i < end; ++i) {
    const VertexId v{i};
    mesh.prefetch_fan(VertexId{std::min(i + prefetch_ahead, end - 1)});
    if (mesh.outgoing(v) == HalfEdgeId::none()) return {fans.triangles, i};
    const Round round = walk_round(mesh, v);
    if (round.may_be_double && has_double_edge(mesh, v)) return {fans.triangles, i};
    fans.triangles += round.triangles;
  }
  return fans;
}

}  // namespace

std::optional<std::string> fan_defect(const GluedTriangles& mesh, unsigned threads) {
  std::vector<Fans> found(block_count(mesh.vertex_count()));
  for_each_block(threads, mesh.vertex_count(), [&](auto begin, auto end, auto block) {
    found[block] = walk_all(mesh, begin, end);
  });
  std::size_t met = 0;
  std::optional<std::size_t> first_bad;
  for (const Fans& fans : found) {
    met += fans.triangles;
    if (!first_bad) first_bad = fans.first_bad;
  }
  // Each walk met one fan; all together met every corner, unless some vertex has two fans.
  if (!first_bad && met == 3 * mesh.triangle_count()) return std::nullopt;
  std::vector<std::size_t> corners(mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      ++corners[mesh.origin(SurfaceMesh::half_edge(TriangleId{t}, k)).index()];
    }
  }
  for (std::size_t v = 0;; ++v) {
    const auto is_split = [&] { return walk_round(mesh, VertexId{v}).triangles != corners[v]; };
    const char* what = corners[v] == 0  ? " belongs to no triangle"
                       : is_split()     ? " is where two sheets touch"
                       : v == first_bad ? " is joined twice to a neighbour"
                                        : nullptr;
    if (what != nullptr) return "vertex " + std::to_string(v) + what;
  }
}

OrDefect<GluedTriangles> glued_triangles(std::size_t vertices, const TriangleList& triangles) {
  OrDefect<GluedTriangles> result;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (repeats_a_corner(triangles[t])) {
      result.defect = "triangle " + std::to_string(t) + " repeats a corner";
      return result;
    }
  }
  result.mesh = GluedTriangles(vertices, triangles);
  // Lists are short but for a vertex that comes before its many neighbours, or a crowded edge.
  const std::size_t many_steps = 1000 + 12 * triangles.size();
  std::optional<bool> is_glued = glue_by_lists(result.mesh, many_steps);
  if (!is_glued) {
    result.mesh = GluedTriangles(vertices, triangles);
    is_glued = glue_by_edges(result.mesh);
  }
  if (!*is_glued) result.defect = gluing_defect(result.mesh);
  return result;
}

OrDefect<GluedTriangles> closed_triangles(std::size_t vertices, const TriangleList& triangles) {
  OrDefect<GluedTriangles> result = glued_triangles(vertices, triangles);
  if (!result.defect) result.defect = fan_defect(result.mesh);
  return result;
}

OrDefect<SurfaceMesh> closed_mesh(std::size_t vertices, const TriangleList& triangles) {
  OrDefect<GluedTriangles> found = closed_triangles(vertices, triangles);
  OrDefect<SurfaceMesh> result{SurfaceMesh(), std::move(found.defect)};
  if (found.mesh.triangle_count() > 0) result.mesh = SurfaceMesh(vertices, triangles);
  for (std::uint32_t i = 0; i < 3 * found.mesh.triangle_count(); ++i) {
    const HalfEdgeId h{i}, g = found.mesh.twin(h);
    if (g < h) result.mesh.glue(h, g);
  }
  return result;
}

}  // namespace morskin::geometry

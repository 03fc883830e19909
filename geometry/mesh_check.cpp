#include "geometry/mesh_check.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/exact_positions.h"
#include "geometry/grouped.h"
#include "geometry/id.h"
#include "geometry/mesh_shape.h"
#include "geometry/predicates.h"
#include "geometry/surface_mesh.h"
#include "geometry/union_find.h"

namespace morskin::geometry {

namespace {

/// Half-edge 3 t + k of triangle t runs from corner k to corner k + 1.
struct HalfEdge {
  std::uint32_t other;  ///< the end with the larger id
  std::uint32_t id;
};

class MeshChecker {
 public:
  explicit MeshChecker(const IndexedMesh& mesh)
      : mesh_(mesh), triangles_(mesh.triangles.size()), fans_(3 * mesh.triangles.size()) {}

  MeshCheck run() {
    if (mesh_.triangles.empty()) note(MeshDefect::NoTriangles, [] { return "no triangles"; });
    check_triangles();
    file_half_edges();
    check_edges();
    check_vertices();
    find_components();
    std::sort(result_.defects.begin(), result_.defects.end(),
              [](const auto& a, const auto& b) { return a.kind < b.kind; });
    return std::move(result_);
  }

 private:
  template <class Words>
  void note(MeshDefect kind, Words words) {
    for (DefectCount& defect : result_.defects) {
      if (defect.kind != kind) continue;
      ++defect.count;
      return;
    }
    result_.defects.push_back({kind, 1, words()});
  }

  void check_triangles();
  void file_half_edges();
  void check_edges();
  void check_edge(std::uint32_t a, std::span<HalfEdge> around);
  void check_duplicates(std::span<HalfEdge> around);
  void check_vertices();
  void find_components();

  std::uint32_t corner(std::uint32_t half_edge) const {
    return mesh_.triangles[half_edge / 3][half_edge % 3];
  }
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  std::uint32_t apex(std::uint32_t h) const { return corner(next(next(h))); }
  bool repeats_a_corner(std::size_t t) const {
    return geometry::repeats_a_corner(mesh_.triangles[t]);
  }

  const IndexedMesh& mesh_;
  MeshCheck result_;
  UnionFind triangles_;               ///< joined through edges
  UnionFind fans_;                    ///< corners, named like half-edges, joined at their vertex
  std::vector<char> is_loose_;        ///< by triangle: whether an edge has a defect
  std::vector<std::uint32_t> edges_;  ///< by triangle: edges visited first from it
  Grouped<HalfEdge> half_edges_;      ///< by the smaller end, then sorted
};

void MeshChecker::check_triangles() {
  const ExactPositions at(mesh_.positions);
  is_loose_.assign(mesh_.triangles.size(), 0);
  edges_.assign(mesh_.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto [a, b, c] = mesh_.triangles[t];
    if (repeats_a_corner(t)) {
      is_loose_[t] = 1;
      note(MeshDefect::RepeatedCorner,
           [t] { return "triangle " + std::to_string(t) + " repeats a corner"; });
    } else if (are_collinear(at[a], at[b], at[c])) {
      note(MeshDefect::Collinear,
           [t] { return "triangle " + std::to_string(t) + " has its corners on one line"; });
    }
  }
}

void MeshChecker::file_half_edges() {
  half_edges_ = grouped<HalfEdge>(mesh_.positions.size(), [&](auto visit) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (repeats_a_corner(t)) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corner(3 * t + k), b = corner(next(3 * t + k));
        visit(std::min(a, b), HalfEdge{std::max(a, b), 3 * t + k});
      }
    }
  });
}

void MeshChecker::check_edges() {
  for (std::uint32_t a = 0; a < mesh_.positions.size(); ++a) {
    const std::span<HalfEdge> at_vertex = half_edges_.of(a);
    std::ranges::sort(at_vertex, [](const HalfEdge& g, const HalfEdge& h) {
      return g.other != h.other ? g.other < h.other : g.id < h.id;
    });
    for (auto from = at_vertex.begin(); from != at_vertex.end();) {
      auto to = from + 1;
      while (to != at_vertex.end() && to->other == from->other) ++to;
      check_edge(a, {from, to});
      from = to;
    }
  }
}

void MeshChecker::check_edge(std::uint32_t a, std::span<HalfEdge> around) {
  const std::uint32_t first = around[0].id;
  const std::uint32_t b = around[0].other;
  ++edges_[first / 3];
  for (const HalfEdge& h : around.subspan(1)) {
    triangles_.join(first / 3, h.id / 3);
    // A half-edge's id names the corner at its origin; there the opposite one names its far end.
    const bool runs_alike = corner(h.id) == corner(first);
    fans_.join(first, runs_alike ? h.id : next(h.id));
    fans_.join(next(first), runs_alike ? next(h.id) : h.id);
  }
  const bool is_good = around.size() == 2 && corner(around[1].id) != corner(first);
  if (is_good) {
    check_duplicates(around);
    return;
  }
  for (const HalfEdge& h : around) is_loose_[h.id / 3] = 1;
  if (around.size() == 1) {
    note(MeshDefect::BoundaryEdge, [&] { return edge_in_words(a, b) + " has only one triangle"; });
  } else if (around.size() == 2) {
    note(MeshDefect::DisagreeingTriangles,
         [&] { return edge_in_words(a, b) + ": its triangles disagree on orientation"; });
  } else {
    note(MeshDefect::CrowdedEdge, [&] {
      return edge_in_words(a, b) + " has " + std::to_string(around.size()) + " triangles";
    });
  }
  check_duplicates(around);
}

/// Duplicates share all edges; they are counted at the edge without the largest corner.
void MeshChecker::check_duplicates(std::span<HalfEdge> around) {
  std::ranges::sort(around, {}, [&](const HalfEdge& h) { return std::pair(apex(h.id), h.id); });
  for (std::size_t i = 1; i < around.size(); ++i) {
    const std::uint32_t third = apex(around[i].id);
    if (third < around[i].other || apex(around[i - 1].id) != third) continue;
    note(MeshDefect::DuplicateTriangle, [&] {
      return "triangles " + std::to_string(around[i - 1].id / 3) + " and " +
             std::to_string(around[i].id / 3) + " have the same corners";
    });
  }
}

void MeshChecker::check_vertices() {
  std::vector<std::uint32_t> fan(mesh_.positions.size(), no_index);
  std::vector<char> is_used(mesh_.positions.size(), 0), is_split(mesh_.positions.size(), 0);
  for (std::uint32_t h = 0; h < 3 * mesh_.triangles.size(); ++h) {
    const std::uint32_t v = corner(h);
    is_used[v] = 1;
    if (repeats_a_corner(h / 3)) continue;  // in no fan
    const std::uint32_t root = fans_.root(h);
    if (fan[v] == no_index) fan[v] = root;
    is_split[v] = is_split[v] != 0 || fan[v] != root;
  }
  for (std::uint32_t v = 0; v < fan.size(); ++v) {
    if (is_used[v] == 0) {
      note(MeshDefect::UnusedVertex,
           [v] { return "vertex " + std::to_string(v) + " belongs to no triangle"; });
    } else if (is_split[v] != 0) {
      note(MeshDefect::SplitVertex,
           [v] { return "vertex " + std::to_string(v) + " is where two sheets touch"; });
    }
  }
}

void MeshChecker::find_components() {
  std::vector<std::uint32_t>& of = result_.component_of_triangle;
  of.resize(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < of.size(); ++t) {
    const std::uint32_t root = triangles_.root(t);
    if (root == t) {
      of[t] = static_cast<std::uint32_t>(result_.components.size());
      result_.components.emplace_back().first_triangle = t;
    } else {
      of[t] = of[root];
    }
    MeshComponent& component = result_.components[of[t]];
    ++component.triangles;
    component.edges += edges_[t];
    component.is_closed_and_oriented = component.is_closed_and_oriented && is_loose_[t] == 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) component.vertices += fans_.root(h) == h;
    const auto& [a, b, c] = mesh_.triangles[t];
    const TriangleShape shape =
        triangle_shape(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c],
                       mesh_.positions[mesh_.triangles[component.first_triangle][0]]);
    component.area += shape.area;
    component.volume += shape.volume;
  }
}

}  // namespace

const DefectCount* MeshCheck::find(MeshDefect kind) const {
  const auto found = std::ranges::find(defects, kind, &DefectCount::kind);
  return found == defects.end() ? nullptr : &*found;
}

MeshCheck check_mesh(const IndexedMesh& mesh) { return MeshChecker(mesh).run(); }

}  // namespace morskin::geometry

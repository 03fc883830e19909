#pragma once

/// Morse-Smale complexes made without a surface in space, from embedded graphs: minima are the
/// vertices, saddles the edges, maxima the faces.

#include "morse/morse_smale_complex.h"
#include "tests/support/test.h"

namespace morskin::support {

/// A graph embedded in closed oriented surfaces, as a rotation: edge e is the half-edges 2e and
/// 2e + 1, each leaving its vertex; `next` is the next one counter-clockwise about the vertex.
class EmbeddedGraph {
 public:
  /// A new component: an edge on a sphere, between two vertices or as a loop.
  void add_sphere(bool is_loop) {
    const auto x = static_cast<std::uint32_t>(next_.size());
    if (is_loop) {
      next_.insert(next_.end(), {x + 1, x});
    } else {
      next_.insert(next_.end(), {x, x + 1});
    }
  }

  /// A new edge between the corners after two half-edges. In one face it splits the face; in two
  /// faces it joins them, and with them two components, or it makes a handle.
  void add_edge(std::uint32_t a, std::uint32_t b) {
    const auto x = static_cast<std::uint32_t>(next_.size());
    next_.resize(next_.size() + 2);
    insert_after(a, x);
    insert_after(b, x + 1);
  }

  /// A vertex with the corners after both half-edges becomes two, with a new edge between them.
  void split_vertex(std::uint32_t a, std::uint32_t b) {
    const auto x = static_cast<std::uint32_t>(next_.size());
    const std::uint32_t after_a = next_[a], after_b = next_[b];
    next_.resize(next_.size() + 2);
    // ... a | after_a ... b | after_b ...
    next_[a] = x;
    next_[x] = after_b;
    if (a == b) {
      next_[x + 1] = x + 1;  // a new leaf
    } else {
      next_[b] = x + 1;
      next_[x + 1] = after_a;
    }
  }

  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(next_.size()); }
  std::uint32_t next(std::uint32_t half_edge) const { return next_[half_edge]; }
  /// The next half-edge of the face to the left.
  std::uint32_t along_face(std::uint32_t half_edge) const {
    std::uint32_t i = half_edge ^ 1U;
    while (next_[i] != (half_edge ^ 1U)) i = next_[i];
    return i;
  }

 private:
  void insert_after(std::uint32_t a, std::uint32_t x) {
    next_[x] = next_[a];
    next_[a] = x;
  }

  std::vector<std::uint32_t> next_;
};

/// By half-edge the number of its orbit; the number of orbits.
template <class Step>
std::pair<std::vector<std::uint32_t>, std::uint32_t> orbits(std::uint32_t n, Step step) {
  constexpr std::uint32_t none = ~0U;
  std::vector<std::uint32_t> orbit(n, none);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (orbit[i] != none) continue;
    for (std::uint32_t k = i; orbit[k] == none; k = step(k)) orbit[k] = count;
    ++count;
  }
  return {orbit, count};
}

/// A graph of `edges` edges and some components and handles, by splitting and joining at random.
inline EmbeddedGraph random_graph(Random& random, std::size_t edges) {
  EmbeddedGraph graph;
  graph.add_sphere(random.uniform() < 0.5);
  const double handles = random.uniform() < 0.5 ? 0 : 0.1, spheres = random.uniform() * 0.1;
  while (graph.half_edges() < 2 * edges) {
    const auto corner = [&] {
      return static_cast<std::uint32_t>(random.below(graph.half_edges()));
    };
    const std::uint32_t a = corner();
    const double kind = random.uniform();
    if (kind < spheres) {
      graph.add_sphere(random.uniform() < 0.5);
    } else if (kind < spheres + handles) {
      graph.add_edge(a, corner());
    } else if (random.uniform() < 0.5) {
      std::uint32_t b = a;
      for (std::size_t steps = random.below(6); steps > 0; --steps) b = graph.next(b);
      graph.split_vertex(a, b);
    } else {
      // The corner after half-edge d lies in the face to the left of d; round it by along_face.
      std::uint32_t b = a;
      for (std::size_t steps = random.below(6); steps > 0; --steps) b = graph.along_face(b);
      graph.add_edge(a, b);
    }
  }
  return graph;
}

/// The complex of a graph. Values are random but rise along every arc; on a coarse grid, so that
/// some are equal, if `steps` is not zero. Each vertex and face lies somewhere in a box of a side
/// so long that a fair share of unit spheres of radius 0.2 overlap.
inline morse::MorseSmaleComplex complex_of(const EmbeddedGraph& graph, Random& random,
                                           unsigned steps = 0) {
  using morse::CriticalId;
  const std::uint32_t n = graph.half_edges(), saddles = n / 2;
  // By hand: clang 14 lets no lambda capture structured bindings.
  const auto vertex_orbits = orbits(n, [&](auto i) { return graph.next(i); });
  const auto face_orbits = orbits(n, [&](auto i) { return graph.along_face(i); });
  const auto &vertex = vertex_orbits.first, &face = face_orbits.first;
  const std::uint32_t vertices = vertex_orbits.second, faces = face_orbits.second;
  const std::size_t count = std::size_t{vertices} + saddles + faces;

  // Ids in random order, so that kinds are mixed as they are among cells.
  std::vector<std::uint32_t> place(count);
  std::iota(place.begin(), place.end(), 0U);
  random.shuffle(place);
  const auto minimum = [&](std::uint32_t d) { return CriticalId{place[vertex[d]]}; };
  const auto saddle = [&](std::uint32_t d) { return CriticalId{place[vertices + d / 2]}; };
  const auto maximum = [&](std::uint32_t d) {
    return CriticalId{place[vertices + saddles + face[d]]};
  };

  morse::MorseSmaleComplex complex;
  complex.points.resize(count);
  const double side = 0.4 * std::cbrt(static_cast<double>(count));
  for (morse::CriticalPoint& p : complex.points) {
    p.point.position = random.in_cube(0, side);
    p.point.length_scale = random.between(0.3, 1);
  }
  const auto rise = [&] {
    const double u = random.uniform();
    return steps == 0 ? u * u + 1e-9 : 1 + std::floor(u * u * steps);
  };
  for (std::uint32_t d = 0; d < n; ++d) complex.points[minimum(d).index()].index = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) complex.points[place[v]].value = 2 * rise();
  for (std::uint32_t d = 0; d < n; d += 2) {
    morse::CriticalPoint& a = complex.points[saddle(d).index()];
    a.index = 1;
    a.value = rise() + std::max(complex.points[minimum(d).index()].value,
                                complex.points[minimum(d + 1).index()].value);
  }
  for (std::uint32_t f = 0; f < faces; ++f) {
    complex.points[place[vertices + saddles + f]].index = 2;
    complex.points[place[vertices + saddles + f]].value = -1;
  }
  for (std::uint32_t d = 0; d < n; ++d) {
    double& value = complex.points[maximum(d).index()].value;
    value = std::max(value, complex.points[saddle(d).index()].value + rise());
  }

  complex.first_point.push_back(0);
  const auto add_arc = [&](std::uint32_t d, CriticalId extremum) {
    complex.arcs.push_back({saddle(d), extremum});
    const geometry::Point from = complex.points[saddle(d).index()].point.position;
    const geometry::Point to = complex.points[extremum.index()].point.position;
    complex.line_points.insert(complex.line_points.end(), {from, (from + to) / 2, to});
    complex.first_point.push_back(static_cast<std::uint32_t>(complex.line_points.size()));
  };
  for (std::uint32_t d = 0; d < n; d += 2) {
    // Seen along d: its vertex behind, the face of its twin on the right, the other vertex ahead.
    add_arc(d, minimum(d));
    add_arc(d, maximum(d + 1));
    add_arc(d, minimum(d + 1));
    add_arc(d, maximum(d));
  }
  for (std::uint32_t d = 0; d < n; ++d) {
    complex.regions.push_back({minimum(d), saddle(d), maximum(d), saddle(graph.next(d))});
  }
  // Counter-clockwise about a face is along it.
  std::vector<std::vector<morse::ArcId>> about(count);
  const auto add_circle = [&](CriticalId extremum, std::uint32_t d, auto step, auto arc) {
    std::vector<morse::ArcId>& circle = about[extremum.index()];
    if (!circle.empty()) return;
    for (std::uint32_t k = d; circle.empty() || k != d; k = step(k)) circle.push_back(arc(k));
  };
  for (std::uint32_t d = 0; d < n; ++d) {
    add_circle(
        minimum(d), d, [&](auto k) { return graph.next(k); },
        [](auto k) { return morse::ArcId{2 * k}; });
    add_circle(
        maximum(d), d, [&](auto k) { return graph.along_face(k); },
        [](auto k) { return morse::ArcId{2 * k + (k % 2 == 0 ? 3 : 0U - 1)}; });
  }
  complex.ends = geometry::grouped<morse::ArcId>(count, [&](auto visit) {
    for (std::size_t i = 0; i < count; ++i) {
      for (const morse::ArcId arc : about[i]) visit(i, arc);
    }
  });
  std::vector<std::uint32_t> parent(n);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t d) {
    while (parent[d] != d) d = parent[d] = parent[parent[d]];
    return d;
  };
  for (std::uint32_t d = 0; d < n; ++d) {
    parent[root(d)] = root(d ^ 1U);
    parent[root(d)] = root(graph.next(d));
  }
  for (std::uint32_t d = 0; d < n; ++d) complex.components += root(d) == d;
  return complex;
}

/// The same with all values negated, minima for maxima: the arcs start one place later.
inline morse::MorseSmaleComplex upside_down(morse::MorseSmaleComplex complex) {
  for (morse::CriticalPoint& p : complex.points) {
    p.value = -p.value;
    p.index = 2 - p.index;
  }
  const morse::MorseSmaleComplex old = complex;
  complex.line_points.clear();
  for (std::size_t i = 0; i < old.arcs.size(); ++i) {
    const std::size_t from = i - i % 4 + (i + 1) % 4;
    complex.arcs[i] = old.arcs[from];
    const auto line = old.line(morse::ArcId{from});
    complex.line_points.insert(complex.line_points.end(), line.begin(), line.end());
    complex.first_point[i + 1] = static_cast<std::uint32_t>(complex.line_points.size());
  }
  for (morse::ArcId& arc : complex.ends.items)
    arc = morse::ArcId{arc.value - arc.value % 4 + (arc.value + 3) % 4};
  for (auto& region : complex.regions) {
    const auto [minimum, first, maximum, second] = region;
    region = {maximum, second, minimum, first};
  }
  return complex;
}

}  // namespace morskin::support

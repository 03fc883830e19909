#include "app/front_code.h"

#include <algorithm>
#include <optional>

#include "geometry/id.h"

namespace morskin::app {
namespace {

using geometry::no_index;
using geometry::TriangleList;

// By half-edge 3 t + k its twin; none at a border, an edge with more than two triangles, or one
// that two triangles traverse in the same direction.
std::vector<std::uint32_t> twins(const TriangleList& triangles) {
  struct HalfEdge {
    std::uint32_t low, high;  // its ends
    std::uint32_t id;
    auto operator<=>(const HalfEdge&) const = default;
  };
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(3 * triangles.size());
  for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h) {
    const auto& t = triangles[h / 3];
    const auto [low, high] = std::minmax(t[h % 3], t[(h + 1) % 3]);
    half_edges.push_back({low, high, h});
  }
  std::ranges::sort(half_edges);
  std::vector<std::uint32_t> twin(half_edges.size(), no_index);
  const auto origin = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  for (std::size_t i = 0, end = 0; i < half_edges.size(); i = end) {
    const auto [low, high, h] = half_edges[i];
    for (end = i; end < half_edges.size(); ++end) {
      if (half_edges[end].low != low || half_edges[end].high != high) break;
    }
    if (end - i != 2) continue;
    const std::uint32_t g = half_edges[i + 1].id;
    if (origin(h) == origin(g)) continue;
    twin[h] = g;
    twin[g] = h;
  }
  return twin;
}

struct Edge {
  std::uint32_t origin, target, apex;  // new numbers; apex: of the triangle on the mesh's side
  std::uint32_t half_edge;             // of that triangle
  std::uint32_t triangle;              // its new number
  std::uint32_t next, previous;
  bool is_open = true;
};

class Encoder {
 public:
  Encoder(const TriangleList& triangles, std::size_t vertex_count)
      : triangles_(triangles),
        twin_(twins(triangles)),
        number_(vertex_count, no_index),
        is_laid_(triangles.size(), false),
        leaving_(vertex_count, no_index) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      if (!geometry::repeats_a_corner(triangles[t])) continue;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (twin_[h] != no_index) twin_[twin_[h]] = no_index;
        twin_[h] = no_index;
      }
    }
  }

  FrontCode run() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_laid_[t]) continue;
      start(t);
      for (; head_ < edges_.size(); ++head_) {
        if (edges_[head_].is_open) lay_beyond(static_cast<std::uint32_t>(head_));
      }
    }
    return std::move(code_);
  }

 private:
  void put(Laid laid) { code_.cases.push_back(static_cast<std::uint8_t>(laid)); }

  std::uint32_t add_vertex(std::uint32_t old, std::array<std::uint32_t, 3> predictors) {
    number_[old] = static_cast<std::uint32_t>(code_.vertices.size());
    code_.vertices.push_back(old);
    code_.predictors.push_back(predictors);
    return number_[old];
  }

  std::uint32_t add_triangle(std::uint32_t old, std::uint32_t parent) {
    is_laid_[old] = true;
    code_.triangles.push_back(old);
    code_.parents.push_back(parent);
    return static_cast<std::uint32_t>(code_.triangles.size() - 1);
  }

  std::uint32_t add_edge(std::uint32_t origin, std::uint32_t target, std::uint32_t apex,
                         std::uint32_t half_edge, std::uint32_t triangle) {
    edges_.push_back({origin, target, apex, half_edge, triangle, 0, 0});
    const auto e = static_cast<std::uint32_t>(edges_.size() - 1);
    leaving_[code_.vertices[origin]] = e;
    return e;
  }

  void link(std::uint32_t e, std::uint32_t f) {
    edges_[e].next = f;
    edges_[f].previous = e;
  }

  void refer_to_old(std::uint32_t v) {
    put(Laid::Old);
    code_.references.push_back(static_cast<std::uint32_t>(code_.vertices.size() - 1 - v));
  }

  void start(std::uint32_t t) {
    std::array<std::uint32_t, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t old = triangles_[t][k];
      corner[k] = number_[old];
      if (corner[k] == no_index) {
        put(Laid::New);
        const auto last = static_cast<std::uint32_t>(code_.vertices.size());
        const std::uint32_t near = last == 0 ? 0 : last - 1;
        corner[k] = add_vertex(old, {near, near, near});
      } else {
        refer_to_old(corner[k]);
      }
    }
    const auto last = static_cast<std::uint32_t>(code_.triangles.size());
    const std::uint32_t n = add_triangle(t, last == 0 ? 0 : last - 1);
    std::array<std::uint32_t, 3> e;
    for (std::uint32_t k = 0; k < 3; ++k) {
      e[k] = add_edge(corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3], 3 * t + k, n);
    }
    for (std::size_t k = 0; k < 3; ++k) link(e[k], e[(k + 1) % 3]);
  }

  // The latest front edge that starts at a vertex, if it is still open.
  std::optional<std::uint32_t> open_edge_at(std::uint32_t v) const {
    const std::uint32_t e = leaving_[code_.vertices[v]];
    if (e == no_index || !edges_[e].is_open) return std::nullopt;
    return e;
  }

  void lay_beyond(std::uint32_t e) {
    const std::uint32_t into = twin_[edges_[e].half_edge];
    if (into == no_index || is_laid_[into / 3]) {
      put(Laid::Border);
      edges_[e].is_open = false;
      return;
    }
    const std::uint32_t t = into / 3;
    // Half-edges of the triangle (b, a, v): b to a is `into`, then a to v, then v to b.
    const std::uint32_t to_v = 3 * t + (into + 1) % 3, from_v = 3 * t + (into + 2) % 3;
    const std::uint32_t old = triangles_[t][from_v % 3];
    const std::uint32_t n = add_triangle(t, edges_[e].triangle);
    const std::uint32_t next = edges_[e].next, previous = edges_[e].previous;
    const std::uint32_t a = edges_[e].origin, b = edges_[e].target;
    edges_[e].is_open = false;
    const bool closes_next = edges_[next].is_open && twin_[from_v] == edges_[next].half_edge;
    const bool closes_previous =
        edges_[previous].is_open && twin_[to_v] == edges_[previous].half_edge;
    if (closes_next) edges_[next].is_open = false;
    if (closes_previous) edges_[previous].is_open = false;
    if (closes_next && closes_previous) {
      put(Laid::Both);
      link(edges_[previous].previous, edges_[next].next);
    } else if (closes_next) {
      put(Laid::Next);
      const std::uint32_t f = add_edge(a, number_[old], b, to_v, n);
      link(previous, f);
      link(f, edges_[next].next);
    } else if (closes_previous) {
      put(Laid::Previous);
      const std::uint32_t f = add_edge(number_[old], b, a, from_v, n);
      link(edges_[previous].previous, f);
      link(f, next);
    } else {
      lay_wedge(e, old, to_v, from_v, n);
    }
  }

  // A triangle that closes no edge but e.
  void lay_wedge(std::uint32_t e, std::uint32_t old, std::uint32_t to_v, std::uint32_t from_v,
                 std::uint32_t n) {
    const Edge at = edges_[e];
    std::uint32_t v = number_[old];
    std::uint32_t before = no_index, after = no_index;  // about v, where its front is entered
    if (v == no_index) {
      put(Laid::New);
      v = add_vertex(old, {at.origin, at.target, at.apex});
    } else if (const auto j = open_edge_at(v)) {
      put(Laid::Touch);
      code_.references.push_back(static_cast<std::uint32_t>(edges_.size() - 1 - *j));
      after = *j;
      before = edges_[*j].previous;
    } else {
      refer_to_old(v);
    }
    const std::uint32_t f = add_edge(at.origin, v, at.target, to_v, n);
    const std::uint32_t g = add_edge(v, at.target, at.origin, from_v, n);
    link(at.previous, f);
    link(g, at.next);
    if (after == no_index) {
      link(f, g);
    } else {
      link(f, after);
      link(before, g);
    }
  }

  const TriangleList& triangles_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> number_;   // by old vertex the new number
  std::vector<bool> is_laid_;           // by old triangle
  std::vector<std::uint32_t> leaving_;  // by old vertex, the newest front edge that starts there
  std::vector<Edge> edges_;
  std::size_t head_ = 0;
  FrontCode code_;
};

}  // namespace

FrontCode front_code(const TriangleList& triangles, std::size_t vertex_count) {
  return Encoder(triangles, vertex_count).run();
}

}  // namespace morskin::app

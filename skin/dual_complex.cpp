#include "skin/dual_complex.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "geometry/orthosphere.h"
#include "geometry/parallel.h"
#include "skin/complement.h"
#include "skin/mixed_complex_internal.h"
#include "skin/singular_skin.h"

namespace morskin::skin {

namespace {

using geometry::RegularTriangulation;
using geometry::Sign;

/// The vertex of a coface that the simplex lacks.
template <std::size_t N>
AtomId apex_over(const std::array<AtomId, N>& simplex, const std::array<AtomId, N + 1>& coface) {
  return *std::ranges::find_if(
      coface, [&](AtomId a) { return std::ranges::find(simplex, a) == simplex.end(); });
}

/// Whether the orthocentre lies in the closed simplex: no facet's smallest orthosphere contains the
/// opposite vertex.
template <std::size_t N>
bool contains_orthocentre(const std::array<WeightedPoint, N>& simplex) {
  if constexpr (N > 1) {
    for (std::size_t k = 0; k < N; ++k) {
      std::array<WeightedPoint, N - 1> facet;
      for (std::size_t i = 0; i + 1 < N; ++i) facet[i] = simplex[(k + 1 + i) % N];
      if (geometry::orthosphere_power_sign(facet, simplex[k]) == Sign::Negative) return false;
    }
  }
  return true;
}

/// Membership in K of the simplices of one dimension, given that of the next higher one.
template <std::size_t N>
struct Membership {
  const SkinSurface& skin;
  const std::vector<std::array<AtomId, N>>& simplices;
  const std::vector<std::array<AtomId, N + 1>>& above;  ///< of the next dimension, if any
  const Cofaces& cofaces;
  const std::vector<char>& above_in;

  enum class Verdict : std::uint8_t { Out, In, Singular };

  Verdict operator()(std::size_t s) const {
    const auto simplex = corners(skin.points(), simplices[s]);
    const Sign weight = geometry::orthosphere_weight_sign(simplex);
    bool is_face = false;  // of a simplex in K
    if constexpr (N < 4) {
      for (const std::uint32_t c : cofaces.of(s)) is_face = is_face || above_in[c];
    }
    // Deep in the body nearly all are faces, which decides.
    if (weight == Sign::Negative || (is_face && weight != Sign::Zero)) {
      return is_face ? Verdict::In : Verdict::Out;
    }
    if constexpr (N < 4) {
      for (const std::uint32_t c : cofaces.of(s)) {
        const AtomId apex = apex_over(simplices[s], above[c]);
        const bool is_attached = geometry::orthosphere_power_sign(
                                     simplex, skin.points()[apex.index()]) == Sign::Negative;
        if (is_attached) return is_face ? Verdict::In : Verdict::Out;
      }
    }
    return weight == Sign::Zero && contains_orthocentre(simplex) ? Verdict::Singular : Verdict::In;
  }
};

/// By index, whether each simplex of one dimension is in K.
/// @throws SingularSkin  for the first that makes the skin singular
template <std::size_t N>
std::vector<char> members(const Membership<N>& membership, unsigned threads) {
  using Verdict = typename Membership<N>::Verdict;
  const auto& simplices = membership.simplices;
  std::vector<char> result(simplices.size(), 0);
  std::vector<std::size_t> singular(geometry::block_count(simplices.size()), simplices.size());
  geometry::for_each_block(threads, simplices.size(),
                           [&](std::size_t begin, std::size_t end, std::size_t block) {
                             for (std::size_t s = begin; s < end; ++s) {
                               const Verdict verdict = membership(s);
                               result[s] = verdict == Verdict::In;
                               if (verdict == Verdict::Singular)
                                 singular[block] = std::min(singular[block], s);
                             }
                           });
  const std::size_t first = *std::ranges::min_element(singular);
  if (first < simplices.size()) {
    throw SingularSkin({simplices[first].begin(), simplices[first].end()});
  }
  return result;
}

std::size_t count(const std::vector<char>& in) {
  return static_cast<std::size_t>(std::count(in.begin(), in.end(), 1));
}

/// The components of the vertices and edges in the complex.
void find_bodies(DualComplex& result, const RegularTriangulation& t,
                 std::span<const std::uint32_t> vertex_of_atom, std::span<const char> in0,
                 std::span<const char> in1) {
  geometry::UnionFind body(in0.size());
  for (std::size_t e = 0; e < t.edges.size(); ++e) {
    if (!in1[e]) continue;
    body.join(vertex_of_atom[t.edges[e][0].index()], vertex_of_atom[t.edges[e][1].index()]);
  }
  result.body_of_vertex = numbered(body, in0.size(), [&](std::uint32_t v) { return in0[v] == 1; });
  for (std::uint32_t v = 0; v < in0.size(); ++v) {
    if (result.body_of_vertex[v] == result.bodies.size()) result.bodies.push_back(t.vertices[v]);
  }
}

/// The tetrahedra about each triangle, and the triangles about each edge.
std::pair<Cofaces, Cofaces> cofaces_of(const RegularTriangulation& t, unsigned threads) {
  std::pair<Cofaces, Cofaces> result;
  geometry::do_both(
      threads,
      [&] {
        result.first = cofaces(t.triangles.size(), t.tetrahedra, [&](std::size_t s, std::size_t k) {
          return t.tetrahedron_triangles[s][k];
        });
      },
      [&] {
        result.second = cofaces(t.edges.size(), t.triangles, [&](std::size_t s, std::size_t k) {
          return t.triangle_edges[s][k];
        });
      });
  return result;
}

}  // namespace

DualComplex dual_complex(const SkinSurface& skin, const geometry::Run& run) {
  const unsigned threads = run.threads();
  const RegularTriangulation& t = skin.triangulation();
  assert(t.tetrahedron_triangles.size() == t.tetrahedra.size());
  assert(t.triangle_edges.size() == t.triangles.size());
  DualComplex result;
  const auto [tetrahedra_of, triangles_of] = cofaces_of(t, threads);
  // From the highest dimension down.
  const auto in3 = members<4>({skin, t.tetrahedra, {}, {}, {}}, threads);
  std::vector<std::uint32_t> vertex_of_atom(skin.points().size(), 0);
  for (std::uint32_t v = 0; v < t.vertices.size(); ++v) vertex_of_atom[t.vertices[v].index()] = v;
  const auto first_vertex = [&](const auto& simplex) { return vertex_of_atom[simplex[0].index()]; };
  const auto in2 = members<3>({skin, t.triangles, t.tetrahedra, tetrahedra_of, in3}, threads);
  result.void_of_tetrahedron = void_of_tetrahedron(tetrahedra_of, in2, in3);
  Complement complement(skin, result.void_of_tetrahedron);
  complement.descend(tetrahedra_of, in2, 2,
                     [&](std::size_t s) { return first_vertex(t.triangles[s]); });
  const auto in1 = members<2>({skin, t.edges, t.triangles, triangles_of, in2}, threads);
  complement.descend(triangles_of, in1, 1, [&](std::size_t s) { return first_vertex(t.edges[s]); });
  std::vector<char> in0;
  {
    std::vector<std::array<AtomId, 1>> vertices(t.vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = {t.vertices[v]};
    const Cofaces edges_of = cofaces(vertices.size(), t.edges, [&](std::size_t s, std::size_t k) {
      return vertex_of_atom[t.edges[s][1 - k].index()];
    });
    in0 = members<1>({skin, vertices, t.edges, edges_of, in1}, threads);
    complement.descend(edges_of, in0, 0,
                       [](std::size_t s) { return static_cast<std::uint32_t>(s); });
  }
  result.simplices = {count(in0), count(in1), count(in2), count(in3)};
  find_bodies(result, t, vertex_of_atom, in0, in1);
  complement.give_to(result);
  for (std::uint32_t& v : result.void_of_tetrahedron)
    v = v == Complement::outside ? DualComplex::no_part : v;
  result.betti[0] = result.bodies.size();
  result.betti[2] = result.voids.size();
  result.betti[1] = static_cast<std::size_t>(static_cast<long>(result.betti[0] + result.betti[2]) -
                                             result.euler_characteristic());
  return result;
}

}  // namespace morskin::skin

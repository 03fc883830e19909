#include "geometry/regular_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/grouped.h"
#include "geometry/parallel.h"
#include "geometry/prefetch.h"
#include "geometry/triangulator.h"

namespace morskin::geometry {
namespace {

template <std::size_t Size>
using Simplices = std::vector<std::array<AtomId, Size>>;

template <std::size_t Size>
std::array<AtomId, Size - 1> without(const std::array<AtomId, Size>& simplex, std::size_t corner) {
  std::array<AtomId, Size - 1> rest;
  for (std::size_t k = 0; k + 1 < Size; ++k) rest[k] = simplex[k < corner ? k : k + 1];
  return rest;
}

/// Two atoms as one number with the same order.
std::uint64_t pair_of(AtomId b, AtomId c) { return std::uint64_t{b.value} << 32 | c.value; }

AtomId first_of(std::uint64_t pair) { return AtomId(static_cast<std::uint32_t>(pair >> 32)); }
AtomId second_of(std::uint64_t pair) { return AtomId(static_cast<std::uint32_t>(pair)); }

/// The corners after the first as one number with the same order. @pre two or three corners
template <std::size_t Size>
std::uint64_t rest_of(const std::array<AtomId, Size>& simplex) {
  static_assert(Size == 2 || Size == 3);
  return Size == 2 ? simplex[1].value : pair_of(simplex[1], simplex[Size - 1]);
}

/// Sorts, by insertion where there are few: of the branches one for each value goes wrong.
template <class Values>
void sort_few(Values&& values) {
  constexpr std::ptrdiff_t few = 48;
  if (std::ssize(values) > few) {
    std::ranges::sort(values);
    return;
  }
  for (auto next = values.begin(); next != values.end(); ++next) {
    const auto value = *next;
    auto hole = next;
    for (; hole != values.begin() && value < hole[-1]; --hole) *hole = hole[-1];
    *hole = value;
  }
}

template <class Value>
void sort_few_unique(std::vector<Value>& values) {
  sort_few(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Of some tetrahedra, the simplices of the highest dimension and, of each lower one, those that
/// begin with an atom with which no simplex about them of a higher dimension begins.
struct Found {
  Simplices<4> tetrahedra;
  Simplices<3> triangles;
  Simplices<2> edges;
};

/// Simplices by their first corner.
template <std::size_t Size>
using Buckets = Grouped<std::array<AtomId, Size>>;

template <std::size_t Size>
Buckets<Size> into_buckets(const std::vector<Found>& found, Simplices<Size> Found::*simplices,
                           std::size_t atom_count) {
  return grouped<std::array<AtomId, Size>>(atom_count, [&](auto visit) {
    for (const Found& part : found) {
      for (const auto& simplex : part.*simplices) visit(simplex[0].index(), simplex);
    }
  });
}

/// Adds the simplices that begin with the next atom, each made of a value.
template <std::size_t Size, class Values, class Simplex>
void append(Buckets<Size>& buckets, const Values& values, Simplex simplex) {
  std::uint32_t at = buckets.first.back();
  buckets.items.resize(at + values.size());
  for (const auto value : values) buckets.items[at++] = simplex(value);
  buckets.first.push_back(at);
}

/// One after the other, of consecutive atoms.
template <std::size_t Size>
Buckets<Size> joined(const std::vector<Buckets<Size>>& parts, unsigned threads) {
  Buckets<Size> result;
  std::vector<std::uint32_t> offsets;
  for (const Buckets<Size>& part : parts) {
    const std::uint32_t offset = offsets.emplace_back(result.first.back());
    for (const std::uint32_t end : std::span(part.first).subspan(1)) {
      result.first.push_back(offset + end);
    }
  }
  result.items.resize(result.first.back());
  for_each_task(threads, parts.size(), [&](std::size_t k) {
    std::ranges::copy(parts[k].items, result.items.begin() + offsets[k]);
  });
  return result;
}

/// A tetrahedron's corners in the order of their atoms.
struct SortedCorners {
  std::array<AtomId, 4> atoms;
  std::size_t first = 0, second = 0;  ///< the indices of the first two

  SortedCorners(const Triangulator& triangulator, const Triangulator::Tetrahedron& t) {
    std::array<std::uint64_t, 4> keys;  // of atom and index
    for (std::size_t k = 0; k < 4; ++k) {
      keys[k] = std::uint64_t{triangulator.atom(t.corners[k])->value} << 2 | k;
    }
    // A network, for its branches cannot be predicted.
    const auto order = [&](std::size_t i, std::size_t j) {
      const std::uint64_t low = std::min(keys[i], keys[j]);
      keys[j] = std::max(keys[i], keys[j]);
      keys[i] = low;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    for (std::size_t k = 0; k < 4; ++k) atoms[k] = AtomId(static_cast<std::uint32_t>(keys[k] >> 2));
    first = keys[0] & 3;
    second = keys[1] & 3;
  }
};

/// Such a triangle is the facet opposite the first corner of a tetrahedron, and the corner behind
/// it comes before its own corners too; such an edge joins the last two corners of all tetrahedra
/// about it. The edges are some more than these.
Found find_in_space(const Triangulator& triangulator, std::size_t begin, std::size_t end) {
  Found found;
  const auto tetrahedra = triangulator.tetrahedra();
  found.tetrahedra.reserve(end - begin);
  const auto is_behind_before = [&](Triangulator::Facet facet, AtomId atom) {
    const auto& there = tetrahedra[Triangulator::tetrahedron_of(facet)];
    const auto behind = triangulator.atom(there.corners[Triangulator::index_of(facet)]);
    return !behind || *behind < atom;  // nothing at infinity
  };
  for (std::size_t i = begin; i < end; ++i) {
    const Triangulator::Tetrahedron& t = tetrahedra[i];
    if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
    const SortedCorners corners(triangulator, t);
    const auto& [a, b, c, d] = corners.atoms;
    found.tetrahedra.push_back(corners.atoms);
    if (!is_behind_before(t.neighbours[corners.first], c)) continue;
    if (is_behind_before(t.neighbours[corners.first], b)) found.triangles.push_back({b, c, d});
    if (is_behind_before(t.neighbours[corners.second], c)) found.edges.push_back({c, d});
  }
  return found;
}

/// The same of points in a plane or on a line, where apexes take the place of other corners.
Found find_in_span(const Triangulator& triangulator, std::size_t begin, std::size_t end) {
  Found found;
  const auto tetrahedra = triangulator.tetrahedra();
  for (std::size_t i = begin; i < end; ++i) {
    if (!triangulator.is_live(i) || triangulator.is_ghost(tetrahedra[i])) continue;
    std::vector<AtomId> atoms;
    for (const Triangulator::Corner corner : tetrahedra[i].corners) {
      if (const auto atom = triangulator.atom(corner)) atoms.push_back(*atom);
    }
    if (std::ssize(atoms) != triangulator.dimension() + 1) continue;
    std::ranges::sort(atoms);
    if (atoms.size() == 3) found.triangles.push_back({atoms[0], atoms[1], atoms[2]});
    if (atoms.size() > 1) found.edges.push_back({atoms.end()[-2], atoms.end()[-1]});
  }
  return found;
}

std::vector<Found> find_all(const Triangulator& triangulator, unsigned threads) {
  const auto find = triangulator.dimension() == 3 ? find_in_space : find_in_span;
  const std::size_t count = triangulator.tetrahedra().size();
  std::vector<Found> found(block_count(count));
  for_each_block(threads, count, [&](std::size_t begin, std::size_t end, std::size_t block) {
    found[block] = find(triangulator, begin, end);
  });
  return found;
}

/// All simplices, sorted.
struct Complex {
  Buckets<4> tetrahedra;
  Buckets<3> triangles;
  Buckets<2> edges;
};

/// What begins with an atom are the facets of what begins with it a dimension higher, and what was
/// found apart.
Complex complete(std::vector<Found> found, std::size_t atom_count, unsigned threads) {
  Buckets<4> tetrahedra;
  Buckets<3> other_triangles;
  Buckets<2> other_edges;
  for_each_task(threads, 3, [&](std::size_t task) {
    if (task == 0) tetrahedra = into_buckets(found, &Found::tetrahedra, atom_count);
    if (task == 1) other_triangles = into_buckets(found, &Found::triangles, atom_count);
    if (task == 2) other_edges = into_buckets(found, &Found::edges, atom_count);
  });
  found.clear();
  std::vector<Buckets<3>> triangles(block_count(atom_count));
  std::vector<Buckets<2>> edges(block_count(atom_count));
  for_each_block(threads, atom_count, [&](std::size_t begin, std::size_t end, std::size_t block) {
    std::vector<std::uint64_t> pairs;
    std::vector<AtomId> seconds;
    for (std::size_t i = begin; i < end; ++i) {
      const AtomId a(i);
      sort_few(tetrahedra.of(i));
      pairs.clear();
      for (const auto& [same, b, c, d] : tetrahedra.of(i)) {
        pairs.insert(pairs.end(), {pair_of(b, c), pair_of(b, d), pair_of(c, d)});
      }
      for (const auto& triangle : other_triangles.of(i)) pairs.push_back(rest_of(triangle));
      sort_few_unique(pairs);
      append(triangles[block], pairs, [&](std::uint64_t pair) {
        return std::array{a, first_of(pair), second_of(pair)};
      });
      seconds.clear();
      for (const std::uint64_t pair : pairs) {
        if (seconds.empty() || seconds.back() != first_of(pair)) seconds.push_back(first_of(pair));
      }
      for (const std::uint64_t pair : pairs) seconds.push_back(second_of(pair));
      for (const auto& edge : other_edges.of(i)) seconds.push_back(edge[1]);
      sort_few_unique(seconds);
      append(edges[block], seconds, [&](AtomId b) { return std::array{a, b}; });
    }
  });
  return {std::move(tetrahedra), joined(triangles, threads), joined(edges, threads)};
}

/// By simplex, the indices of its facets, entry k opposite corner k. The binary search uses a
/// conditional move, since its branches are unpredictable.
template <std::size_t Size>
std::vector<std::array<std::uint32_t, Size>> facet_indices(const Simplices<Size>& simplices,
                                                           const Buckets<Size - 1>& facets,
                                                           unsigned threads) {
  constexpr std::size_t ahead = 8;
  std::vector<std::array<std::uint32_t, Size>> indices(simplices.size());
  for_each_block(threads, simplices.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      // The facet opposite the first corner begins with another, far off.
      if (i + 2 * ahead < end) prefetch(&facets.first[simplices[i + 2 * ahead][1].index()]);
      if (i + ahead < end) {
        prefetch(&facets.items[facets.first[simplices[i + ahead][1].index()]]);
      }
      for (std::size_t k = 0; k < Size; ++k) {
        const auto facet = without(simplices[i], k);
        const std::uint64_t wanted = rest_of(facet);
        std::uint32_t index = facets.first[facet[0].index()];
        std::uint32_t candidates = facets.first[facet[0].index() + 1] - index;
        while (candidates > 1) {
          const std::uint32_t half = candidates / 2;
          index += rest_of(facets.items[index + half]) <= wanted ? half : 0;
          candidates -= half;
        }
        indices[i][k] = index;
      }
    }
  });
  return indices;
}

/// The heaviest of points at one position, the smallest id if equal.
AtomId heaviest(std::span<const WeightedPoint> points) {
  const auto best = std::max_element(
      points.begin(), points.end(),
      [](const WeightedPoint& a, const WeightedPoint& b) { return a.weight < b.weight; });
  return AtomId(static_cast<std::size_t>(best - points.begin()));
}

}  // namespace

RegularTriangulation regular_triangulation(std::span<const WeightedPoint> points, const Run& run) {
  RegularTriangulation result;
  std::vector<bool> is_vertex(points.size(), false);
  std::vector<Found> found;
  {
    const Triangulator triangulator(points, run);
    result.dimension = triangulator.dimension();
    found = find_all(triangulator, run.threads());
  }
  if (result.dimension == 0) is_vertex[heaviest(points).index()] = true;
  Complex all = complete(std::move(found), points.size(), run.threads());
  result.tetrahedron_triangles = facet_indices(all.tetrahedra.items, all.triangles, run.threads());
  result.triangle_edges = facet_indices(all.triangles.items, all.edges, run.threads());
  result.tetrahedra = std::move(all.tetrahedra.items);
  result.triangles = std::move(all.triangles.items);
  result.edges = std::move(all.edges.items);
  for (const auto& [a, b] : result.edges) is_vertex[a.index()] = is_vertex[b.index()] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    (is_vertex[i] ? result.vertices : result.hidden).push_back(AtomId(i));
  }
  return result;
}

}  // namespace morskin::geometry

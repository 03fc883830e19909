#include "skin/complement.h"

#include <algorithm>
#include <cmath>

#include "geometry/sort_unique.h"

namespace morskin::skin {

namespace {

constexpr std::uint32_t no_part = DualComplex::no_part;

}  // namespace

std::vector<std::uint32_t> void_of_tetrahedron(const Cofaces& tetrahedra_of,
                                               const std::vector<char>& triangle_in,
                                               const std::vector<char>& tetrahedron_in) {
  const auto hull_side = static_cast<std::uint32_t>(tetrahedron_in.size());
  geometry::UnionFind complement(tetrahedron_in.size() + 1);
  for (std::size_t f = 0; f < triangle_in.size(); ++f) {
    if (triangle_in[f]) continue;
    const auto around = tetrahedra_of.of(f);
    if (around.empty()) continue;
    complement.join(around[0], around.size() == 2 ? around[1] : hull_side);
  }
  const auto is_outside = [&](std::uint32_t c) {
    return tetrahedron_in[c] == 0 && complement.root(c) == complement.root(hull_side);
  };
  auto number = numbered(complement, hull_side,
                         [&](std::uint32_t c) { return tetrahedron_in[c] == 0 && !is_outside(c); });
  for (std::uint32_t c = 0; c < hull_side; ++c) {
    if (is_outside(c)) number[c] = Complement::outside;
  }
  return number;
}

Complement::Complement(const SkinSurface& skin, std::span<const std::uint32_t> void_of_tetrahedron)
    : above_(void_of_tetrahedron.begin(), void_of_tetrahedron.end()) {
  for (std::uint32_t t = 0; t < above_.size(); ++t) {
    if (above_[t] == no_part || above_[t] == outside) continue;
    const Patch ball = skin.complex().patch(skin.complex().cell(3, t));
    const double clearance = std::sqrt(std::max(-ball.half_weight, 0.0));
    if (above_[t] == voids_.size()) voids_.push_back({t, ball.centre, clearance, {}, 0});
    Void& here = voids_[above_[t]];
    ++here.euler_characteristic;
    if (clearance > here.clearance) {
      here.tetrahedron = t;
      here.centre = ball.centre;
      here.clearance = clearance;
    }
  }
}

void Complement::give_to(DualComplex& result) {
  const auto add = [&](std::vector<std::uint32_t>& bodies, std::uint32_t vertex) {
    bodies.push_back(result.body_of_vertex[vertex]);
  };
  for (const auto& [part, vertex] : walls_) {
    add(part == outside ? result.outer_bodies : voids_[part].bodies, vertex);
  }
  geometry::sort_unique(result.outer_bodies);
  for (Void& v : voids_) geometry::sort_unique(v.bodies);
  result.voids = std::move(voids_);
}

}  // namespace morskin::skin

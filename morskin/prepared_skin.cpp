#include "morskin/prepared_skin.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>
#include <utility>

#include "geometry/exact_range.h"
#include "morse/tracer.h"

namespace morskin {

namespace {

bool is_in_range(const geometry::WeightedPoint& p) {
  return std::ranges::all_of(p.position, geometry::is_exact_coordinate) &&
         geometry::is_exact_weight(p.weight);
}

double largest_coordinate(const geometry::WeightedPoint& p) {
  return p.position.cwiseAbs().maxCoeff() + std::sqrt(std::abs(p.weight));
}

[[noreturn]] void refuse_scale(const std::vector<geometry::WeightedPoint>& points,
                               geometry::AtomId too_small) {
  const auto farthest = std::ranges::max_element(points, {}, largest_coordinate);
  throw ScalesTooFarApart(too_small,
                          geometry::AtomId(static_cast<std::size_t>(farthest - points.begin())));
}

/// Of an atom: whether it is a ball with a patch of a radius below some tolerances of the walls.
auto has_patch_below(const skin::SkinSurface& skin, double tolerances) {
  const double least_radius = tolerances * skin.complex().wall_tolerance();
  return [&skin, least_weight = 2 * least_radius * least_radius](geometry::AtomId atom) {
    const double weight = skin.points()[atom.index()].weight;
    return weight > 0 && weight < least_weight;
  };
}

/// @throws ScalesTooFarApart  for the first ball too small that shares skin with another
void check_scales(const skin::SkinSurface& skin) {
  const auto is_too_small = has_patch_below(skin, morse::Tracer::no_width);
  // Hardly ever is there one, and then the cells are not looked at.
  if (std::ranges::none_of(skin.triangulation().vertices, is_too_small)) return;
  for (std::size_t i = 0; i < skin.cell_count(); ++i) {
    const geometry::CellId cell(i);
    if (skin.complex().dimension(cell) != 1) continue;
    for (const geometry::AtomId atom : skin.atoms(cell)) {
      if (is_too_small(atom)) refuse_scale(skin.points(), atom);
    }
  }
}

/// The critical points of any function on a whole sphere lie no farther apart than its diameter:
/// with a radius below the tolerance they count as one.
/// @throws ScalesTooFarApart  for the first ball too small that shares no skin
void check_lone_balls(const skin::SkinSurface& skin, const skin::DualComplex& topology) {
  const std::vector<geometry::AtomId>& vertices = skin.triangulation().vertices;
  const auto is_too_small = has_patch_below(skin, 1);
  if (std::ranges::none_of(vertices, is_too_small)) return;
  std::vector<std::size_t> balls(topology.bodies.size(), 0);
  for (const std::uint32_t body : topology.body_of_vertex) {
    if (body != skin::DualComplex::no_part) ++balls[body];
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::uint32_t body = topology.body_of_vertex[v];
    const bool is_alone = body != skin::DualComplex::no_part && balls[body] == 1;
    if (is_alone && is_too_small(vertices[v])) refuse_scale(skin.points(), vertices[v]);
  }
}

/// Where the orthocentre of balls lies in their cell, the skin comes as near to it as the root of
/// half its weight: half the width of a neck, a tunnel or a gap.
/// @throws UnresolvedNeck
void check_necks(const skin::SkinSurface& skin) {
  for (std::size_t i = 0; i < skin.cell_count(); ++i) {
    const geometry::CellId cell(i);
    const skin::Patch& patch = skin.complex().kept_patch(cell);
    const double rounding = 0x1p-53 * patch.centre.cwiseAbs().maxCoeff();
    const double thinnest = 8 * rounding;
    if (std::abs(patch.half_weight) >= thinnest * thinnest || skin.atoms(cell).size() == 1)
      continue;
    if (!skin.is_in(patch.centre, cell)) continue;
    const skin::CellAtoms atoms = skin.atoms(cell);
    throw UnresolvedNeck({atoms.begin(), atoms.end()});
  }
}

}  // namespace

ScalesTooFarApart::ScalesTooFarApart(geometry::AtomId too_small, geometry::AtomId far_out)
    : geometry::RefusedInput(
          "weighted point " + std::to_string(too_small.value) +
          " has a patch over 2^36 times smaller than " +
          (too_small == far_out
               ? "its largest coordinate: doubles cannot carry both; move it to the origin"
               : "the largest coordinate, of weighted point " + std::to_string(far_out.value) +
                     ": doubles cannot carry both; mesh them apart")),
      small(too_small),
      largest(far_out) {}

UnresolvedNeck::UnresolvedNeck(std::vector<geometry::AtomId> between)
    : geometry::RefusedInput("between weighted point " + std::to_string(between.front().value) +
                             " and its neighbours the skin is thinner than coordinates resolve: "
                             "move the molecule to the origin"),
      atoms(std::move(between)) {}

PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Run& run) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_in_range(points[i])) continue;
    throw geometry::RefusedInput(
        "weighted point " + std::to_string(i) +
        " has a coordinate or weight that is no number, above 2^30, or has digits below 2^-120 (a "
        "weight: 2^-240)");
  }
  skin::SkinSurface surface(std::move(points), skin::MixedComplex::Keep::NearSkin, run);
  check_scales(surface);
  skin::DualComplex topology =
      run.stage("dual complex", [&] { return skin::dual_complex(surface, run); });
  check_lone_balls(surface, topology);
  check_necks(surface);
  surface.forget_facets();
  return {std::move(surface), std::move(topology)};
}

double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing) {
  const double rho = skin.max_length_scale();
  return sizing.tangent_disk_share() * (sizing.scale(rho) / rho);
}

}  // namespace morskin

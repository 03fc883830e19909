#include "certify/residuals.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "certify/tube.h"
#include "geometry/files/text_lines.h"
#include "geometry/parallel.h"

namespace morskin::certify {

namespace {

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

}  // namespace

bool is_single_precision(std::span<const surface::Point> positions) {
  return !positions.empty() && std::ranges::all_of(positions, [](const surface::Point& p) {
    return std::abs(p.x()) <= FLT_MAX && std::abs(p.y()) <= FLT_MAX && std::abs(p.z()) <= FLT_MAX &&
           is_float(p.x()) && is_float(p.y()) && is_float(p.z());
  });
}

std::string off_skin_in_words(double distance) {
  if (!(distance > 0)) return "is not known to lie on the skin";
  if (std::isinf(distance)) return "lies off the skin, by a distance that is not known";
  return "lies about " + geometry::in_digits(distance, 3) + " Angstrom off the skin";
}

Residuals residuals(const LocatedMesh& on, bool is_single_precision, const geometry::Run& run) {
  const auto check = [&](std::uint32_t v, Residuals& found) {
    const LocatedVertex& at = on.vertices[v];
    const double rho = at.length_scale();
    // |N| falls along the way to the skin, so its length is no less than the distance.
    const double distance = max_flow_path(rho - at.error, at.max_value());
    found.max_distance = std::max(found.max_distance, distance);
    found.max_relative_distance = std::max(found.max_relative_distance, distance / rho);
    // A hundred times the mesher's tolerance, for the last digits of other programs: far below the
    // needs of the theorem. Rounding to floats moves a vertex by d, at most 2^-24 of its distance
    // from the origin, and changes G by 2 rho d + d^2. What rounding hides of G is not held against
    // the vertex: it counts as off where even the least |G| within the bounds is too large, or
    // where they are so wide that no distance is known.
    const double moved = is_single_precision ? std::ldexp(on.position(v).norm(), -24) : 0;
    const double least = std::max({0.0F, at.low, -at.high});
    const double tolerance = 100 * on.surface.residual_bound(rho) + (2 * rho + moved) * moved;
    const bool is_on_skin = std::isfinite(distance) && least <= tolerance;
    if (!is_on_skin && !found.first_off_skin) {
      const double value = at.low > 0 ? least : -least;
      const bool is_cut = least >= FLT_MAX;  // the bounds are floats
      found.first_off_skin = {
          v, is_cut ? std::numeric_limits<double>::infinity() : estimated_distance(value, rho)};
    }
  };
  const std::size_t count = on.vertices.size();
  std::vector<Residuals> found(geometry::block_count(count));
  geometry::for_each_block(run.threads(), count, [&](auto begin, auto end, auto block) {
    for (std::size_t v = begin; v < end; ++v) check(static_cast<std::uint32_t>(v), found[block]);
  });
  Residuals whole;
  for (const Residuals& part : found) {
    whole.max_distance = std::max(whole.max_distance, part.max_distance);
    whole.max_relative_distance = std::max(whole.max_relative_distance, part.max_relative_distance);
    if (!whole.first_off_skin) whole.first_off_skin = part.first_off_skin;
  }
  return whole;
}

}  // namespace morskin::certify

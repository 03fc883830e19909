#include "morskin/prepared_skin.h"

#include <cmath>
#include <string>
#include <utility>

#include "geometry/predicates.h"

namespace morskin {

namespace {

constexpr double max_input = 1 << 30;  // the range of the exact predicates

bool is_in_range(const geometry::WeightedPoint& p) {
  return p.position.allFinite() && std::isfinite(p.weight) &&
         p.position.cwiseAbs().maxCoeff() <= max_input && std::abs(p.weight) <= max_input;
}

}  // namespace

PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Run& run) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    geometry::WeightedPoint& p = points[i];
    if (!is_in_range(p)) {
      throw geometry::RefusedInput("weighted point " + std::to_string(i) +
                                   " has a coordinate or weight that is no number or beyond 2^30");
    }
    p.position = p.position.unaryExpr(&geometry::on_exact_grid);
    p.weight = geometry::on_exact_grid(p.weight);
  }
  skin::SkinSurface surface(std::move(points), skin::MixedComplex::Keep::NearSkin, run);
  skin::DualComplex topology =
      run.stage("dual complex", [&] { return skin::dual_complex(surface, run); });
  surface.forget_facets();
  return {std::move(surface), topology};
}

double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing) {
  const double rho = skin.max_length_scale();
  return sizing.tangent_disk_share() * (sizing.scale(rho) / rho);
}

}  // namespace morskin

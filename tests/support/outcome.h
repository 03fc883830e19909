#pragma once

#include <string>
#include <vector>

#include "morskin/pipeline.h"
#include "skin/singular_skin.h"
#include "tests/support/meshes.h"

namespace morskin::support {

/// How a set of balls came out: certified or refused as singular is as it should be.
struct Outcome {
  enum class Kind { Certified, Singular, Failed } kind = Kind::Failed;
  std::string why;            ///< of a failure
  std::size_t triangles = 0;  ///< of a certified mesh
};

/// Meshes and certifies; what the promise of the program forbids is a failure: no certificate, an
/// angle below the bound or the goal that was asked for, critical points that do not add up, a
/// refusal for another reason.
inline Outcome outcome_of(const std::vector<geometry::WeightedPoint>& points,
                          const morskin::MeshingOptions& options = {}) {
  using Kind = Outcome::Kind;
  try {
    const morskin::MeshResult result = support::meshed(points, options);
    const certify::Certificate& certificate = result.certificate;
    if (!certificate.certified) return {Kind::Failed, certificate.reason, certificate.triangles};
    const double bound = options.goal_deg() >= certify::guaranteed_angle_deg
                             ? certify::guaranteed_angle_deg
                             : options.sizing.angle_bound_deg();
    if (!(certificate.proved_angle_deg() >= bound)) {
      return {Kind::Failed, "an angle below the bound", certificate.triangles};
    }
    if (certificate.min_angle_deg < options.angle_goal_deg.value_or(0)) {
      return {Kind::Failed, "an angle below the goal", certificate.triangles};
    }
    if (certificate.euler_characteristic != morskin::euler_characteristic(result.critical_points)) {
      return {Kind::Failed, "critical points that do not add up", certificate.triangles};
    }
    return {Kind::Certified, {}, certificate.triangles};
  } catch (const skin::SingularSkin&) {
    return {Kind::Singular, {}, 0};
  } catch (const std::exception& error) {
    return {Kind::Failed, error.what(), 0};
  }
}

}  // namespace morskin::support

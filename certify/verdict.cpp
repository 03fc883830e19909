// What follows from all that was looked at: the verdict, and the reason against it.

#include <cmath>

#include "certify/certificate.h"
#include "geometry/files/text_lines.h"

namespace morskin::certify {

namespace {

/// "1 edge breaks [L]", "2 edges break [L]".
std::string in_words(std::size_t count, const std::string& element, const std::string& condition) {
  return std::to_string(count) + " " + element + (count == 1 ? " breaks " : "s break ") + condition;
}

}  // namespace

void Certificate::compare_counts() {
  const long v = static_cast<long>(vertices), t = static_cast<long>(triangles);
  euler_characteristic = v - t / 2;
  genus = static_cast<long>(components) - euler_characteristic / 2;
  std::string differences;
  const auto compare = [&](const char* what, long is, long should) {
    if (is == should) return;
    differences += (differences.empty() ? "" : "; ") + std::string(what) + " is " +
                   std::to_string(is) + ", the skin's is " + std::to_string(should);
  };
  compare("the number of components", static_cast<long>(components),
          static_cast<long>(expected_components));
  compare("the Euler characteristic", euler_characteristic, expected_euler_characteristic);
  compare("the genus", genus, expected_genus);
  if (!differences.empty()) fail(Claim::Counts, differences);
}

double Certificate::proved_angle_deg() const {
  constexpr double rounding = 1e-15;  // of the arc sine and of degrees, in shares
  return (1 - rounding) * std::asin(min_sine) * 180 / M_PI;
}

const std::string& Certificate::objection() const {
  for (const Claim claim : {Claim::Manifold, Claim::Upright, Claim::Tube, Claim::Degree}) {
    if (!holds(claim)) return broken_by(claim);
  }
  return broken_by(Claim::Counts);
}

void Certificate::conclude(const Sizing& sizing) {
  is_homeomorphic = objection().empty();
  const double claimed = claimed_angle_deg = sizing.claimed_angle_deg;
  const bool has_angles = claimed > 0
                              ? proved_angle_deg() >= claimed
                              : violations_L == 0 || proved_angle_deg() >= guaranteed_angle_deg;
  certified = is_homeomorphic && holds(Claim::OnSkin) && violations_U == 0 && has_angles;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Claim::Counts); ++i) {
    if (reason.empty()) reason = broken[i];
  }
  if (!reason.empty() || certified) return;
  if (claimed > 0 && !has_angles) {
    reason = "triangle " + std::to_string(sharpest_triangle) + " has an angle of " +
             geometry::in_digits(proved_angle_deg(), 9) + " degrees, below " +
             geometry::in_digits(claimed, 4);
  } else {
    reason =
        in_words(violations_L, "edge", "[L]") + ", " + in_words(violations_U, "triangle", "[U]");
  }
}

}  // namespace morskin::certify

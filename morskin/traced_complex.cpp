#include "morskin/traced_complex.h"

#include <string>
#include <utility>

#include "geometry/error.h"
#include "morse/validate_complex.h"

namespace morskin {

namespace {

/// Whether the value at an extremum is beyond that at a saddle. Rounding may hide it where the skin
/// is small beside the coordinates.
bool is_beyond(const morse::CriticalPoint& extremum, const morse::CriticalPoint& saddle) {
  return extremum.index == 0 ? extremum.value < saddle.value : extremum.value > saddle.value;
}

/// The objections to a complex: its own degeneracies, a number of components that is not the
/// skin's, ends of an arc that rounding does not tell apart, or a broken law.
std::optional<std::string> objection_to(const morse::MorseSmaleComplex& complex,
                                        const skin::DualComplex& topology) {
  if (!complex.degeneracies.empty()) return complex.degeneracies.front();
  if (complex.components != topology.skin_components()) {
    return "the arcs join " + std::to_string(complex.components) + " components, not " +
           std::to_string(topology.skin_components());
  }
  for (const auto& [saddle, extremum] : complex.arcs) {
    if (is_beyond(complex.points[extremum.index()], complex.points[saddle.index()])) continue;
    return "the values at a saddle and at the end of a line from it agree within rounding " +
           morse::position_text(complex.points[saddle.index()].point.position);
  }
  return morse::validate(complex);
}

}  // namespace

void require_usable(const morse::MorseFunction& f) {
  if (!f.direction.allFinite() || !f.origin.allFinite()) {
    throw geometry::RefusedInput("the Morse function's direction or point is not finite");
  }
  if (f.is_height() && !(f.direction.norm() > 0)) {
    throw geometry::RefusedInput("the height direction must be a vector that is not zero");
  }
}

morse::ChosenFunction choose_function(const PreparedSkin& skin,
                                      const std::optional<morse::MorseFunction>& asked,
                                      const morse::Objection& objection) {
  if (asked) require_usable(*asked);
  return morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), asked,
                                objection);
}

TracedComplex trace_complex(const PreparedSkin& skin,
                            const std::optional<morse::MorseFunction>& asked,
                            const geometry::Run& run) {
  morse::MorseSmaleComplex complex;
  const auto objection = [&](const morse::ChosenFunction& candidate) {
    complex = run.stage("integral lines", [&] {
      return morse::morse_smale_complex(skin.surface, candidate.function, candidate.critical,
                                        morse::Polylines::Keep, run);
    });
    return objection_to(complex, skin.topology);
  };
  const morse::MorseFunction function = choose_function(skin, asked, objection).function;
  return {function, std::move(complex)};
}

}  // namespace morskin

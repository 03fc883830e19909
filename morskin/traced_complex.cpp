#include "morskin/traced_complex.h"

#include <string>
#include <utility>

#include "geometry/error.h"
#include "morse/validate_complex.h"

namespace morskin {

namespace {

/// The objections to a complex: its own degeneracies, a number of components that is not the
/// skin's, or a broken law.
std::optional<std::string> objection_to(const morse::MorseSmaleComplex& complex,
                                        const skin::DualComplex& topology) {
  if (!complex.degeneracies.empty()) return complex.degeneracies.front();
  if (complex.components != topology.skin_components()) {
    return "the arcs join " + std::to_string(complex.components) + " components, not " +
           std::to_string(topology.skin_components());
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

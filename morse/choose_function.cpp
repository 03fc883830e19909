#include "morse/choose_function.h"

namespace morskin::morse {

namespace {

std::optional<std::string> degeneracy(const ChosenFunction& choice, long expected) {
  if (!choice.critical.degeneracies.empty()) return choice.critical.degeneracies.front();
  const long chi = choice.critical.euler_characteristic();
  if (chi == expected) return std::nullopt;
  return "minima - saddles + maxima is " + std::to_string(chi) + ", not " +
         std::to_string(expected);
}

}  // namespace

std::vector<MorseFunction> default_functions() {
  std::vector<MorseFunction> functions{MorseFunction{}};
  for (const Vector& tilted :
       {Vector(0.0391, 1, -0.0177), Vector(-0.0523, 1, 0.0311), Vector(0.1117, 1, 0.0713),
        Vector(-0.0933, 1, -0.1391), Vector(0.2171, 1, 0.1549), Vector(0.3019, 1, -0.2243)}) {
    functions.push_back(MorseFunction::height(tilted));
  }
  return functions;
}

ChosenFunction choose_function(const skin::SkinSurface& skin, long euler_characteristic,
                               const std::optional<MorseFunction>& asked,
                               const Objection& objection) {
  std::vector<MorseFunction> functions = default_functions();
  if (asked) functions = {*asked};
  std::string why;
  for (const MorseFunction& function : functions) {
    ChosenFunction choice{function, critical_points(skin, function)};
    std::optional<std::string> reason = degeneracy(choice, euler_characteristic);
    if (!reason && objection) reason = objection(choice);
    if (!reason) return choice;
    why = *reason;
  }
  const bool is_height = functions.back().is_height();
  throw DegenerateFunction("the " +
                           std::string(is_height ? "height function" : "squared distance") +
                           " is degenerate for this molecule: " + why + "; give another " +
                           (is_height ? "direction" : "point"));
}

}  // namespace morskin::morse

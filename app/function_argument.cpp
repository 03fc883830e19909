#include "app/function_argument.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/report.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

constexpr double largest_coordinate = 1 << 30;  // Angstrom; that of atoms, geometry/predicates.h

geometry::Vector three_numbers(std::string_view text, const std::string& complaint) {
  std::string spaced(text);
  std::ranges::replace(spaced, ',', ' ');
  std::string_view rest = spaced;
  geometry::Vector numbers;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> value = geometry::parse_double(geometry::take_field(rest));
    if (!value || !std::isfinite(*value)) throw UsageError(complaint);
    numbers[axis] = *value;
  }
  if (!geometry::trimmed(rest).empty()) throw UsageError(complaint);
  return numbers;
}

morse::MorseFunction height(const geometry::Vector& direction, const std::string& option) {
  const double length = direction.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) {
    throw UsageError(option + " needs a direction; its length must not be zero or infinite");
  }
  return morse::MorseFunction::height_along(direction);
}

std::string triple(const geometry::Vector& v) {
  std::string text = "(";
  text += brief(v.x()) + ", " + brief(v.y()) + ", " + brief(v.z());
  return text + ")";
}

}  // namespace

morse::MorseFunction parsed_height(std::string_view text) {
  return height(three_numbers(text, "--height needs three numbers: x,y,z"), "--height");
}

morse::MorseFunction parsed_function(std::string_view text) {
  const std::string complaint =
      "--function needs height:x,y,z or distance:x,y,z, not " + geometry::quoted(text);
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  if (colon == std::string_view::npos || (kind != "height" && kind != "distance")) {
    throw UsageError(complaint);
  }
  const geometry::Vector numbers = three_numbers(text.substr(colon + 1), complaint);
  if (kind == "height") return height(numbers, "--function height");
  if (numbers.cwiseAbs().maxCoeff() > largest_coordinate) {
    throw UsageError("--function distance needs coordinates of at most 2^30 Angstrom");
  }
  return morse::MorseFunction::squared_distance(numbers);
}

std::string in_words(const morse::MorseFunction& function) {
  return function.is_height() ? "height along " + triple(function.direction)
                              : "squared distance from " + triple(function.origin);
}

nlohmann::ordered_json function_json(const morse::MorseFunction& function) {
  const geometry::Vector& v = function.is_height() ? function.direction : function.origin;
  return {{"kind", function.is_height() ? "height" : "distance"},
          {function.is_height() ? "direction" : "origin", {v.x(), v.y(), v.z()}}};
}

std::string_view unit_of(const morse::MorseFunction& function) {
  return function.is_height() ? "A" : "A^2";
}

}  // namespace morskin::app

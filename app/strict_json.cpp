#include "app/strict_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

/// Why a number is none in JSON, or nullptr; of an array the first such reason.
const char* fault_of(const ordered_json& value) {
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    if (std::isinf(number)) return "beyond the largest double, 1.8e308";
    if (std::isnan(number)) return "undefined: its computation overflows or divides 0 by 0";
  }
  if (!value.is_array()) return nullptr;
  for (const ordered_json& element : value) {
    if (const char* const fault = fault_of(element)) return fault;
  }
  return nullptr;
}

ordered_json with_reasons(const ordered_json& value) {
  if (value.is_array()) {
    ordered_json result = ordered_json::array();
    for (const ordered_json& element : value) result.push_back(with_reasons(element));
    return result;
  }
  if (!value.is_object()) return fault_of(value) == nullptr ? value : ordered_json();
  ordered_json result = ordered_json::object();
  for (const auto& [name, field] : value.items()) {
    result[name] = with_reasons(field);
    if (const char* const fault = fault_of(field)) result[name + "_reason"] = fault;
  }
  return result;
}

}  // namespace

std::string strict_json(const ordered_json& report) {
  return with_reasons(report).dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace morskin::app

#include "geometry/files/provenance_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/files/text_lines.h"

namespace morskin::geometry {

nlohmann::ordered_json provenance_json(const Provenance& provenance) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [key, value, is_number] : provenance.entries) {
    const std::optional<double> number = is_number ? parse_double(value) : std::nullopt;
    json.emplace(key, number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(value));
  }
  return json;
}

}  // namespace morskin::geometry

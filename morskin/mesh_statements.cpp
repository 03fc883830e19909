#include "morskin/mesh_statements.h"

#include <cmath>
#include <string>
#include <utility>

#include "certify/sizing.h"
#include "geometry/files/text_lines.h"
#include "morskin/boundary.h"
#include "skin/model.h"

namespace morskin {

geometry::Provenance statements(const SkinOptions& skin, const MeshOptions& sizing,
                                std::string_view verdict) {
  // All that fits into the 80 bytes of STL.
  geometry::Provenance result{.entries = {},
                              .brief = "morskin " MORSKIN_VERSION ", A, " + std::string(verdict)};
  const auto add = [&](std::string key, std::string_view text) {
    result.entries.push_back({std::move(key), std::string(text)});
  };
  const auto add_number = [&](std::string key, double number) {
    std::string value;
    geometry::append_number(value, number);
    result.entries.push_back({std::move(key), std::move(value), true});
  };
  const skin::Model model = inside(skin.model);
  add("version", MORSKIN_VERSION);
  add("model", skin::name_of(model));
  if (skin::has_probe(model)) add_number("probe", skin.probe);
  std::string voids = std::isinf(skin.drop_voids_below) ? "drop" : "keep";
  if (std::isfinite(skin.drop_voids_below) && skin.drop_voids_below > 0) {
    voids.clear();
    geometry::append_number(voids, skin.drop_voids_below);
  }
  add("voids", voids);
  const certify::Sizing sizes{sizing.C, sizing.Q.value(), sizing.max_length_scale};
  add_number("C", sizes.C);
  add_number("Q", sizes.Q);
  if (std::isfinite(sizes.largest_length_scale)) add_number("size", sizes.edge_length());
  add("verdict", verdict);
  return result;
}

}  // namespace morskin

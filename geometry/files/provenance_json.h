#pragma once

#include <nlohmann/json_fwd.hpp>

#include "geometry/provenance.h"

namespace morskin::geometry {

/// The entries as an object, numbers as numbers; of a key that comes again the first.
nlohmann::ordered_json provenance_json(const Provenance& provenance);

}  // namespace morskin::geometry

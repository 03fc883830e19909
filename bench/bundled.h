#pragma once

#include <string>
#include <vector>

#include "skin/model.h"
#include "skin/molecule_files.h"

namespace morskin {

/// The balls of a file in bench/molecules, with the probe of section 2.1. Benchmarks run from the
/// project's root.
inline std::vector<geometry::WeightedPoint> bundled_balls(const std::string& file,
                                                          skin::Model model = skin::Model::Paper) {
  return skin::weighted_points(skin::read_molecule("bench/molecules/" + file), model, 1.4);
}

}  // namespace morskin

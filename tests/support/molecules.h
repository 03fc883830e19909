#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "skin/model.h"
#include "skin/molecule_files.h"
#include "tests/support/ball_sets.h"

namespace morskin::support {

using WeightedPoints = std::vector<geometry::WeightedPoint>;

/// The balls of a file in bench/molecules. Tests run from the project's root.
inline WeightedPoints molecule(std::string_view file, skin::Model model, double probe = 1.4) {
  const auto path = std::filesystem::path("bench/molecules") / file;
  return skin::weighted_points(skin::read_molecule(path), model, probe);
}

inline constexpr std::array all_models{skin::Model::Paper, skin::Model::Sas, skin::Model::Vdw};

/// All files of bench/molecules.
inline const std::vector<const char*> bundled_molecules{
    "5tmn_ligand.pdb", "9dna.pdb",          "1grm_model1.pdb", "1crn.pdb",
    "benzene.pdb",     "c60.xyz",           "caffeine.xyz",    "cube8.xyzr",
    "ring12.xyzr",     "shell_hollow.xyzr", "two_balls.xyzr"};

/// Tries a law for the balls of some of these files in every model, and names file and model of a
/// failure.
template <class Law>
void for_molecules(const std::vector<const char*>& files, Law law) {
  for (const char* file : files) {
    CAPTURE(file);
    for (const skin::Model model : all_models) {
      CAPTURE(skin::name_of(model));
      law(molecule(file, model));
    }
  }
}

/// A ball whose patch has this radius.
inline geometry::WeightedPoint ball(double x, double y, double z, double patch_radius) {
  return {{x, y, z}, 2 * patch_radius * patch_radius};
}

/// The six corners of an octahedron, patches overlapping.
inline WeightedPoints octahedron_balls() {
  return {ball(2, 0, 0, 1.5),  ball(-2, 0, 0, 1.5), ball(0, 2, 0, 1.5),
          ball(0, -2, 0, 1.5), ball(0, 0, 2, 1.5),  ball(0, 0, -2, 1.5)};
}

/// Four balls of one weight at alternate corners of the cube of side 2: squared distances 8,
/// squared circumradius of a face 8/3, of the whole 3.
inline WeightedPoints tetrahedron_balls(double weight) {
  return {{{1, 1, 1}, weight}, {{1, -1, -1}, weight}, {{-1, 1, -1}, weight}, {{-1, -1, 1}, weight}};
}

/// All lengths twice as large.
inline WeightedPoints doubled(WeightedPoints points) {
  for (geometry::WeightedPoint& p : points) {
    p.position *= 2;
    p.weight *= 4;
  }
  return points;
}

/// So many copies in a row, each a step farther along x.
inline WeightedPoints in_a_row(const WeightedPoints& points, int copies, double step) {
  WeightedPoints row;
  for (int i = 0; i < copies; ++i) {
    for (geometry::WeightedPoint p : points) {
      p.position.x() += i * step;
      row.push_back(p);
    }
  }
  return row;
}

inline WeightedPoints shuffled(WeightedPoints points, unsigned seed) {
  Random(seed).shuffle(points);
  return points;
}

/// The balls' box, a little larger, and its half diagonal: the length that rounding is relative to.
struct Box {
  geometry::Point low, high;

  geometry::Point sample(Random& random) const {
    return {random.between(low.x(), high.x()), random.between(low.y(), high.y()),
            random.between(low.z(), high.z())};
  }
};
inline Box box_of(const WeightedPoints& points) {
  Box box{points[0].position, points[0].position};
  for (const geometry::WeightedPoint& p : points) {
    const double r = 1.2 * std::sqrt(std::max(p.weight, 0.0));
    box.low = box.low.cwiseMin((p.position.array() - r).matrix());
    box.high = box.high.cwiseMax((p.position.array() + r).matrix());
  }
  return box;
}
/// The largest distance between two points of a box, or from the origin, Angstrom.
inline double span_of(const Box& box) {
  return (box.high - box.low).norm() + std::max(box.high.norm(), box.low.norm());
}

}  // namespace morskin::support

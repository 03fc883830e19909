#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "skin/molecule.h"

namespace morskin::skin {

/// How the balls of a molecule become weighted points. With r the atom's van der Waals radius and p
/// the probe's, both Angstrom, the weight W (Angstrom^2) and the radius sqrt(W / 2) of the atom's
/// sphere patch are
///
///     Paper   W = sqrt(2) (r + p)    as printed; the only reading that gives Table 1's counts
///     Sas     W = 2 (r + p)^2        patches have the solvent-accessible radius r + p
///     Vdw     W = 2 r^2              patches have the radius r; the probe plays no part
///
/// Source:  Cheng & Shi 2004, section 2.1.
/// Erratum: the weight printed there is a length; Paper takes its number as Angstrom^2.
enum class Model { Paper, Sas, Vdw };

/// The model called "paper", "sas" or "vdw"; nothing for other words.
std::optional<Model> parse_model(std::string_view name);
std::string_view name_of(Model model);

/// The weight of an atom, Angstrom^2.
///
/// @param radius  r, Angstrom.
/// @param probe   p, Angstrom.
/// @pre  radius > 0 and probe >= 0, both finite
double weight(double radius, Model model, double probe);

/// The radius of the sphere patch that a weight gives at shrink factor 1/2, Angstrom.
/// @pre  weight >= 0
double patch_radius(double weight);

/// The weighted points of all atoms, in the atoms' order, every number on the grid of the exact
/// predicates. The caller checks that none exceeds 2^30 (morskin::prepare_skin does).
std::vector<geometry::WeightedPoint> weighted_points(const Molecule& molecule, Model model,
                                                     double probe);

/// The balls as an XYZR file, "x y z r" per line, r the patch radius. Every number is the shortest
/// that reads back as the same double.
std::string xyzr_text(const std::vector<geometry::WeightedPoint>& points);

}  // namespace morskin::skin

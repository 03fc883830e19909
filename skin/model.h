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
///     Paper   W = sqrt(2) (r + p)    as printed; the reading nearest to Table 1's counts on two
///                                    molecules of three
///     Sas     W = 2 (r + p)^2        patches have the solvent-accessible radius r + p
///     Vdw     W = 2 r^2              patches have the radius r; the probe plays no part
///     SesLike W = 2 (r + s)^2        s = ses_like_offset: of these skins the nearest to the
///                                    solvent-excluded surface for a probe of 1.4 Angstrom
///                                    (bench/ses_like.py); it is none. The probe plays no part
///     Given   W as in the file       of a file of weights (XYZW), which has no radii
///
/// Source:  Cheng & Shi 2004, section 2.1.
/// Erratum: the weight printed there is a length; Paper takes its number as Angstrom^2.
enum class Model { Paper, Sas, Vdw, SesLike, Given };

/// By how much the patches of SesLike are larger than the atoms, Angstrom.
inline constexpr double ses_like_offset = 0.25;

/// The model called "paper", "sas", "vdw", "ses-like" or "given"; nothing for other words.
std::optional<Model> parse_model(std::string_view name);
std::string_view name_of(Model model);
/// Whether the probe plays a part.
bool has_probe(Model model);

/// The weight of an atom, Angstrom^2.
///
/// @param radius  r, Angstrom.
/// @param probe   p, Angstrom.
/// @pre  radius > 0 and probe >= 0, both finite; the model is not Given
double weight(double radius, Model model, double probe);

/// The radius of the sphere patch that a weight gives at shrink factor 1/2, Angstrom.
/// @pre  weight >= 0
double patch_radius(double weight);

/// The weighted points of all atoms, in the atoms' order: each coordinate as in the file, each
/// weight the formula's value in doubles or, with Given, as in the file. Not all of them need be in
/// the range of the exact predicates (geometry/exact_range.h).
/// @pre  the model is Given if and only if the molecule has weights
std::vector<geometry::WeightedPoint> weighted_points(const Molecule& molecule, Model model,
                                                     double probe);

/// The balls as an XYZR file, "x y z r" per line, r the patch radius. Every number is the shortest
/// that reads back as the same double.
std::string xyzr_text(const std::vector<geometry::WeightedPoint>& points);

/// The weighted points as an XYZW file, "x y z w" per line, w the weight: each number the shortest
/// that reads back as the same double, so that all of the skin comes back.
std::string xyzw_text(const std::vector<geometry::WeightedPoint>& points);

}  // namespace morskin::skin

#pragma once

#include <optional>
#include <string_view>

namespace morskin::skin {

/// Where van der Waals radii are published.
///
/// Source: A. Bondi, J. Phys. Chem. 68 (1964) 441; M. Mantina et al., J. Phys. Chem. A 113 (2009)
///         5806; S. Alvarez, Dalton Trans. 42 (2013) 8617.
enum class RadiusSource {
  Elements,  ///< Bondi; elements missing there from Mantina et al., then from Alvarez
  Bondi,     ///< Bondi alone, 38 elements
  Alvarez,   ///< Alvarez alone, all radii from one analysis of crystal structures
};

/// The van der Waals radius of an element.
///
/// @param element  a symbol in upper or lower case ("C", "CL", "Cl"); "D" and "T" are hydrogen.
/// @return Angstrom; nothing for unknown symbols and elements without a published radius
std::optional<double> van_der_waals_radius(std::string_view element,
                                           RadiusSource source = RadiusSource::Elements);

/// The symbol of an element in the usual spelling ("Cl"), "D" for deuterium and "T" for tritium;
/// nothing for unknown symbols.
std::optional<std::string_view> element_symbol(std::string_view element);

/// The symbol of the element with this atomic number, 1 to 118; nothing for other numbers.
std::optional<std::string_view> element_symbol(long long atomic_number);

}  // namespace morskin::skin

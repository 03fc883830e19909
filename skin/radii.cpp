#include "skin/radii.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace morskin::skin {
namespace {

struct Element {
  std::string_view symbol;
  double bondi = 0;    // Bondi 1964
  double mantina = 0;  // Mantina et al. 2009: main group elements missing in Bondi
  double alvarez = 0;  // Alvarez 2013
};

constexpr std::size_t element_count = 118;

// By atomic number. 0 where the source has no value; Mantina's only where Bondi has none.
// clang-format off
constexpr std::array<Element, element_count> elements = {{
    {"H", 1.20, 0, 1.20}, {"He", 1.40, 0, 1.43}, {"Li", 1.82, 0, 2.12}, {"Be", 0, 1.53, 1.98},
    {"B", 0, 1.92, 1.91}, {"C", 1.70, 0, 1.77}, {"N", 1.55, 0, 1.66}, {"O", 1.52, 0, 1.50},
    {"F", 1.47, 0, 1.46}, {"Ne", 1.54, 0, 1.58}, {"Na", 2.27, 0, 2.50}, {"Mg", 1.73, 0, 2.51},
    {"Al", 0, 1.84, 2.25}, {"Si", 2.10, 0, 2.19}, {"P", 1.80, 0, 1.90}, {"S", 1.80, 0, 1.89},
    {"Cl", 1.75, 0, 1.82}, {"Ar", 1.88, 0, 1.83}, {"K", 2.75, 0, 2.73}, {"Ca", 0, 2.31, 2.62},
    {"Sc", 0, 0, 2.58}, {"Ti", 0, 0, 2.46}, {"V", 0, 0, 2.42}, {"Cr", 0, 0, 2.45},
    {"Mn", 0, 0, 2.45}, {"Fe", 0, 0, 2.44}, {"Co", 0, 0, 2.40}, {"Ni", 1.63, 0, 2.40},
    {"Cu", 1.40, 0, 2.38}, {"Zn", 1.39, 0, 2.39}, {"Ga", 1.87, 0, 2.32}, {"Ge", 0, 2.11, 2.29},
    {"As", 1.85, 0, 1.88}, {"Se", 1.90, 0, 1.82}, {"Br", 1.85, 0, 1.86}, {"Kr", 2.02, 0, 2.25},
    {"Rb", 0, 3.03, 3.21}, {"Sr", 0, 2.49, 2.84}, {"Y", 0, 0, 2.75}, {"Zr", 0, 0, 2.52},
    {"Nb", 0, 0, 2.56}, {"Mo", 0, 0, 2.45}, {"Tc", 0, 0, 2.44}, {"Ru", 0, 0, 2.46},
    {"Rh", 0, 0, 2.44}, {"Pd", 1.63, 0, 2.15}, {"Ag", 1.72, 0, 2.53}, {"Cd", 1.58, 0, 2.49},
    {"In", 1.93, 0, 2.43}, {"Sn", 2.17, 0, 2.42}, {"Sb", 0, 2.06, 2.47}, {"Te", 2.06, 0, 1.99},
    {"I", 1.98, 0, 2.04}, {"Xe", 2.16, 0, 2.06}, {"Cs", 0, 3.43, 3.48}, {"Ba", 0, 2.68, 3.03},
    {"La", 0, 0, 2.98}, {"Ce", 0, 0, 2.88}, {"Pr", 0, 0, 2.92}, {"Nd", 0, 0, 2.95}, {"Pm"},
    {"Sm", 0, 0, 2.90}, {"Eu", 0, 0, 2.87}, {"Gd", 0, 0, 2.83}, {"Tb", 0, 0, 2.79},
    {"Dy", 0, 0, 2.87}, {"Ho", 0, 0, 2.81}, {"Er", 0, 0, 2.83}, {"Tm", 0, 0, 2.79},
    {"Yb", 0, 0, 2.80}, {"Lu", 0, 0, 2.74}, {"Hf", 0, 0, 2.63}, {"Ta", 0, 0, 2.53},
    {"W", 0, 0, 2.57}, {"Re", 0, 0, 2.49}, {"Os", 0, 0, 2.48}, {"Ir", 0, 0, 2.41},
    {"Pt", 1.75, 0, 2.29}, {"Au", 1.66, 0, 2.32}, {"Hg", 1.55, 0, 2.45}, {"Tl", 1.96, 0, 2.47},
    {"Pb", 2.02, 0, 2.60}, {"Bi", 0, 2.07, 2.54}, {"Po", 0, 1.97}, {"At", 0, 2.02},
    {"Rn", 0, 2.20}, {"Fr", 0, 3.48}, {"Ra", 0, 2.83}, {"Ac", 0, 0, 2.80}, {"Th", 0, 0, 2.93},
    {"Pa", 0, 0, 2.88}, {"U", 1.86, 0, 2.71}, {"Np", 0, 0, 2.82}, {"Pu", 0, 0, 2.81},
    {"Am", 0, 0, 2.83}, {"Cm", 0, 0, 3.05}, {"Bk", 0, 0, 3.40}, {"Cf", 0, 0, 3.05},
    {"Es", 0, 0, 2.70}, {"Fm"}, {"Md"}, {"No"}, {"Lr"}, {"Rf"}, {"Db"}, {"Sg"}, {"Bh"}, {"Hs"},
    {"Mt"}, {"Ds"}, {"Rg"}, {"Cn"}, {"Nh"}, {"Fl"}, {"Mc"}, {"Lv"}, {"Ts"}, {"Og"},
}};
// clang-format on

char lower(char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); }

bool is_same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower, lower);
}

const Element* find(std::string_view symbol) {
  if (is_same_word(symbol, "D") || is_same_word(symbol, "T")) symbol = "H";
  const auto found = std::ranges::find_if(
      elements, [&](const Element& element) { return is_same_word(element.symbol, symbol); });
  return found == elements.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> van_der_waals_radius(std::string_view element, RadiusSource source) {
  const Element* found = find(element);
  if (found == nullptr) return std::nullopt;
  const bool takes_all = source == RadiusSource::Elements;
  if ((takes_all || source == RadiusSource::Bondi) && found->bondi > 0) return found->bondi;
  if (takes_all && found->mantina > 0) return found->mantina;
  const bool takes_alvarez = takes_all || source == RadiusSource::Alvarez;
  if (takes_alvarez && found->alvarez > 0) return found->alvarez;
  return std::nullopt;
}

std::optional<std::string_view> element_symbol(std::string_view element) {
  if (is_same_word(element, "D")) return "D";
  if (is_same_word(element, "T")) return "T";
  const Element* found = find(element);
  if (found == nullptr) return std::nullopt;
  return found->symbol;
}

std::optional<std::string_view> element_symbol(long long atomic_number) {
  if (atomic_number < 1 || atomic_number > static_cast<long long>(element_count)) {
    return std::nullopt;
  }
  return elements[static_cast<std::size_t>(atomic_number - 1)].symbol;
}

}  // namespace morskin::skin

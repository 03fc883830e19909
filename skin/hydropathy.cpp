#include "skin/hydropathy.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace morskin::skin {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 33> scale = {{
    {"ALA", 1.8},  {"ARG", -4.5}, {"ASN", -3.5}, {"ASP", -3.5}, {"ASH", -3.5}, {"CYS", 2.5},
    {"CYM", 2.5},  {"CYX", 2.5},  {"GLN", -3.5}, {"GLU", -3.5}, {"GLH", -3.5}, {"GLY", -0.4},
    {"HIS", -3.2}, {"HID", -3.2}, {"HIE", -3.2}, {"HIP", -3.2}, {"HSD", -3.2}, {"HSE", -3.2},
    {"HSP", -3.2}, {"ILE", 4.5},  {"LEU", 3.8},  {"LYS", -3.9}, {"LYN", -3.9}, {"MET", 1.9},
    {"MSE", 1.9},  {"PHE", 2.8},  {"PRO", -1.6}, {"SER", -0.8}, {"THR", -0.7}, {"TRP", -0.9},
    {"TYR", -1.3}, {"TYM", -1.3}, {"VAL", 4.2},
}};

}  // namespace

std::optional<double> kyte_doolittle(const Label& residue) {
  std::string_view name = residue.view();
  const bool is_of_end = name.size() == 4 && (name[0] == 'N' || name[0] == 'C');
  if (is_of_end) name.remove_prefix(1);
  const auto found = std::ranges::find(scale, name, &std::pair<std::string_view, double>::first);
  if (found == scale.end()) return std::nullopt;
  return found->second;
}

}  // namespace morskin::skin

#include "app/typed_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/files/text_lines.h"

namespace morskin::app {

namespace {

constexpr std::array<std::pair<std::string_view, MeshMethod>, 5> methods{
    {{"auto", MeshMethod::Auto},
     {"sweep", MeshMethod::Sweep},
     {"static", MeshMethod::Static},
     {"dynamic", MeshMethod::Dynamic},
     {"marching-cubes", MeshMethod::MarchingCubes}}};

}  // namespace

std::optional<MeshMethod> parse_method(std::string_view name) {
  for (const auto& [word, method] : methods) {
    if (word == name) return method;
  }
  return std::nullopt;
}

std::string_view name_of(MeshMethod method) {
  return methods[static_cast<std::size_t>(method)].first;
}

ShowProgress parsed_progress(std::string_view word) {
  if (word == "always") return ShowProgress::Always;
  return word == "never" ? ShowProgress::Never : ShowProgress::Auto;
}

std::optional<std::int64_t> parse_digits(std::string_view text) {
  const bool has_others = text.find_first_not_of("0123456789") != std::string_view::npos;
  return has_others ? std::nullopt : geometry::parse_integer(text);
}

std::uint64_t parsed_bytes(std::string_view text) {
  constexpr std::string_view units = "KMGT";
  constexpr double most = 0x1p62;  // far beyond any machine, far from overflow
  std::string_view digits = text;
  double factor = 1;
  if (!text.empty()) {
    const std::size_t unit = units.find(static_cast<char>(text.back() & ~0x20));
    if (unit != std::string_view::npos) {
      factor = std::ldexp(1.0, 10 * static_cast<int>(unit + 1));
      digits.remove_suffix(1);
    }
  }
  const std::optional<double> value = geometry::parse_double(digits);
  if (!value || !(*value * factor >= 1 && *value * factor <= most)) {
    throw UsageError("--max-memory needs a number of bytes, or one with K, M, G or T, as in 2G");
  }
  return static_cast<std::uint64_t>(*value * factor);
}

double parsed_voids(std::string_view text) {
  if (text == "keep") return 0;
  if (text == "drop") return std::numeric_limits<double>::infinity();
  const std::optional<double> volume = geometry::parse_double(text);
  if (!volume || !(*volume >= 0 && std::isfinite(*volume))) {
    throw UsageError("--voids takes keep, drop or a volume of at least 0 cubic Angstrom");
  }
  return *volume;
}

std::pair<double, double> parsed_growth(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots != std::string_view::npos) {
    const std::optional<double> from = geometry::parse_double(text.substr(0, dots));
    const std::optional<double> to = geometry::parse_double(text.substr(dots + 2));
    if (from && to && std::isfinite(*from) && std::isfinite(*to) && *from < *to) {
      return {*from, *to};
    }
  }
  throw UsageError("--grow needs two times, the earlier first, as in --grow -3..0");
}

std::vector<double> parsed_snapshots_at(const std::vector<std::string>& lists) {
  std::vector<double> values;
  for (const std::string& list : lists) {
    for (std::size_t first = 0; first <= list.size();) {
      const std::size_t comma = std::min(list.find(',', first), list.size());
      const auto value = geometry::parse_double(list.substr(first, comma - first));
      if (!value || !std::isfinite(*value)) {
        throw UsageError("--snapshot-at takes numbers, finite ones with commas between, not " +
                         geometry::quoted(list));
      }
      values.push_back(*value);
      first = comma + 1;
    }
  }
  return values;
}

VertexData parsed_vertex_data(std::string_view text) {
  const std::span<const morskin::Datum> all = morskin::all_data();
  if (text == "all") return {{all.begin(), all.end()}, true, true, true};
  VertexData result;
  while (true) {
    const std::string_view name = text.substr(0, text.find(','));
    if (name == "all") throw UsageError("--vertex-data all has every group; leave out the others");
    const std::optional<morskin::Datum> datum = morskin::parse_datum(name);
    const bool is_new = datum && std::ranges::find(result.data, *datum) == result.data.end();
    if (is_new) result.data.push_back(*datum);
    if (name == "residue") {
      result.residues = true;
    } else if (name == "charge") {
      result.charges = true;
    } else if (!datum) {
      std::string known;
      for (const morskin::Datum d : all) known += std::string(morskin::name_of(d)) + ", ";
      throw UsageError(
          "--vertex-data takes " + known +
          "residue or charge, with commas between, or all, charge where there are any; not " +
          geometry::quoted(name));
    }
    if (name.size() == text.size()) return result;
    text.remove_prefix(name.size() + 1);
  }
}

}  // namespace morskin::app

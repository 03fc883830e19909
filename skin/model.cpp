#include "skin/model.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/files/text_lines.h"
#include "skin/molecule_formats.h"

namespace morskin::skin {
namespace {

constexpr std::array<std::pair<std::string_view, Model>, 5> names = {{
    {"paper", Model::Paper},
    {"sas", Model::Sas},
    {"vdw", Model::Vdw},
    {"ses-like", Model::SesLike},
    {"given", Model::Given},
}};

/// A line for each point: its coordinates and what is made of its weight.
template <class FromWeight>
std::string table_text(const std::vector<geometry::WeightedPoint>& points, FromWeight from_weight) {
  std::string text;
  text.reserve(48 * points.size());
  for (const geometry::WeightedPoint& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      geometry::append_number(text, point.position[axis]);
      text += ' ';
    }
    geometry::append_number(text, from_weight(point.weight));
    text += '\n';
  }
  return text;
}

}  // namespace

std::optional<Model> parse_model(std::string_view name) {
  for (const auto& [known, model] : names) {
    if (name == known) return model;
  }
  return std::nullopt;
}

std::string_view name_of(Model model) { return names[static_cast<std::size_t>(model)].first; }

bool has_probe(Model model) { return model == Model::Paper || model == Model::Sas; }

double weight(double radius, Model model, double probe) {
  assert(radius > 0 && probe >= 0);
  switch (model) {
    case Model::Paper:
      return std::numbers::sqrt2 * (radius + probe);
    case Model::Sas:
      return 2 * (radius + probe) * (radius + probe);
    case Model::Vdw:
      return 2 * radius * radius;
    case Model::SesLike:
      return weight(radius, Model::Sas, ses_like_offset);
    case Model::Given:
      break;
  }
  return 0;
}

double patch_radius(double weight) { return std::sqrt(weight / 2); }

std::vector<geometry::WeightedPoint> weighted_points(const Molecule& molecule, Model model,
                                                     double probe) {
  assert((model == Model::Given) == !molecule.weights.empty());
  std::vector<geometry::WeightedPoint> points;
  points.reserve(molecule.atoms.size());
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const Atom& atom = molecule.atoms[i];
    points.push_back({atom.position, model == Model::Given ? molecule.weights[i]
                                                           : weight(atom.radius, model, probe)});
  }
  return points;
}

std::string xyzr_text(const std::vector<geometry::WeightedPoint>& points) {
  return table_text(points, [](double weight) { return patch_radius(weight); });
}

std::string xyzw_text(const std::vector<geometry::WeightedPoint>& points) {
  return std::string(molecule_formats::weights_line) + "\n" +
         table_text(points, [](double weight) { return weight; });
}

}  // namespace morskin::skin

#include "skin/model.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/files/text_lines.h"
#include "geometry/predicates.h"

namespace morskin::skin {
namespace {

constexpr std::array<std::pair<std::string_view, Model>, 3> names = {{
    {"paper", Model::Paper},
    {"sas", Model::Sas},
    {"vdw", Model::Vdw},
}};

}  // namespace

std::optional<Model> parse_model(std::string_view name) {
  for (const auto& [known, model] : names) {
    if (name == known) return model;
  }
  return std::nullopt;
}

std::string_view name_of(Model model) { return names[static_cast<std::size_t>(model)].first; }

double weight(double radius, Model model, double probe) {
  assert(radius > 0 && probe >= 0);
  switch (model) {
    case Model::Paper:
      return std::numbers::sqrt2 * (radius + probe);
    case Model::Sas:
      return 2 * (radius + probe) * (radius + probe);
    case Model::Vdw:
      return 2 * radius * radius;
  }
  return 0;
}

double patch_radius(double weight) { return std::sqrt(weight / 2); }

std::vector<geometry::WeightedPoint> weighted_points(const Molecule& molecule, Model model,
                                                     double probe) {
  std::vector<geometry::WeightedPoint> points;
  points.reserve(molecule.atoms.size());
  for (const Atom& atom : molecule.atoms) {
    geometry::WeightedPoint point;
    for (int axis = 0; axis < 3; ++axis) {
      point.position[axis] = geometry::on_exact_grid(atom.position[axis]);
    }
    point.weight = geometry::on_exact_grid(weight(atom.radius, model, probe));
    points.push_back(point);
  }
  return points;
}

std::string xyzr_text(const std::vector<geometry::WeightedPoint>& points) {
  std::string text;
  text.reserve(48 * points.size());
  for (const geometry::WeightedPoint& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      geometry::append_number(text, point.position[axis]);
      text += ' ';
    }
    geometry::append_number(text, patch_radius(point.weight));
    text += '\n';
  }
  return text;
}

}  // namespace morskin::skin

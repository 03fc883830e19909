#include "app/triangle_colours.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "app/pictures/scene.h"
#include "certify/triangle_geometry.h"
#include "geometry/union_find.h"

namespace morskin::app {
namespace {

using pictures::Colour;
using pictures::Mark;

constexpr std::array palette{Colour::of(0x8db7d9), Colour::of(0xe8a87c), Colour::of(0x93c48b),
                             Colour::of(0xc9a0d6), Colour::of(0xe6d27a), Colour::of(0xe39aa7),
                             Colour::of(0x86cfc4), Colour::of(0xb3b0a2)};

// Red at the lowest tick, below the paper's bound of 21 degrees; through yellow to blue at 60.
pictures::Legend::Bar angle_bar() {
  return {{{Colour::of(0xb2182b), Colour::of(0xf4a45c), Colour::of(0xf7efb2), Colour::of(0x8fc3de),
            Colour::of(0x2d6fb0)},
           20,
           60},
          "smallest angle",
          {"20°", "30°", "40°", "50°", "60°"}};
}

std::vector<Colour> colours_by_angle(const geometry::IndexedMesh& mesh) {
  const pictures::ColourScale scale = angle_bar().scale;
  std::vector<Colour> colours;
  for (const auto& [a, b, c] : mesh.triangles) {
    const certify::AngleRange angles =
        certify::angle_range(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    colours.push_back(scale.at(angles.smallest_deg));
  }
  return colours;
}

// Components by shared vertices, the first one in the first colour.
TriangleColours colours_by_component(const geometry::IndexedMesh& mesh) {
  geometry::UnionFind sets(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(a, c);
  }
  std::vector<std::optional<std::size_t>> number(mesh.positions.size());
  TriangleColours result;
  for (const auto& t : mesh.triangles) {
    std::optional<std::size_t>& own = number[sets.root(t[0])];
    if (!own) own = result.components++;
    result.colours.push_back(palette[*own % palette.size()]);
  }
  return result;
}

// Where there are more components than colours, which begin anew, it says so.
void add_components(pictures::Legend& legend, std::size_t components) {
  for (std::size_t i = 0; i < std::min(components, palette.size()); ++i) {
    const std::string number = std::to_string(i + 1);
    legend.entries.push_back({Mark::Patch, palette[i], i == 0 ? "component " + number : number});
  }
  if (components > palette.size()) {
    legend.entries.back().meaning +=
        ", then again from 1 to " + std::to_string(components) + " in all";
  }
}

}  // namespace

TriangleColours triangle_colours(const geometry::IndexedMesh& mesh, ColourBy by) {
  switch (by) {
    case ColourBy::Nothing:
      return {};
    case ColourBy::Angle:
      return {colours_by_angle(mesh), 0};
    case ColourBy::Component:
      return colours_by_component(mesh);
  }
  return {};
}

pictures::Legend legend_of(const RenderArguments& arguments, std::size_t components,
                           bool has_border, bool shows_inside) {
  pictures::Legend legend;
  if (arguments.by == ColourBy::Angle) legend.bar = angle_bar();
  if (arguments.by == ColourBy::Component) add_components(legend, components);
  const pictures::LegendEntry border{Mark::Line, border_red, "front, or rim of a hole"};
  const pictures::LegendEntry inside{Mark::Patch, pictures::Coat{}.back, "inner side"};
  if (has_border) legend.entries.push_back(border);
  if (shows_inside) legend.entries.push_back(inside);
  return legend;
}

}  // namespace morskin::app

// Figure 1: one molecule, three models.

#include <algorithm>
#include <array>

#include "app/figures/bundled.h"
#include "app/figures/figures.h"
#include "app/figures/skin_scene.h"

namespace morskin::figures {
namespace {

constexpr double probe = 1.4;  // Angstrom, section 2.1

struct Element {
  std::string_view symbol, name;
  Colour colour;
  double covalent_radius;  // Angstrom; B. Cordero et al., Dalton Trans. (2008) 2832
};
constexpr std::array elements{
    Element{"H", "hydrogen", Colour::of(0xf2f2f2), 0.31},
    Element{"C", "carbon", Colour::of(0x8e959e), 0.76},
    Element{"N", "nitrogen", Colour::of(0x5b7fd9), 0.71},
    Element{"O", "oxygen", Colour::of(0xd9534a), 0.66},
    Element{"P", "phosphorus", Colour::of(0xeda13c), 1.07},
};

const Element& element_of(const skin::Atom& atom) {
  const auto* found = std::ranges::find(elements, atom.element.view(), &Element::symbol);
  return found == elements.end() ? elements[1] : *found;
}

Scene balls_and_sticks(const skin::Molecule& molecule) {
  constexpr double ball = 0.24, stick = 0.16;  // share of the radius; Angstrom
  constexpr double slack = 0.45;               // Angstrom that a bond may be longer
  Scene scene;
  for (const skin::Atom& a : molecule.atoms) {
    scene.balls.push_back({a.position, ball * a.radius, element_of(a).colour});
    for (const skin::Atom& b : molecule.atoms) {
      const double longest = element_of(a).covalent_radius + element_of(b).covalent_radius + slack;
      const double distance = (a.position - b.position).norm();
      // Each half in the colour of its atom: b's comes with b.
      if (distance == 0 || distance > longest) continue;
      scene.sticks.push_back(
          {a.position, (a.position + b.position) / 2, stick, element_of(a).colour});
    }
  }
  return scene;
}

Scene solvent_accessible(const skin::Molecule& molecule) {
  Scene scene;
  for (const skin::Atom& a : molecule.atoms) {
    scene.balls.push_back({a.position, a.radius + probe, element_of(a).colour});
  }
  return scene;
}

}  // namespace

Image ball_and_stick_to_skin(double scale) {
  const skin::Molecule molecule = bundled_molecule("9dna.pdb");
  const morskin::PreparedSkin skin = bundled_skin("9dna.pdb");
  Scene surface;
  surface.meshes.push_back(skin_layer(skin, meshed(skin, 0.08)));
  std::vector<Point> centres;
  for (const skin::Atom& a : molecule.atoms) centres.push_back(a.position);
  const Scene accessible = solvent_accessible(molecule);
  const Camera camera = principal_camera(centres, 300, 520).fitted(accessible.extent());

  Camera detail = camera;
  detail.scale *= 6;
  detail.target += -0.4 / camera.scale * 60 * camera.right + 20 / camera.scale * camera.up;
  Scene edged = surface;
  edged.meshes[0].coat.edge_width = 1.1;

  std::array panels{panel(balls_and_sticks(molecule), camera, scale),
                    panel(accessible, camera, scale), panel(surface, camera, scale),
                    panel(edged, detail, scale)};
  frame(panels[2], camera, detail, scale);
  draw_border(panels[3], {pictures::ink, 2 * scale});
  const Image row =
      captioned(panels,
                std::array<std::string_view, 4>{"balls and sticks", "solvent accessible",
                                                "molecular skin", "its mesh"},
                scale, 4);
  pictures::Legend legend;
  for (const Element& e : elements) {
    const auto is_it = [&](const skin::Atom& atom) { return &element_of(atom) == &e; };
    if (std::ranges::any_of(molecule.atoms, is_it)) {
      legend.entries.push_back({Mark::Dot, e.colour, std::string(e.name)});
    }
  }
  return with_legend(row, legend, scale);
}

}  // namespace morskin::figures

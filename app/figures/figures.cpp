#include "app/figures/figures.h"

#include <array>

namespace morskin::figures {

std::span<const Figure> all_figures() {
  static constexpr std::array figures{
      Figure{"1", "A-DNA: balls and sticks, solvent accessible, skin, detail",
             ball_and_stick_to_skin},
      Figure{"2", "critical points and level curves of the height", level_curves},
      Figure{"3", "the contraction of an arc of the Morse-Smale complex", contraction},
      Figure{"4", "six states of the mesh of the cube", cube_snapshots},
      Figure{"5", "creation: a bowl at a minimum", bowl},
      Figure{"6", "creep: a fan at a departure vertex", creep},
      Figure{"7", "wing: a small angle closed", wing},
      Figure{"8", "bridge: two fronts joined at a saddle", bridge},
      Figure{"9", "the sandwiching balls in cross section", sandwiching_ball},
      Figure{"10a", "the Morse-Smale complex of 5TMN's inhibitor", inhibitor_complex},
      Figure{"10b", "a head as a skin of medial balls", head},
      Figure{"11", "gramicidin A and a detail", gramicidin},
      Figure{"surface-ball", "a Delaunay facet, its dual edge, its surface ball", surface_ball},
  };
  return figures;
}

const Figure* find_figure(std::string_view name) {
  for (const Figure& figure : all_figures()) {
    if (figure.name == name) return &figure;
  }
  return nullptr;
}

}  // namespace morskin::figures

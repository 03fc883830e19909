#include <iostream>

#include "app/commands.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/report_lines.h"
#include "app/staged_outputs.h"

namespace morskin::app {

ExitCode balls_command(const BallsArguments& arguments) {
  check_not_input(arguments.output, arguments.molecule);
  const MoleculeInput input = read_input(arguments.molecule);
  if (!arguments.quiet) {
    note_rounded_coordinates(input);
    note_unused(arguments.molecule, input);
  }
  const std::string text =
      arguments.weights ? skin::xyzw_text(input.points) : skin::xyzr_text(input.points);
  StagedOutputs outputs({arguments.output});
  write_to_all(outputs, text);
  if (!arguments.quiet && !outputs.files().empty()) {
    const RadiusRange radii = patch_radii(input.points);
    std::cout << arguments.molecule.input.string() << " -> " << arguments.output.string() << "\n"
              << line("balls", grouped(input.points.size()) + ", model " +
                                   std::string(skin::name_of(arguments.molecule.model)) +
                                   ", radii " + brief(radii.smallest) + " to " +
                                   brief(radii.largest) + " A");
  }
  return ExitCode::Success;
}

}  // namespace morskin::app

#include <iostream>

#include "app/commands.h"
#include "app/molecule_input.h"
#include "app/report.h"
#include "app/staged_outputs.h"

namespace morskin::app {

ExitCode balls_command(const BallsArguments& arguments) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(arguments.output, ignored) &&
      std::filesystem::equivalent(arguments.molecule.input, arguments.output, ignored)) {
    throw UsageError("the output would replace the input; choose another name");
  }
  const MoleculeInput input = read_input(arguments.molecule);
  const std::string text = skin::xyzr_text(input.points);
  StagedOutputs outputs({arguments.output});
  for (geometry::PendingFile& file : outputs.files()) {
    file.write(text);
    file.commit();
  }
  for (const std::filesystem::path& path : outputs.direct())
    geometry::write_file_atomically(path, text);
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

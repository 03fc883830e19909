#include "app/commands.h"
#include "app/figures/figures.h"
#include "app/pictures/png.h"
#include "app/staged_outputs.h"

namespace morskin::app {

ExitCode figure_command(const FigureArguments& arguments) {
  StagedOutputs outputs({arguments.output});
  write_to_all(outputs, pictures::png(figures::find_figure(arguments.name)->draw(arguments.scale)));
  return ExitCode::Success;
}

}  // namespace morskin::app

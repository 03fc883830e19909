#include "app/commands.h"
#include "app/complex_files.h"
#include "app/function_argument.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/staged_outputs.h"
#include "morskin/traced_complex.h"

namespace morskin::app {
namespace {

morse::Simplification simplified(const morse::MorseSmaleComplex& complex,
                                 const MorseArguments& arguments, double radius_share) {
  switch (arguments.simplify) {
    case Simplify::Not:
      break;
    case Simplify::BySpheres:
      return morse::contract_short_arcs(complex, radius_share);
    case Simplify::ByPersistence:
      return morse::cancel_up_to(complex, arguments.persistence, radius_share);
  }
  return morse::keep_all(complex, radius_share);
}

std::string people_text(const ComplexReport& report, const MoleculeInput& input) {
  const MorseArguments& asked = report.arguments;
  const morse::Simplification& left = report.simplified;
  const morskin::CriticalCounts after = counts_after(report);
  std::string text = asked.molecule.input.string() + " -> " + asked.output.string() + "\n";
  text += line("atoms", grouped(input.molecule.atoms.size()) + " used, model " +
                            std::string(skin::name_of(asked.molecule.model)));
  text += line("function", in_words(report.function));
  text += line("traced", critical_text(counts_before(report)) + ", " +
                             counted(report.arcs, "arc", "arcs") + ", " +
                             counted(report.regions, "region", "regions"));
  if (asked.simplify != Simplify::Not) {
    text += line("cancelled", counted(left.cancelled.size(), "pair", "pairs"));
    text += line("left", critical_text(after) + ", " +
                             counted(left.complex.arcs.size(), "arc", "arcs") + ", " +
                             counted(left.complex.regions.size(), "region", "regions"));
  }
  text += line("spheres", counted(left.overlaps_before, "overlap", "overlaps") +
                              " of protecting spheres, " + grouped(left.overlaps_left) + " left; " +
                              counted(left.shrunk, "radius", "radii") + " shrunk");
  text += line("topology", counted(left.complex.components, "component", "components") +
                               ", Euler characteristic " +
                               grouped(static_cast<long long>(euler_characteristic(after))));
  return text;
}

}  // namespace

ExitCode morse_command(const MorseArguments& arguments) {
  const MoleculeInput input = read_input(arguments.molecule);
  if (!arguments.quiet) {
    note_rounded_coordinates(input);
    note_unused(arguments.molecule, input);
  }
  StagedOutputs outputs({arguments.output});
  ProgressLine progress(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::PreparedSkin skin = prepare_skin(input);
  const auto [function, complex] = along_function(arguments.function, [&] {
    return trace_complex(skin, arguments.function, Run(1, progress.callback()));
  });

  progress.show("simplify", geometry::unknown_share);
  ComplexReport report;
  report.arguments = arguments;
  report.function = function;
  report.arcs = complex.arcs.size();
  report.regions = complex.regions.size();
  report.pairs = morse::persistence_pairs(complex);
  report.radius_share = certify::Sizing{}.tangent_disk_share();
  report.simplified = simplified(complex, arguments, report.radius_share);
  for (const morse::CriticalPoint& p : complex.points) {
    report.dimension.push_back(skin.surface.complex().dimension(p.point.cell));
  }

  progress.show("write", geometry::unknown_share);
  const bool is_vtu = complex_format_of(arguments.output) == ComplexFormat::Vtu;
  write_to_all(outputs, is_vtu ? complex_vtu(report) : complex_json(report));
  progress.wipe();
  if (!arguments.quiet) print_beside(arguments.output, people_text(report, input));
  return ExitCode::Success;
}

}  // namespace morskin::app

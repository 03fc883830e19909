#include <iostream>

#include "app/commands.h"
#include "app/complex_files.h"
#include "app/function_argument.h"
#include "app/molecule_input.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/staged_outputs.h"
#include "geometry/error.h"
#include "morse/choose_function.h"
#include "morse/validate_complex.h"

namespace morskin::app {
namespace {

struct Traced {
  morse::MorseFunction function;
  morse::MorseSmaleComplex complex;
};

// The objections to a complex: its own degeneracies, a number of components that is not the skin's,
// or a broken law.
std::optional<std::string> objection_to(const morse::MorseSmaleComplex& complex,
                                        const skin::DualComplex& topology) {
  if (!complex.degeneracies.empty()) return complex.degeneracies.front();
  if (complex.components != topology.skin_components()) {
    return "the arcs join " + std::to_string(complex.components) + " components, not " +
           std::to_string(topology.skin_components());
  }
  return morse::validate(complex);
}

Traced trace(const morskin::PreparedSkin& skin, const MorseArguments& arguments,
             ProgressLine& progress) {
  Traced traced;
  progress.show("critical points", geometry::unknown_share);
  try {
    const morse::ChosenFunction choice =
        morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(),
                               arguments.function, [&](const morse::ChosenFunction& candidate) {
                                 progress.show("integral lines", geometry::unknown_share);
                                 traced.complex = morse::morse_smale_complex(
                                     skin.surface, candidate.function, candidate.critical);
                                 return objection_to(traced.complex, skin.topology);
                               });
    traced.function = choice.function;
  } catch (const morse::DegenerateFunction& error) {
    // The exit code depends on whether the user chose the function.
    if (arguments.function) throw UsageError(error.what());
    throw;
  }
  return traced;
}

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

std::string counts_text(const CriticalCounts& counts) {
  return counted(counts.minima, "minimum", "minima") + " - " +
         counted(counts.saddles, "saddle", "saddles") + " + " +
         counted(counts.maxima, "maximum", "maxima");
}

std::string people_text(const ComplexReport& report, const MoleculeInput& input) {
  const MorseArguments& asked = report.arguments;
  const morse::Simplification& left = report.simplified;
  const CriticalCounts after = counts_after(report);
  std::string text = asked.molecule.input.string() + " -> " + asked.output.string() + "\n";
  text += line("atoms", grouped(input.molecule.atoms.size()) + " used, model " +
                            std::string(skin::name_of(asked.molecule.model)));
  text += line("function", in_words(report.function));
  text += line("traced", counts_text(counts_before(report)) + ", " +
                             counted(report.arcs, "arc", "arcs") + ", " +
                             counted(report.regions, "region", "regions"));
  if (asked.simplify != Simplify::Not) {
    text += line("cancelled", counted(left.cancelled.size(), "pair", "pairs"));
    text +=
        line("left", counts_text(after) + ", " + counted(left.complex.arcs.size(), "arc", "arcs") +
                         ", " + counted(left.complex.regions.size(), "region", "regions"));
  }
  text += line("spheres", counted(left.overlaps_before, "overlap", "overlaps") +
                              " of protecting spheres, " + grouped(left.overlaps_left) + " left; " +
                              counted(left.shrunk, "radius", "radii") + " shrunk");
  text += line("topology", counted(left.complex.components, "component", "components") +
                               ", Euler characteristic " +
                               grouped(static_cast<long long>(after.euler_characteristic())));
  return text;
}

}  // namespace

ExitCode morse_command(const MorseArguments& arguments) {
  const MoleculeInput input = read_input(arguments.molecule);
  StagedOutputs outputs({arguments.output});
  ProgressLine progress(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::PreparedSkin skin = prepare_skin(input);
  const Traced traced = trace(skin, arguments, progress);

  progress.show("simplify", geometry::unknown_share);
  ComplexReport report;
  report.arguments = arguments;
  report.function = traced.function;
  report.arcs = traced.complex.arcs.size();
  report.regions = traced.complex.regions.size();
  report.pairs = morse::persistence_pairs(traced.complex);
  report.radius_share = certify::Sizing{}.tangent_disk_share();
  report.simplified = simplified(traced.complex, arguments, report.radius_share);
  for (const morse::CriticalPoint& p : traced.complex.points) {
    report.dimension.push_back(skin.surface.complex().dimension(p.point.cell));
  }

  progress.show("write", geometry::unknown_share);
  const bool is_vtu = complex_format_of(arguments.output) == ComplexFormat::Vtu;
  write_to_all(outputs, is_vtu ? complex_vtu(report) : complex_json(report));
  progress.wipe();
  if (!arguments.quiet) {
    const bool is_taken = arguments.output == "-" || arguments.output == "/dev/stdout";
    (is_taken ? std::cerr : std::cout) << people_text(report, input);
  }
  return ExitCode::Success;
}

}  // namespace morskin::app

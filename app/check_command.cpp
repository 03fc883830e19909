#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/certificate_file.h"
#include "app/check_report.h"
#include "app/commands.h"
#include "app/limits.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/percent_encoding.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/staged_outputs.h"
#include "app/stated_skin.h"
#include "app/surface_input.h"
#include "app/surface_report.h"
#include "certify/located_vertices.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"
#include "morskin/implicit_mesh.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;

constexpr std::size_t max_triangles = geometry::SurfaceMesh::max_triangles;

/// What does not need the surface's topology. @pre result has the certificate
void measure(AgainstSkin& result, const geometry::MeshFile& file, const surface::Surface& surface,
             std::span<const surface::SurfacePoint> points, const certify::Sizing& sizing,
             const morskin::Run& run) {
  const certify::EdgeSides sides = result.certificate.holds(certify::Claim::Manifold)
                                       ? certify::EdgeSides()
                                       : certify::EdgeSides(file.mesh.triangles);
  result.deviations = certify::measure_deviations(file.mesh, surface, points, sizing, sides);
  result.delaunay = certify::restricted_delaunay(file.mesh, surface, points, 10, run);
  if (!file.curved) return;
  result.in_edges = certify::node_residuals(*file.curved, file.mesh.positions.size(), surface, run);
}

/// @param certificate  for the file's text, if one is asked for
AgainstSkin check_against(const geometry::MeshFile& file, const geometry::MeshCheck& topology,
                          const MoleculeInput& input, const CheckArguments& arguments,
                          std::string& certificate, const morskin::Run& run) {
  const IndexedMesh& mesh = file.mesh;
  const morskin::PreparedSkin skin = prepare_skin(input, *arguments.against, run);
  const auto points =
      run.stage("locate", [&] { return certify::locate_vertices(mesh, skin.surface, run); });
  AgainstSkin result;
  const std::vector<surface::CellId> cells = certify::cells_of(points);
  result.certificate = run.stage("certify", [&] {
    return certify::certify(mesh, {{}, cells}, skin.surface, skin.expected(), arguments.sizing,
                            run);
  });
  run.stage("measure", [&] { measure(result, file, skin.surface, points, arguments.sizing, run); });
  result.covered = covered_components(input, skin, mesh, topology, points);
  if (arguments.certificate) {
    certificate =
        certificate_text(mesh, points, result.certificate.degree_vertices, skin, arguments.sizing);
  }
  return result;
}

/// A surface that is no skin.
struct GivenSurface {
  GivenSurface(const std::string& text, const morskin::Run& run)
      : input(read_surface(text)), prepared(prepare_surface(input, std::nullopt, run)) {}

  SurfaceInput input;
  implicit::PreparedSurface prepared;
};

/// Of a mesh file's statement: no device or pipe is read because the file says so.
void check_stated_file(const std::string& surface) {
  const std::optional<std::filesystem::path> file = molecule_of_surface(surface);
  std::error_code ignored;
  if (!file || std::filesystem::is_regular_file(*file, ignored)) return;
  throw geometry::UnreadableInput(file->string() + ": is no file that is there");
}

/// The surface given or, where there is neither one nor a molecule, the one that the mesh file
/// states. The statement may be wrong in any way; then the report says so.
std::optional<GivenSurface> surface_of(CheckArguments& arguments, OriginReport& origin,
                                       const morskin::Run& run) {
  if (arguments.surface) return GivenSurface(*arguments.surface, run);
  const std::optional<std::string> encoded = stated(origin.stated, "surface");
  const auto text = encoded && !arguments.against ? percent_decoded(*encoded) : std::nullopt;
  if (!text) return std::nullopt;
  const auto refuse = [&](const std::exception& error) {
    origin.not_taken.push_back("surface: " + std::string(error.what()));
    return std::nullopt;
  };
  try {
    check_stated_file(*text);
    GivenSurface surface(*text, run);
    arguments.surface = text;
    origin.taken.emplace_back("surface");
    return surface;
  } catch (const UsageError& error) {
    return refuse(error);
  } catch (const geometry::UnreadableInput& error) {
    return refuse(error);
  } catch (const geometry::RefusedInput& error) {
    return refuse(error);
  }
}

/// -C, -Q and --size where none is given.
void take_stated_sizes(CheckArguments& arguments, OriginReport& origin) {
  geometry::Provenance of_sizes;
  for (const auto& entry : origin.stated.entries) {
    if (entry.key == "C" || entry.key == "Q" || entry.key == "size") {
      of_sizes.entries.push_back(entry);
    }
  }
  StatedSkin all = completed(arguments.typed, of_sizes);
  try {
    certify::Sizing sizing;
    finish(sizing, all.typed, sizing.C);
    arguments.sizing = sizing;
    origin.taken.insert(origin.taken.end(), all.taken.begin(), all.taken.end());
  } catch (const UsageError& error) {
    origin.not_taken.emplace_back(error.what());
  }
}

AgainstSkin check_surface(const geometry::MeshFile& file, const implicit::PreparedSurface& prepared,
                          const CheckArguments& arguments, const morskin::Run& run) {
  const IndexedMesh& mesh = file.mesh;
  const auto points =
      run.stage("locate", [&] { return certify::locate_vertices(mesh, prepared.surface, run); });
  const std::vector<surface::CellId> cells = certify::cells_of(points);
  AgainstSkin result;
  result.certificate = run.stage("certify", [&] {
    return morskin::certify_implicit(mesh, {{}, cells}, prepared, arguments.sizing, run);
  });
  result.certificate.reason = about_surface(result.certificate.reason);
  run.stage("measure",
            [&] { measure(result, file, prepared.surface, points, arguments.sizing, run); });
  result.covered = components_by_minima(mesh, prepared);
  result.within = searched_within(*arguments.surface, prepared);
  return result;
}

/// Of the models but the one taken, that to whose skin the mesh is homeomorphic.
std::optional<skin::Model> fitting_model(const IndexedMesh& mesh, const CheckArguments& arguments,
                                         const morskin::Run& run) {
  MoleculeArguments other = *arguments.against;
  for (const skin::Model model :
       {skin::Model::Vdw, skin::Model::Sas, skin::Model::Paper, skin::Model::SesLike}) {
    if (model == arguments.against->model) continue;
    other.model = model;
    try {
      const morskin::PreparedSkin skin = prepare_skin(read_input(other), other, run);
      const certify::Certificate found = run.stage("try other models", [&] {
        return certify::certify(mesh, skin.surface, skin.expected(), arguments.sizing, run);
      });
      if (found.is_homeomorphic) return model;
    } catch (const geometry::RefusedInput&) {
      // A skin that is singular, or of weights out of range, is not this mesh's.
    }
  }
  return std::nullopt;
}

/// The least C, to three digits, with which [U] holds, if there is one up to the coarsest.
/// @param Q  as given; else it goes with C
std::optional<double> fitting_C(double worst_U, const certify::Sizing& sizing,
                                std::optional<double> Q) {
  constexpr double step = 0.001;
  for (double C = sizing.C + step; C <= certify::Sizing::coarsest_C + step / 2; C += step) {
    const double allowed = C * Q.value_or(certify::Sizing::quality_for(C));
    if (worst_U * sizing.C * sizing.Q < allowed) return C;
  }
  return std::nullopt;
}

/// Looks for the model or C that was meant, where none was given and the default does not fit.
void find_what_fits(const IndexedMesh& mesh, const CheckArguments& arguments, CheckReport& report,
                    const morskin::Run& run) {
  const certify::Certificate& certificate = report.against->certificate;
  const bool is_of_weights = arguments.against->model == skin::Model::Given;
  if (!arguments.typed.model && !is_of_weights && !certificate.is_homeomorphic &&
      report.topology.is_closed_oriented_manifold()) {
    report.fitting_model = fitting_model(mesh, arguments, run);
  }
  if (!arguments.typed.C && !arguments.typed.size && certificate.is_homeomorphic &&
      certificate.violations_U > 0) {
    report.fitting_C = fitting_C(certificate.worst_U, arguments.sizing, arguments.typed.Q);
  }
}

/// Two proofs of one thing: with (c1) and (c2), an embedded mesh with one component on each of the
/// skin's is homeomorphic, and one that is homeomorphic is embedded.
/// @throws std::logic_error  where they contradict each other
void check_agreement(const CheckReport& report) {
  if (!report.against || !report.against->certificate.is_homeomorphic) return;
  if (report.intersections && report.intersections->count > 0) {
    throw std::logic_error("a mesh proved homeomorphic to the skin intersects itself");
  }
  const auto& covered = report.against->covered;
  if (!std::ranges::all_of(covered, [](const auto& c) { return c.is_well(); })) {
    throw std::logic_error(
        "a mesh proved homeomorphic to the skin has others of its components than it should");
  }
}

/// All that is told of the mesh alone.
void check_alone(CheckReport& report, const geometry::MeshFile& file, const morskin::Run& run) {
  const CheckArguments& arguments = report.arguments;
  const IndexedMesh& mesh = file.mesh;
  run.stage("measure", [&] {
    report.origin.compare_mesh(file, arguments.threads);
    measure_mesh(report, mesh);
    if (file.curved) report.curved = curved_report(*file.curved);
  });
  if (!arguments.self_intersections) return;
  run.stage("self-intersections",
            [&] { report.intersections = geometry::self_intersections(mesh); });
}

/// What needs the molecule, with what the mesh file states where no option is given.
/// @param certificate  for the file's text, if one is asked for
void check_against_molecule(CheckReport& report, const geometry::MeshFile& file,
                            std::string& certificate, const morskin::Run& run,
                            ProgressLine& progress) {
  CheckArguments& arguments = report.arguments;
  StatedMolecule stated =
      read_stated(*arguments.against, arguments.sizing, arguments.typed, report.origin.stated);
  arguments.against = std::move(stated.molecule);
  arguments.sizing = stated.sizing;
  report.origin.taken = std::move(stated.taken);
  report.origin.not_taken = std::move(stated.not_taken);
  report.origin.compare_input(stated.input.sha256);
  progress.wipe();
  note_rounded_coordinates(stated.input);
  if (is_of_molecules(arguments.typed)) note_unused(*arguments.against, stated.input);
  report.against = check_against(file, report.topology, stated.input, arguments, certificate, run);
  find_what_fits(file.mesh, arguments, report, run);
}

}  // namespace

ExitCode check_command(const CheckArguments& asked) {
  const geometry::Stopwatch stopwatch;
  TimeLimit time_limit(asked.limits, asked.mesh);
  std::optional<StagedOutputs> outputs;
  if (asked.certificate) outputs.emplace(std::vector{*asked.certificate});
  std::string certificate;
  CheckReport report;
  CheckArguments& arguments = report.arguments = asked;
  ProgressLine progress(arguments.progress);
  const morskin::Run run(arguments.threads, progress.callback());
  geometry::MeshFile file =
      run.stage("read", [&] { return geometry::read_mesh_file(arguments.mesh); });
  if (file.mesh.triangles.size() > max_triangles) {
    throw geometry::UnreadableInput(arguments.mesh.string() + ": has more than " +
                                    std::to_string(max_triangles) + " triangles; cut it up");
  }
  report.origin.stated = std::move(file.provenance);
  if (!arguments.against && !arguments.surface && is_set(arguments.typed) &&
      !stated(report.origin.stated, "surface")) {
    throw UsageError("-C, -Q and --size are of a mesh and its surface: add --against or --surface");
  }
  check_alone(report, file, run);
  if (arguments.against) check_against_molecule(report, file, certificate, run, progress);
  if (const std::optional<GivenSurface> surface = surface_of(arguments, report.origin, run)) {
    take_stated_sizes(arguments, report.origin);
    report.origin.compare_input(surface->input.sha256);
    report.against = check_surface(file, surface->prepared, arguments, run);
  }
  if (report.against) {  // as in JSON, where coordinates are extreme too
    report.against->certificate.area = report.shape.area;
    report.against->certificate.volume = report.shape.volume;
  }
  check_agreement(report);
  time_limit.cancel();
  progress.wipe();
  if (outputs) write_to_all(*outputs, certificate);  // last, for a limit leaves no file
  report.seconds = stopwatch.seconds();
  print_beside(arguments.certificate.value_or(""),
               arguments.json ? json_text(report) : people_text(report));
  const std::vector<Verdict> verdicts = report.verdicts();
  const bool passes =
      std::ranges::all_of(verdicts, [](const Verdict& v) { return v.holds || !v.is_required; });
  return passes ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app

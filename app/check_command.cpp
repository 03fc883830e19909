#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

#include "app/certificate_file.h"
#include "app/check_report.h"
#include "app/commands.h"
#include "app/limits.h"
#include "app/molecule_input.h"
#include "app/report.h"
#include "app/staged_outputs.h"
#include "certify/located_vertices.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using skin::SkinComponents;

constexpr std::size_t max_triangles = geometry::SurfaceMesh::max_triangles;

// The mesh's components on each of the skin's: by their first vertex, and by the sign of their
// volume, which is negative in a void. Empty if rounding makes the skin's indistinguishable.
std::vector<CoveredComponent> covered_components(const MoleculeInput& input,
                                                 const morskin::PreparedSkin& skin,
                                                 const IndexedMesh& mesh,
                                                 const geometry::MeshCheck& topology,
                                                 std::span<const surface::SurfacePoint> points) {
  const SkinComponents parts(skin.surface);
  if (parts.body_count() != skin.topology.betti[0] ||
      parts.void_count() != skin.topology.betti[2]) {
    return {};
  }
  std::vector<CoveredComponent> covered;
  for (std::uint32_t body = 0; body < parts.body_count(); ++body) {
    covered.push_back(
        {"the outer surface of the body with " + skin::describe(input.molecule, parts.atom(body)),
         {}});
  }
  for (std::uint32_t cavity = 0; cavity < parts.void_count(); ++cavity) {
    const geometry::Point& at = parts.centre(cavity);
    covered.push_back(
        {"the wall of the void at " + brief(at.x()) + " " + brief(at.y()) + " " + brief(at.z()),
         {}});
  }
  for (std::uint32_t c = 0; c < topology.components.size(); ++c) {
    const geometry::MeshComponent& component = topology.components[c];
    const auto sides = parts.sides(points[mesh.triangles[component.first_triangle][0]]);
    if (!sides) return {};
    const bool is_cavity = component.volume < 0 && sides->cavity;
    covered[is_cavity ? parts.body_count() + *sides->cavity : sides->body].by.push_back(c);
  }
  return covered;
}

// Writes the certificate file too, if one is asked for.
AgainstSkin check_against(const IndexedMesh& mesh, const geometry::MeshCheck& topology,
                          const CheckArguments& arguments) {
  std::vector<std::filesystem::path> names;
  if (arguments.certificate) names.push_back(*arguments.certificate);
  StagedOutputs outputs(names);
  const MoleculeInput input = read_input(*arguments.against);
  const morskin::Run run(arguments.threads);
  const morskin::PreparedSkin skin = prepare_skin(input, run);
  const auto points = certify::locate_vertices(mesh, skin.surface);
  AgainstSkin result;
  const std::vector<surface::CellId> cells = certify::cells_of(points);
  result.certificate =
      certify::certify(mesh, {{}, cells}, skin.surface, skin.topology, arguments.sizing, run);
  result.deviations = certify::measure_deviations(mesh, skin.surface, points, arguments.sizing);
  result.delaunay = certify::restricted_delaunay(mesh, skin.surface, points, 10, run);
  result.covered = covered_components(input, skin, mesh, topology, points);
  if (arguments.certificate) {
    write_to_all(outputs, certificate_text(mesh, points, result.certificate.degree_vertices,
                                           skin.surface, arguments.sizing));
  }
  return result;
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
  if (!std::ranges::all_of(covered, [](const auto& c) { return c.by.size() == 1; })) {
    throw std::logic_error("a mesh proved homeomorphic to the skin misses a component of it");
  }
}

}  // namespace

ExitCode check_command(const CheckArguments& arguments) {
  const geometry::Stopwatch stopwatch;
  const TimeLimit time_limit(arguments.limits, arguments.mesh);
  const IndexedMesh mesh = geometry::read_mesh(arguments.mesh);
  if (mesh.triangles.size() > max_triangles) {
    throw geometry::UnreadableInput(arguments.mesh.string() + ": has more than " +
                                    std::to_string(max_triangles) + " triangles; cut it up");
  }
  CheckReport report;
  report.arguments = arguments;
  report.vertices = mesh.positions.size();
  report.triangles = mesh.triangles.size();
  report.shape = geometry::measure_shape(mesh);
  report.angles = geometry::angle_histogram(mesh);
  report.quality = certify::measure_quality(mesh, morskin::Run(arguments.threads));
  report.topology = geometry::check_mesh(mesh);
  if (arguments.self_intersections) report.intersections = geometry::self_intersections(mesh);
  if (arguments.against) report.against = check_against(mesh, report.topology, arguments);
  check_agreement(report);
  report.seconds = stopwatch.seconds();
  std::cout << (arguments.json ? json_text(report) : people_text(report));
  const std::vector<Verdict> verdicts = report.verdicts();
  const bool passes =
      std::ranges::all_of(verdicts, [](const Verdict& v) { return v.holds || !v.is_required; });
  return passes ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app

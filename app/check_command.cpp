#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/molecule_input.h"
#include "app/report.h"
#include "geometry/mesh_files.h"
#include "geometry/surface_mesh.h"
#include "refine/triangle_geometry.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::Point;
using nlohmann::ordered_json;

void print(const ordered_json& json) {
  std::cout << json.dump(2, ' ', false, ordered_json::error_handler_t::replace) << "\n";
}

ExitCode check_against(const IndexedMesh& mesh, const CheckArguments& arguments) {
  const MoleculeInput input = read_input(*arguments.against);
  const front::PreparedSkin skin = prepare_skin(input);
  const refine::Certificate certificate =
      refine::certify(mesh, skin.surface, skin.topology, arguments.sizing);
  if (arguments.json) {
    ordered_json json = {{"mesh", arguments.mesh.string()},
                         {"input", arguments.against->input.string()},
                         {"model", skin::name_of(arguments.against->model)},
                         {"probe", arguments.against->probe},
                         {"C", arguments.sizing.C},
                         {"Q", arguments.sizing.Q}};
    json.update(certificate_json(certificate));
    print(json);
  } else {
    std::cout << arguments.mesh.string() << " against " << arguments.against->input.string() << "\n"
              << certificate_text(certificate, arguments.sizing)
              << (certificate.certified ? "certified: homeomorphic to the skin, [L] and [U] hold\n"
                                        : "NOT certified: " + certificate.reason + "\n");
  }
  return certificate.certified ? ExitCode::Success : ExitCode::NotCertified;
}

// What a mesh shows without the surface that it should be of.
struct Shape {
  std::size_t vertices = 0, triangles = 0, components = 0;
  long euler_characteristic = 0;
  double min_angle_deg = 180, max_angle_deg = 0;
  double area = 0, volume = 0;
  std::optional<std::string> defect;  ///< why it is not a closed oriented 2-manifold

  /// Summed over the components. @pre !defect
  long genus() const { return static_cast<long>(components) - euler_characteristic / 2; }
};

Shape shape_of(const IndexedMesh& mesh) {
  Shape shape;
  shape.vertices = mesh.positions.size();
  shape.triangles = mesh.triangles.size();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    const refine::AngleRange angles = refine::angle_range(p, q, r);
    shape.min_angle_deg = std::min(shape.min_angle_deg, angles.smallest_deg);
    shape.max_angle_deg = std::max(shape.max_angle_deg, angles.largest_deg);
    shape.area += (q - p).cross(r - p).norm() / 2;
    shape.volume += p.dot(q.cross(r)) / 6;
  }
  geometry::MeshOrDefect built = geometry::closed_mesh(shape.vertices, mesh.triangles);
  shape.defect = std::move(built.defect);
  if (mesh.triangles.empty()) shape.defect = "there are no triangles";
  if (!shape.defect) {
    shape.components = geometry::components(built.mesh).count;
    // Every edge has two triangles, so V - E + F = V - F / 2.
    shape.euler_characteristic =
        static_cast<long>(shape.vertices) - static_cast<long>(shape.triangles) / 2;
  }
  return shape;
}

void print_json(const Shape& shape, const CheckArguments& arguments) {
  ordered_json json = {{"mesh", arguments.mesh.string()},
                       {"vertices", shape.vertices},
                       {"triangles", shape.triangles},
                       {"closed_oriented_manifold", !shape.defect}};
  if (shape.defect) {
    json["reason"] = *shape.defect;
  } else {
    json["components"] = shape.components;
    json["euler_characteristic"] = shape.euler_characteristic;
    json["genus"] = shape.genus();
  }
  json["min_angle_deg"] = shape.min_angle_deg;
  json["max_angle_deg"] = shape.max_angle_deg;
  json["area"] = rounded(shape.area, 12);
  json["volume"] = rounded(shape.volume, 12);
  print(json);
}

void print_text(const Shape& shape, const CheckArguments& arguments) {
  std::cout << arguments.mesh.string() << "\n"
            << line("mesh", grouped(shape.triangles) + " triangles, " + grouped(shape.vertices) +
                                " vertices")
            << line("manifold",
                    shape.defect ? "NO: " + *shape.defect : std::string("closed, oriented"));
  if (!shape.defect) {
    std::cout << line("topology", counted(shape.components, "component", "components") +
                                      ", genus " + grouped(static_cast<long long>(shape.genus())) +
                                      ", Euler characteristic " +
                                      grouped(static_cast<long long>(shape.euler_characteristic)));
  }
  std::cout << line("angles",
                    brief(shape.min_angle_deg) + " to " + brief(shape.max_angle_deg) + " degrees")
            << line("extent", "area " + brief(shape.area, 6) + " A^2, volume " +
                                  brief(shape.volume, 6) + " A^3")
            << "nothing was said about the surface; --against INPUT runs the certificate\n";
}

}  // namespace

ExitCode check_command(const CheckArguments& arguments) {
  const IndexedMesh mesh = geometry::read_mesh(arguments.mesh);
  if (arguments.against) return check_against(mesh, arguments);
  const Shape shape = shape_of(mesh);
  if (arguments.json) {
    print_json(shape, arguments);
  } else {
    print_text(shape, arguments);
  }
  return shape.defect ? ExitCode::NotCertified : ExitCode::Success;
}

}  // namespace morskin::app

// What `check` measures of a mesh, whatever the size of its coordinates.

#include <cmath>

#include "app/check_report.h"
#include "geometry/run.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;

/// Of the largest coordinate the power of two, where the squares and cubes of lengths like it leave
/// the range of doubles; else 0.
int extreme_exponent(const IndexedMesh& mesh) {
  constexpr int usual = 200;
  double largest = 0;
  for (const geometry::Point& p : mesh.positions) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) > usual ? exponent : 0;
}

IndexedMesh scaled(const IndexedMesh& mesh, int exponent) {
  IndexedMesh result = mesh;
  for (geometry::Point& p : result.positions) {
    for (double& x : p) x = std::ldexp(x, exponent);
  }
  return result;
}

void measure_shapes(CheckReport& report, const IndexedMesh& mesh) {
  report.shape = geometry::measure_shape(mesh);
  report.angles = geometry::angle_histogram(mesh);
  report.quality = certify::measure_quality(mesh, geometry::Run(report.arguments.threads));
}

/// Lengths, areas and volumes of a mesh that was scaled, as they were.
void scale_back(CheckReport& report, int exponent) {
  auto& [short_end, median, long_end] = report.quality.edges;
  for (double* const length : {&short_end, &median, &long_end}) {
    *length = std::ldexp(*length, exponent);
  }
  report.shape.area = std::ldexp(report.shape.area, 2 * exponent);
  report.shape.volume = std::ldexp(report.shape.volume, 3 * exponent);
  for (geometry::MeshComponent& component : report.topology.components) {
    component.area = std::ldexp(component.area, 2 * exponent);
    component.volume = std::ldexp(component.volume, 3 * exponent);
  }
}

}  // namespace

void measure_mesh(CheckReport& report, const IndexedMesh& mesh) {
  report.vertices = mesh.positions.size();
  report.triangles = mesh.triangles.size();
  report.topology = geometry::check_mesh(mesh);
  const int exponent = extreme_exponent(mesh);
  if (exponent == 0) return measure_shapes(report, mesh);
  const IndexedMesh usual = scaled(mesh, -exponent);
  measure_shapes(report, usual);
  // Defects are those of the mesh itself, for small coordinates beside large ones may be rounded.
  report.topology.components = geometry::check_mesh(usual).components;
  scale_back(report, exponent);
}

}  // namespace morskin::app

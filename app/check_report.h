#pragma once

/// The report of `morskin check` about a mesh, for people and for programs.

#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/covered_components.h"
#include "app/curved_report.h"
#include "app/molecule_input.h"
#include "app/origin_report.h"
#include "certify/certificate.h"
#include "certify/deviations.h"
#include "certify/mesh_quality.h"
#include "certify/restricted_delaunay.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_shape.h"
#include "geometry/self_intersections.h"

namespace morskin::app {

/// One condition. The reason names the first element that breaks it.
struct Verdict {
  std::string name;
  bool holds = true;
  std::string reason;
  bool is_required = true;  ///< whether the mesh fails if it is broken
};

/// The part of the report that needs the molecule.
struct AgainstSkin {
  certify::Certificate certificate;
  certify::Deviations deviations;
  certify::RestrictedDelaunay delaunay;
  std::vector<CoveredComponent> covered;  ///< empty if the components are indistinguishable
  std::optional<double> within;           ///< of a formula: searched_within()
  std::optional<certify::Residuals>
      in_edges;  ///< of the nodes in edges, where triangles are curved
};

struct CheckReport {
  CheckArguments arguments;  ///< completed by what was taken from the mesh file
  OriginReport origin;
  geometry::MeshShape shape;
  geometry::AngleHistogram angles{};
  certify::MeshQuality quality;
  geometry::MeshCheck topology;
  std::optional<geometry::SelfIntersections> intersections;  ///< nothing if not searched
  std::size_t vertices = 0, triangles = 0;
  std::optional<AgainstSkin> against;
  /// What the mesh fits, where it does not fit what was not given: another model, and the least C
  /// with which [U] holds.
  std::optional<skin::Model> fitting_model;
  std::optional<double> fitting_C;
  std::optional<CurvedReport> curved;  ///< where triangles are
  double seconds = 0;

  std::vector<Verdict> verdicts() const;
};

/// Fills in all that is measured of the mesh alone but where it crosses itself. Numbers that are no
/// doubles are infinite or 0.
void measure_mesh(CheckReport& report, const geometry::IndexedMesh& mesh);

/// As strict_json writes it.
std::string json_text(const CheckReport& report);
std::string people_text(const CheckReport& report);

}  // namespace morskin::app

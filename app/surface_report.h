#pragma once

/// What `mesh --surface` tells, for people and for programs.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "certify/mesh_quality.h"
#include "geometry/provenance.h"
#include "morskin/implicit_mesh.h"

namespace morskin::app {

/// What was proved of the surface before it was meshed.
struct SurfaceFacts {
  std::size_t boxes = 0;        ///< of the cover
  double hessian_bound = 0;     ///< M, of the levelled function
  double max_length_scale = 0;  ///< Angstrom
  std::size_t undecided = 0;    ///< boxes that may hold a critical point of the height
  morskin::CriticalCounts critical{};

  static SurfaceFacts of(const implicit::PreparedSurface& prepared);
};

/// How far from the axes' planes a formula was searched, Angstrom; nothing of other surfaces, of
/// which it is known that the cube that was searched holds all.
std::optional<double> searched_within(const std::string& surface,
                                      const implicit::PreparedSurface& prepared);
/// A line of a report, or nothing.
std::string searched_text(const std::optional<double>& within);

struct SurfaceReport {
  std::string surface;
  std::optional<double> within;  ///< searched_within()
  certify::Sizing sizing;
  SurfaceFacts facts;
  std::vector<std::filesystem::path> outputs;
  std::string certified_file;
  certify::Certificate certificate;
  certify::MeshQuality quality;
  morskin::RunCounts counts;
  geometry::Provenance provenance;
  double prepare_seconds = 0, mesh_seconds = 0, certify_seconds = 0, total_seconds = 0;
};

/// As strict_json writes it.
std::string json_text(const SurfaceReport& report);
std::string people_text(const SurfaceReport& report);

/// The same text of a surface that is no skin. What the certificate says is worded for skins.
std::string about_surface(std::string text);

/// The source of the expected numbers, in certificate_text().
inline constexpr std::string_view critical_points_say = "the critical points say";

}  // namespace morskin::app

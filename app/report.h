#pragma once

/// What the commands say about a mesh, for people and for programs.

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/curved_report.h"
#include "app/mesh_delivery.h"
#include "app/molecule_input.h"
#include "app/report_lines.h"
#include "app/skin_parts.h"
#include "bench/baselines/growth.h"
#include "certify/mesh_quality.h"
#include "geometry/provenance.h"
#include "morskin/bent_part.h"
#include "morskin/pipeline.h"
#include "skin/molecule.h"

namespace morskin::app {

/// Seconds by stage, by the wall clock.
struct RunSeconds {
  double read = 0, triangulate = 0, mixed_complex = 0, dual_complex = 0, voids = 0;
  double critical_points = 0;
  double sweep = 0;               ///< or what another method does in its place
  double refine = 0, smooth = 0;  ///< both with what they do for angles
  double write = 0, certify = 0;
  double describe = 0;  ///< what only the report needs: its quality, parts and sizes
  double total = 0;
};

/// Everything `morskin mesh` tells about a run. Every figure of the certificate was measured on the
/// bytes written.
struct MeshReport {
  MoleculeArguments molecule;
  std::optional<PresetUse> preset;
  certify::Sizing sizing;
  std::optional<morskin::BentPart> bent;  ///< where sizes are limited by length
  std::optional<morskin::Grading> grading;
  morskin::SizeGoal size_goal;  ///< what was asked for
  std::string radii;            ///< skin::Molecule::radii
  std::size_t atoms_used = 0;
  std::size_t atoms_hidden = 0;  ///< of those used, without a power cell
  skin::ReadingCounts reading;
  std::size_t rounded_coordinates = 0;  ///< MoleculeInput::rounded_coordinates
  SkinParts parts;
  double patch_radius_min = 0, patch_radius_max = 0;
  std::vector<std::filesystem::path> outputs;  ///< as they are named now
  geometry::Provenance provenance;             ///< with the hashes of doubles
  std::string certified_file;
  certify::Certificate certificate;
  certify::MeshQuality quality;
  MeshMethod method = MeshMethod::Sweep;  ///< used
  bool is_method_chosen = false;          ///< by the library
  morskin::RunCounts counts;
  std::optional<double> grid_step;                ///< of marching cubes, Angstrom
  std::optional<baselines::GrowthCounts> growth;  ///< of the dynamic method
  std::optional<CurvedReport> curved;             ///< where triangles are curved
  double angle_goal_deg = 0;
  std::vector<morskin::Fallback> fallbacks;
  RunSeconds seconds;
  double floor_seconds = 0;
  long long peak_memory_bytes = 0;

  double floor_ratio() const { return floor_seconds > 0 ? seconds.total / floor_seconds : 0; }
};

/// As strict_json writes it.
std::string json_text(const MeshReport& report);
nlohmann::ordered_json critical_json(const morskin::CriticalCounts& counts);

// report_text.cpp

/// A dozen aligned lines.
std::string people_text(const MeshReport& report);
/// "2 minima - 1 saddle + 1 maximum"
std::string critical_text(const morskin::CriticalCounts& counts);
/// What took a component's place, in words.
std::string replacement_text(const morskin::Fallback& fallback);

// certificate_report.cpp

/// What is not proved beforehand of such a C and Q, in a sentence; empty in the range of the
/// theory.
std::string doubts_about(const certify::Sizing& sizing);
/// "certified: " and what is proved of a certified mesh, in words.
std::string certified_text(const certify::Certificate& certificate);
/// What `morskin check --against` tells.
nlohmann::ordered_json certificate_json(const certify::Certificate& certificate);
/// Area and, of a closed oriented 2-manifold, volume.
std::string extent_text(double area, double volume, bool is_closed);
/// The same, triangles and vertices, angles.
std::string measures_text(const certify::Certificate& certificate, const certify::Sizing& sizing);
/// What else the certificate says.
/// @param source  of the numbers expected
std::string certificate_text(const certify::Certificate& certificate,
                             std::string_view source = "the dual complex says");
/// What a chemist asks of a mesh: its surfaces, measures_text(), whether it is proved.
std::string answers_text(const MeshReport& report);

// size_report.cpp

/// About how long edges are where the skin is flat, if that is limited.
void add_edge_length(nlohmann::ordered_json& json, const certify::Sizing& sizing);
/// What was asked of the sizes and not reached, how much of the skin bends too much, and how edges
/// grow; nothing where no size was asked for.
void add_sizes(nlohmann::ordered_json& json, const MeshReport& report);
std::string sizes_text(const MeshReport& report);
/// One line.
std::string brief_text(const MeshReport& report);

// quality_report.cpp

/// What both `mesh` and `check` tell of the distribution of angles, edges, valences and radius
/// ratios, and of density.
/// @param area  of the mesh, Angstrom^2
nlohmann::ordered_json quality_json(const certify::MeshQuality& quality, double area);
/// Three lines; none without triangles.
std::string quality_text(const certify::MeshQuality& quality, double area);

}  // namespace morskin::app

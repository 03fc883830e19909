#include "morskin/morskin.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact_range.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/text_lines.h"
#include "morskin/boundary.h"
#include "morskin/pipeline_parts.h"
#include "morskin/voids.h"
#include "skin/model.h"
#include "skin/molecule_files.h"
#include "skin/radii.h"

namespace morskin {

namespace {

// Not hidden by those below.
using morskin::inside;
using morskin::outside;

TriangleMesh outside(geometry::IndexedMesh mesh) {
  TriangleMesh result;
  result.triangles = std::move(mesh.triangles);
  result.vertices.reserve(mesh.positions.size());
  for (const geometry::Point& p : mesh.positions) result.vertices.push_back(outside(p));
  return result;
}

skin::ReadOptions inside(const ReadOptions& options) {
  skin::ReadOptions result;
  skin::Selection& selection = result.selection;
  selection.chains = options.chains;
  selection.waters = options.waters;
  selection.hetatms = options.hetatms;
  selection.all_locations = options.locations == "all";
  if (options.locations.size() == 1) {
    selection.location = options.locations.front();
  } else if (!selection.all_locations && options.locations != "likeliest") {
    throw geometry::RefusedInput("locations are likeliest, all or the letter of one, not " +
                                 geometry::quoted(options.locations));
  }
  selection.hydrogens = options.hydrogens;
  selection.model = options.model;
  selection.assembly = options.assembly;
  if (options.radii) result.radii = skin::radius_table(*options.radii);
  return result;
}

certify::Sizing sizing_of(const MeshOptions& options) {
  certify::Sizing sizing{options.C, options.Q.value_or(certify::Sizing::quality_for(options.C)),
                         options.max_length_scale};
  if (!options.edge_length) return sizing;
  require_sound({.sizing = sizing});  // or the length would be blamed for C or Q
  sizing.set_edge_length(*options.edge_length);
  const bool is_finite = std::isfinite(*options.edge_length);
  if (!is_finite || !(sizing.largest_length_scale >= certify::Sizing::min_size)) {
    throw geometry::RefusedInput("the length of edges is too small, or no finite number");
  }
  return sizing;
}

static_assert(MeshOptions::coarsest_C == certify::Sizing::coarsest_C);

/// @throws geometry::RefusedInput  if more than one thing limits the sizes of triangles
void require_one_size(const MeshOptions& options) {
  const bool is_limited = options.max_length_scale != MeshOptions().max_length_scale;
  const int sizes = is_limited + options.edge_length.has_value() + options.density.has_value() +
                    options.triangles.has_value();
  if (sizes > 1) {
    throw geometry::RefusedInput(
        "a mesh has a largest length scale, a length of edges, a density or a number of triangles: "
        "give one of them");
  }
}

std::string in_words(const Fallback& fallback) {
  const std::string part = "component " + std::to_string(fallback.component) + ": ";
  if (!fallback.replacement) return part + "nothing helped: " + fallback.reason;
  const bool is_sweep = fallback.replacement->method == Method::Sweep;
  return part + (is_sweep ? "swept another way: " : "meshed by the static method: ") +
         fallback.reason;
}

Error refused(std::size_t atom, const std::string& why) {
  return {Error::Kind::Refused,
          "atom " + std::to_string(atom) + " " + why,
          {static_cast<std::uint32_t>(atom)}};
}

/// @throws Error  Refused, with the atom
std::vector<geometry::WeightedPoint> weighted_points(std::span<const Atom> atoms,
                                                     const SkinOptions& options) {
  if (!(options.probe >= 0 && std::isfinite(options.probe))) {
    throw geometry::RefusedInput("the probe's radius must be finite and not below 0");
  }
  std::vector<geometry::WeightedPoint> points;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const Atom& atom = atoms[i];
    if (!(atom.radius > 0 && std::isfinite(atom.radius)))
      throw refused(i, "has no finite radius above 0");
    const geometry::WeightedPoint p{
        inside(atom.position), skin::weight(atom.radius, inside(options.model), options.probe)};
    const double largest = std::max(p.position.cwiseAbs().maxCoeff(), std::abs(p.weight));
    if (!(p.weight >= least_provable_weight)) {
      throw refused(i, "has so small a radius that nothing can be proved of its skin");
    }
    if (!p.position.allFinite() || !(largest <= geometry::largest_exact)) {
      throw refused(i,
                    "has a coordinate that is no number, or is too far out or too large: 2^30 "
                    "Angstrom, or Angstrom^2, is the limit");
    }
    points.push_back(p);
  }
  return points;
}

std::pair<PreparedSkin, std::size_t> prepared(std::span<const Atom> atoms,
                                              const SkinOptions& options, const Run& run) {
  if (atoms.empty()) throw geometry::RefusedInput("there are no atoms, and so there is no surface");
  std::vector<geometry::WeightedPoint> points = weighted_points(atoms, options);
  const std::size_t rounded = geometry::move_to_exact_grid(points);
  PreparedSkin skin = prepare_skin(std::move(points), run);
  drop_voids(skin, options.drop_voids_below, run);
  return {std::move(skin), rounded};
}

}  // namespace

skin::Model inside(Model model) {
  switch (model) {
    case Model::Sas:
      return skin::Model::Sas;
    case Model::Vdw:
      return skin::Model::Vdw;
    case Model::SesLike:
      return skin::Model::SesLike;
    case Model::Paper:
      return skin::Model::Paper;
  }
  throw geometry::RefusedInput("the model is none of Paper, Sas, Vdw and SesLike");
}

geometry::IndexedMesh inside(const TriangleMesh& mesh) {
  geometry::IndexedMesh result;
  result.positions.reserve(mesh.vertices.size());
  for (const Point& p : mesh.vertices) result.positions.push_back(inside(p));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.vertices.size()) continue;
      throw geometry::RefusedInput("triangle " + std::to_string(t) + " has a corner " +
                                   std::to_string(v) + ", but there are only " +
                                   std::to_string(mesh.vertices.size()) + " vertices");
    }
  }
  result.triangles = mesh.triangles;
  return result;
}

MeshingOptions inside(const MeshOptions& options) {
  require_one_size(options);
  if (options.method && *options.method != Method::Sweep && *options.method != Method::Static) {
    throw geometry::RefusedInput("the method is neither Sweep nor Static");
  }
  MeshingOptions result;
  result.sizing = sizing_of(options);
  result.size_goal = {options.density, options.triangles};
  result.grading = options.grading;
  result.angle_goal_deg = options.angle_goal_deg;
  result.method = options.method;
  result.fronts = options.fronts;
  if (options.direction) {
    result.function = morse::MorseFunction::height_along(inside(*options.direction));
  }
  return result;
}

Certificate outside(const certify::Certificate& c) {
  return {c.certified,
          c.is_homeomorphic,
          c.reason,
          c.components,
          c.genus,
          c.min_angle_deg,
          c.max_angle_deg,
          c.area,
          c.volume,
          c.max_distance_to_skin,
          c.violations_L + c.violations_U};
}

skin::Molecule read_with_radii(const std::filesystem::path& file, const ReadOptions& options) {
  skin::Molecule molecule = skin::read_molecule(file, inside(options));
  if (!molecule.weights.empty()) {
    throw geometry::RefusedInput(molecule.source + ": gives weights; Skin is made of radii");
  }
  return molecule;
}

std::vector<Atom> atoms_of(const skin::Molecule& molecule) {
  std::vector<Atom> atoms;
  for (const skin::Atom& atom : molecule.atoms) {
    atoms.push_back({outside(atom.position), atom.radius});
  }
  return atoms;
}

std::vector<std::pair<std::string, std::size_t>> left_out(const skin::ReadingCounts& counts) {
  return {{"other_chains", counts.other_chains}, {"waters", counts.waters},
          {"hetatms", counts.hetatms},           {"alternates", counts.alternates},
          {"hydrogens", counts.hydrogens},       {"zero_radii", counts.zero_radii},
          {"unknown_elements", counts.unknown}};
}

Molecule read_molecule_file(const std::filesystem::path& file, const ReadOptions& options) {
  return with_errors([&] {
    skin::Molecule molecule = read_with_radii(file, options);
    return Molecule{atoms_of(molecule), std::move(molecule.charges), left_out(molecule.counts)};
  });
}

std::vector<Atom> read_molecule(const std::filesystem::path& file, const ReadOptions& options) {
  return read_molecule_file(file, options).atoms;
}

std::optional<double> van_der_waals_radius(std::string_view element) {
  return skin::van_der_waals_radius(element);
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  return with_errors([&] { return outside(geometry::read_mesh(file)); });
}

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file) {
  with_errors([&] {
    const geometry::IndexedMesh written = inside(mesh);
    const std::optional<geometry::MeshFormat> format = geometry::mesh_format_of(file);
    const bool is_single = format && geometry::is_single(*format);
    constexpr double largest_single = std::numeric_limits<float>::max();
    const auto refuse = [](std::size_t v, const char* why) {
      throw geometry::RefusedInput("vertex " + std::to_string(v) + why);
    };
    for (std::size_t v = 0; v < written.positions.size(); ++v) {
      const geometry::Point& p = written.positions[v];
      if (!p.allFinite()) refuse(v, " is not finite");
      if (is_single && p.cwiseAbs().maxCoeff() > largest_single) {
        refuse(v, " is too far out for STL and GLB; use PLY");
      }
    }
    geometry::write_mesh(file, written);
  });
}

Skin::Skin(std::span<const Atom> atoms, const SkinOptions& options, const RunOptions& run)
    : prepared_(with_errors([&] {
        auto [skin, rounded] = prepared(atoms, options, inside(run));
        return std::make_shared<const Prepared>(Prepared{std::move(skin), rounded, options});
      })) {}

std::size_t Skin::rounded_coordinates() const { return prepared_->rounded_coordinates; }
std::size_t Skin::components() const { return prepared_->skin.expected().components; }
std::size_t Skin::genus() const { return prepared_->skin.expected().genus; }

SkinMesh Skin::mesh(const MeshOptions& options, const RunOptions& run) const {
  return with_errors(
      [&] { return SkinMesh(*this, make_mesh(prepared_->skin, inside(options), inside(run))); });
}

SkinMesh::SkinMesh(Skin skin, MeshResult made) : skin_(std::move(skin)) {
  const certify::Sizing& sizing = made.sizing;
  Made result{outside(std::move(made.mesh)),
              {.C = sizing.C, .Q = sizing.Q, .max_length_scale = sizing.largest_length_scale},
              outside(made.certificate),
              {}};
  for (const Fallback& f : made.fallbacks) result.fallbacks.push_back(in_words(f));
  made_ = std::make_shared<const Made>(std::move(result));
}

Certificate Skin::certify(const TriangleMesh& mesh, const MeshOptions& options,
                          const RunOptions& run) const {
  return with_errors([&] {
    const PreparedSkin& skin = prepared_->skin;
    const MeshingOptions asked =
        inside({.C = options.C, .Q = options.Q, .max_length_scale = options.max_length_scale});
    require_sound(asked);
    const Run steps = inside(run);
    return steps.stage("certify", [&] {
      return outside(
          certify::certify(inside(mesh), skin.surface, skin.expected(), asked.sizing, steps));
    });
  });
}

}  // namespace morskin

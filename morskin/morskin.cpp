#include "morskin/morskin.h"

#include <cmath>

#include "certify/located_vertices.h"
#include "geometry/exact_range.h"
#include "geometry/files/mesh_files.h"
#include "geometry/mesh_shape.h"
#include "morskin/pipeline.h"
#include "morskin/voids.h"
#include "skin/curvatures.h"
#include "skin/model.h"
#include "skin/molecule_files.h"
#include "skin/singular_skin.h"

namespace morskin {

namespace {

/// Does a piece of work; whatever it throws comes out as an Error.
template <class Work>
auto with_errors(Work work) {
  using Kind = Error::Kind;
  try {
    return work();
  } catch (const skin::SingularSkin& error) {
    std::vector<std::uint32_t> atoms;
    for (const geometry::AtomId id : error.atoms) atoms.push_back(id.value);
    throw Error(Kind::Singular, error.what(), std::move(atoms));
  } catch (const morse::DegenerateFunction& error) {
    throw Error(Kind::Degenerate, error.what());
  } catch (const geometry::RefusedInput& error) {
    throw Error(Kind::Refused, error.what());
  } catch (const geometry::UnreadableInput& error) {
    throw Error(Kind::Unreadable, error.what());
  } catch (const geometry::UnwritableOutput& error) {
    throw Error(Kind::Unwritable, error.what());
  } catch (const geometry::LimitReached& error) {
    throw Error(Kind::Limit, error.what());
  } catch (const geometry::Stopped& error) {
    throw Error(Kind::Stopped, error.what());
  }
}

geometry::Point inside(const Point& p) { return {p[0], p[1], p[2]}; }
Point outside(const geometry::Point& p) { return {p.x(), p.y(), p.z()}; }

TriangleMesh outside(geometry::IndexedMesh mesh) {
  TriangleMesh result;
  result.triangles = std::move(mesh.triangles);
  result.vertices.reserve(mesh.positions.size());
  for (const geometry::Point& p : mesh.positions) result.vertices.push_back(outside(p));
  return result;
}

/// @throws geometry::RefusedInput  for a corner that does not exist
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

Run inside(const RunOptions& run) { return Run(run.threads, run.progress, run.stop); }

skin::Model inside(Model model) {
  switch (model) {
    case Model::Sas:
      return skin::Model::Sas;
    case Model::Vdw:
      return skin::Model::Vdw;
    case Model::SesLike:
      return skin::Model::SesLike;
    default:
      return skin::Model::Paper;
  }
}

certify::Sizing sizing_of(const MeshOptions& options) {
  certify::Sizing sizing{options.C, options.Q.value_or(certify::Sizing::quality_for(options.C)),
                         options.max_length_scale};
  if (options.edge_length) sizing.set_edge_length(*options.edge_length);
  return sizing;
}

MeshingOptions inside(const MeshOptions& options) {
  MeshingOptions result;
  result.sizing = sizing_of(options);
  result.size_goal = {options.density, options.triangles};
  result.grading = options.grading;
  result.angle_goal_deg = options.angle_goal_deg;
  result.method = options.method;
  result.fronts = options.fronts;
  if (options.direction) {
    result.function = morse::MorseFunction::height(inside(*options.direction));
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

std::string in_words(const Fallback& fallback) {
  const std::string part = "component " + std::to_string(fallback.component) + ": ";
  if (!fallback.replacement) return part + "nothing helped: " + fallback.reason;
  const bool is_sweep = fallback.replacement->method == Method::Sweep;
  return part + (is_sweep ? "swept along another direction: " : "meshed by the static method: ") +
         fallback.reason;
}

std::vector<geometry::WeightedPoint> weighted_points(std::span<const Atom> atoms,
                                                     const SkinOptions& options) {
  if (!(options.probe >= 0 && std::isfinite(options.probe))) {
    throw geometry::RefusedInput("the probe's radius must not be below 0");
  }
  std::vector<geometry::WeightedPoint> points;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const Atom& atom = atoms[i];
    if (!(atom.radius > 0 && std::isfinite(atom.radius))) {
      throw geometry::RefusedInput("atom " + std::to_string(i) + " has no radius above 0");
    }
    points.push_back(
        {inside(atom.position), skin::weight(atom.radius, inside(options.model), options.probe)});
  }
  return points;
}

/// The principal curvatures, the larger in magnitude first.
std::array<double, 2> curvatures_by_size(const skin::SkinSurface& skin,
                                         const surface::SurfacePoint& x) {
  auto [first, second] = skin::curvatures(skin.patch(x.cell), x).principal;
  if (std::abs(second) > std::abs(first)) std::swap(first, second);
  return {first, second};
}

}  // namespace

struct Skin::Prepared {
  PreparedSkin skin;
  std::size_t rounded_coordinates;
};

std::vector<Atom> read_molecule(const std::filesystem::path& file) {
  return with_errors([&] {
    const skin::Molecule molecule = skin::read_molecule(file);
    if (!molecule.weights.empty()) {
      throw geometry::RefusedInput(molecule.source + ": gives weights; Skin is made of radii");
    }
    std::vector<Atom> atoms;
    for (const skin::Atom& atom : molecule.atoms) {
      atoms.push_back({outside(atom.position), atom.radius});
    }
    return atoms;
  });
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  return with_errors([&] { return outside(geometry::read_mesh(file)); });
}

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file) {
  with_errors([&] { geometry::write_mesh(file, inside(mesh)); });
}

Skin::Skin(std::span<const Atom> atoms, const SkinOptions& options, const RunOptions& run)
    : prepared_(with_errors([&] {
        std::vector<geometry::WeightedPoint> points = weighted_points(atoms, options);
        const std::size_t rounded = geometry::move_to_exact_grid(points);
        PreparedSkin skin = prepare_skin(std::move(points), inside(run));
        drop_voids(skin, options.drop_voids_below, inside(run));
        return std::make_shared<const Prepared>(Prepared{std::move(skin), rounded});
      })) {}

std::size_t Skin::rounded_coordinates() const { return prepared_->rounded_coordinates; }
std::size_t Skin::components() const { return prepared_->skin.expected().components; }
std::size_t Skin::genus() const { return prepared_->skin.expected().genus; }

SkinMesh Skin::mesh(const MeshOptions& options, const RunOptions& run) const {
  return with_errors([&] {
    MeshResult made = make_mesh(prepared_->skin, inside(options), inside(run));
    SkinMesh result(*this);
    result.mesh_ = outside(std::move(made.mesh));
    result.certificate_ = outside(made.certificate);
    for (const Fallback& f : made.fallbacks) result.fallbacks_.push_back(in_words(f));
    return result;
  });
}

Certificate Skin::certify(const TriangleMesh& mesh, const MeshOptions& options,
                          const RunOptions& run) const {
  return with_errors([&] {
    const PreparedSkin& skin = prepared_->skin;
    return outside(certify::certify(inside(mesh), skin.surface, skin.expected(), sizing_of(options),
                                    inside(run)));
  });
}

std::vector<SkinPoint> Skin::points(const TriangleMesh& mesh) const {
  return with_errors([&] {
    const geometry::IndexedMesh from = inside(mesh);
    const skin::SkinSurface& surface = prepared_->skin.surface;
    const std::vector<std::uint32_t> component = geometry::vertex_components(from);
    const std::vector<surface::SurfacePoint> points = certify::locate_vertices(from, surface);
    std::vector<SkinPoint> result;
    result.reserve(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      const surface::SurfacePoint& x = points[v];
      result.push_back({outside(x.normal), x.length_scale, curvatures_by_size(surface, x),
                        surface.nearest_atom(x.position, x.cell).value, component[v]});
    }
    return result;
  });
}

}  // namespace morskin

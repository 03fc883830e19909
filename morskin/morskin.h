#pragma once

/// morskin, the library: molecules in, certified triangle meshes of their skins out.
///
///     const morskin::Skin skin(morskin::read_molecule("1crn.pdb"));
///     const morskin::SkinMesh mesh = skin.mesh({.C = 0.2});
///     if (mesh.certificate().certified) morskin::write_mesh(mesh.triangles(), "1crn.ply");
///
/// All lengths are in Angstrom. The library never prints and never exits; what goes wrong is an
/// Error, but for std::bad_alloc, std::system_error and what `progress` throws. The same input
/// gives the same bytes on any number of threads. `papers/library.md` goes through every function,
/// with examples.

// Else the first error would be of something in the standard library.
#if __cplusplus <= 201703L
#error "morskin is C++20: compile with -std=c++20"
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "morskin/mesh_method.h"
#include "morskin/molecule.h"

namespace morskin {

/// What went wrong, in a sentence that names the file and its line, the atom or the option.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    Unreadable,  ///< a file that is missing, damaged or of an unknown format
    Refused,     ///< understood, but there is nothing that could be done with it
    Singular,    ///< the skin touches itself in a point; `atoms` are those about it
    Degenerate,  ///< the direction asked for is degenerate for this skin; take another
    Limit,       ///< more than 32-bit ids can tell apart
    Unwritable,  ///< a file that cannot be written; nothing half-written is left
    Stopped,     ///< on request
  };
  Error(Kind kind, const std::string& text, std::vector<std::uint32_t> atoms = {})
      : std::runtime_error(text), kind_(kind), atoms_(std::move(atoms)) {}

  Kind kind() const { return kind_; }
  const std::vector<std::uint32_t>& atoms() const { return atoms_; }

 private:
  Kind kind_;
  std::vector<std::uint32_t> atoms_;
};

/// How large a sphere the skin has about an atom of radius r that nothing else is near, with a
/// probe of radius p.
enum class Model {
  Paper,    ///< sqrt(sqrt(2) (r + p) / 2), the number in Angstrom: as in the paper's Table 1
  Sas,      ///< r + p: solvent-accessible
  Vdw,      ///< r: van der Waals; also for spheres that are no atoms
  SesLike,  ///< r + 0.25: of these skins the nearest to a solvent-excluded surface, but none
};

/// Which of many skins of the same atoms.
struct SkinOptions {
  Model model = Model::Vdw;
  double probe = 1.4;  ///< Angstrom, >= 0
  /// Voids of a volume proved to be below this, Angstrom^3, are left out, as if they were filled;
  /// infinite for all.
  double drop_voids_below = 0;
};

/// How it is done, which does not change what comes out.
struct RunOptions {
  unsigned threads = 1;  ///< at most
  /// Called now and then, from one thread at a time, with what is being done and the share of it
  /// that is done, 0 to 1, or below 0 if unknown. May be empty.
  std::function<void(std::string_view stage, double share)> progress = {};
  std::stop_token stop = {};  ///< checked wherever progress is reported
};

/// What mesh to make.
struct MeshOptions {
  /// The largest C with which nearly every skin is certified.
  static constexpr double coarsest_C = 0.4;
  double C = 0.08;  ///< how closely the mesh follows the skin; edges are about 2 C / Q to 2 C Q
                    ///< times the local length scale long. 1e-5 <= C < Q / 2
  /// > 1; without one the Q that goes with C: 1.65 up to C = 0.107, above that 0.3 % more than the
  /// least for which refinement is proved to end.
  std::optional<double> Q = {};
  /// A larger length scale counts as this one: limits the triangles where the skin is flat.
  double max_length_scale = std::numeric_limits<double>::infinity();
  /// In its place, at most one of these: the median edge where the skin is flat enough, Angstrom;
  /// vertices per square Angstrom; triangles. Reached as far as C allows, which coarsest_C does
  /// most.
  std::optional<double> edge_length = {}, density = {}, triangles = {};
  /// By how much edges may grow for each Angstrom from where the curvature makes them short, at
  /// least 0.01. By the static method, with an angle goal of 30 degrees or more.
  std::optional<double> grading = {};
  /// No angle is smaller where that is reached; from 30 on none below 30 is certified. 0 to 60.
  /// Without one 35 up to C = 0.2, and no angle above 105; 30 beyond.
  std::optional<double> angle_goal_deg = {};
  /// Without one the sweep, or, up to 50,000 balls, the static method with C above 0.25, unless
  /// length scales are limited to less than a quarter of the median ball's radius: it makes as
  /// dense a mesh in less time there.
  std::optional<Method> method = {};
  /// So many subdomains are swept each for itself: a power of two, 1 to 65,536. 1: one front from
  /// below, the paper's Algorithm 1. Without one, as many as the size of the mesh is worth.
  std::optional<std::size_t> fronts = {};
  std::optional<Point> direction = {};  ///< to sweep along; without one the library finds one
};

struct TriangleMesh {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// A mesh in a file: PLY, OFF, OBJ, STL, MSMS, VTU or MSH, gzipped or not; "-" is standard input.
/// @throws Error  Unreadable
TriangleMesh read_mesh(const std::filesystem::path& file);
/// Writes PLY (binary), OFF, OBJ, STL, VTU, GLB, NPZ or MSH, as the file's ending says, whole or
/// not at all.
/// @throws Error  Unwritable; Refused: a corner that is no vertex, or a vertex that is not finite,
///                in single precision for STL and GLB
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file);

/// What is proved of a mesh and how good it is.
struct Certificate {
  /// Homeomorphic, every vertex on the skin, [U] of section 2.2 everywhere, and every angle at
  /// least 30 degrees: then size_violations may be above 0. In place of such angles [L] everywhere
  /// will do for Skin::certify, and for Skin::mesh with an angle goal below 30.
  bool certified = false;
  bool is_homeomorphic = false;  ///< to the skin, even isotopic
  std::string reason;            ///< why it is not certified; empty if it is
  std::size_t components = 0;    ///< 0 where the mesh is no closed manifold
  long genus = 0;                ///< summed over components; 0 there too
  double min_angle_deg = 0, max_angle_deg = 0;
  double area = 0;                  ///< Angstrom^2
  double volume = 0;                ///< Angstrom^3, voids taken off; NaN where it is no manifold
  double max_distance_to_skin = 0;  ///< of a vertex; infinite where none is known
  std::size_t size_violations = 0;  ///< edges that break [L] and triangles that break [U]
};

/// The skin at a vertex of a mesh.
struct SkinPoint {
  Point normal;                       ///< unit, out of the body
  double length_scale;                ///< the smallest radius of curvature
  std::array<double, 2> curvatures;   ///< principal, k1 >= k2, 1/Angstrom, positive where the body
                                      ///< is convex
  std::array<Point, 2> directions;    ///< theirs, unit; first x second = normal
  std::uint32_t atom;                 ///< nearest by power distance
  std::array<std::int32_t, 4> atoms;  ///< that make the skin here; -1 where fewer
  std::array<double, 4> shares;       ///< theirs: continuous, 1 in sum; 0 where fewer
  std::uint32_t component;            ///< of the mesh, from 0 in the order of the vertices
};

/// Where a height on the skin has no slope.
struct CriticalPoint {
  Point position;
  std::int32_t index;  ///< 0 minimum, 1 saddle, 2 maximum
  double value;        ///< of the height, Angstrom
};

/// Arcs and regions tell points by their place in `points`.
struct MorseSmaleComplex {
  std::vector<CriticalPoint> points;
  /// A saddle, and the extremum that the arc leads to; four in turn for each saddle.
  std::vector<std::array<std::uint32_t, 2>> arcs;
  std::vector<Point> arc_points;  ///< the arcs' polylines, from the saddle on, both ends included
  /// Arc i has arc_points[arc_offsets[i]] to arc_points[arc_offsets[i + 1] - 1].
  std::vector<std::uint32_t> arc_offsets;
  /// Minimum, saddle, maximum, saddle of each, counter-clockwise seen from outside.
  std::vector<std::array<std::uint32_t, 4>> regions;
};

/// What is made of a complex as it was traced.
enum class Simplify {
  Not,
  /// Section 3.2 of the paper: arcs between overlapping protecting spheres, as they are with the
  /// default C, are contracted where the persistence condition allows it. A line then is a path of
  /// several, and only where nothing was contracted monotone.
  ShortArcs,
};

class SkinMesh;
struct FeatureOptions;
struct Features;
struct MeshResult;

/// A skin surface, prepared once; a handle that is cheap to copy. Safe to use from several threads.
class Skin {
 public:
  /// @throws Error  Refused: no atoms, a radius or coordinate that is no number or out of range;
  ///                Singular; Limit; Stopped
  explicit Skin(std::span<const Atom> atoms, const SkinOptions& options = {},
                const RunOptions& run = {});
  // A move is a copy, so that a skin that was moved from is one still.
  Skin(const Skin&) = default;
  Skin& operator=(const Skin&) = default;

  /// Of what is meshed: without those that bound voids which are left out.
  std::size_t components() const;
  std::size_t genus() const;  ///< summed over components
  /// Of the atoms' coordinates, those below 2^-68 that lost digits to the range of the exact
  /// predicates: they are rounded to multiples of 2^-120, and the skin is that of the rounded ones.
  std::size_t rounded_coordinates() const;

  /// Meshes and certifies. Parts of a sweep that are not certified are made anew by other means;
  /// what is not certified even then is there all the same, and its certificate says why.
  /// @throws Error  Refused: options that make no sense; Degenerate; Limit; Stopped
  SkinMesh mesh(const MeshOptions& options = {}, const RunOptions& run = {}) const;

  /// Checks any mesh against this skin. A bad mesh is no error: the certificate says what is wrong.
  /// A request to stop is heeded between its steps and while it locates vertices.
  /// @param options  C, Q and max_length_scale that it was made with; the rest plays no part
  /// @throws Error  Refused: a corner that is no vertex, sizes that make no sense; Stopped
  Certificate certify(const TriangleMesh& mesh, const MeshOptions& options = {},
                      const RunOptions& run = {}) const;

  /// The skin at every vertex of a mesh that lies on it, by vertex.
  /// @throws Error  Refused: a vertex that is not near the skin
  std::vector<SkinPoint> points(const TriangleMesh& mesh) const;

  /// Of the height along a direction, or along the library's choice. Voids that are left out of
  /// what is meshed are there.
  /// @throws Error  Refused: a direction that is none; Degenerate
  std::vector<CriticalPoint> critical_points(const std::optional<Point>& direction = {}) const;
  /// The library's choice of a direction may be another than above.
  /// @throws Error  as above; Stopped
  MorseSmaleComplex morse_smale(const std::optional<Point>& direction = {},
                                const RunOptions& run = {},
                                Simplify simplify = Simplify::Not) const;

 private:
  friend class SkinMesh;
  friend Features features(const std::filesystem::path&, const FeatureOptions&, const RunOptions&);
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

/// A mesh of a skin, together with the skin; copies share both.
class SkinMesh {
 public:
  // A move is a copy, so that a mesh that was moved from is one still.
  SkinMesh(const SkinMesh&) = default;
  SkinMesh& operator=(const SkinMesh&) = default;

  const Skin& skin() const { return skin_; }
  const TriangleMesh& triangles() const { return made_->triangles; }
  const Certificate& certificate() const { return made_->certificate; }
  /// What took the place of parts that were not certified at first, in words; empty in a good run.
  const std::vector<std::string>& fallbacks() const { return made_->fallbacks; }
  /// The skin at every vertex.
  std::vector<SkinPoint> points() const { return skin_.points(made_->triangles); }
  /// C, Q and max_length_scale that it was made with, as Skin::certify takes them.
  MeshOptions sizing() const { return made_->sizing; }

  /// Writes as write_mesh does, and MSMS's two files (.vert and .face) if one of them is named. A
  /// mesh that is not certified gets the ending .unverified.
  /// @param vertex_data  what PLY, VTU, NPZ, MSH and then GLB too hold beside: "normal",
  ///                     "curvature", "directions", "scale", "atom", "shares", "component",
  ///                     "patch"; or "all". papers/vertex-data.md describes them
  /// @return the file's name
  /// @throws Error  Unwritable; Refused: data of another name, or for a format that holds none, or
  ///                triangles that single precision spoils, of STL and GLB; Stopped: nothing is
  ///                written then
  std::filesystem::path write(const std::filesystem::path& file,
                              std::span<const std::string> vertex_data = {},
                              const RunOptions& run = {}) const;

 private:
  friend class Skin;
  friend Features features(const std::filesystem::path&, const FeatureOptions&, const RunOptions&);
  SkinMesh(Skin skin, MeshResult made);

  struct Made {
    TriangleMesh triangles;
    MeshOptions sizing;
    Certificate certificate;
    std::vector<std::string> fallbacks;
  };
  Skin skin_;
  std::shared_ptr<const Made> made_;
};

}  // namespace morskin

#pragma once

/// The command line as values: parsed, checked, with the defaults filled in.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/exit_codes.h"
#include "app/limits.h"
#include "app/model_set.h"
#include "app/picture_arguments.h"
#include "app/skin_arguments.h"
#include "certify/sizing.h"
#include "front/experimental_guards.h"
#include "morse/morse_function.h"
#include "morskin/mesh_attributes.h"
#include "morskin/size_goal.h"

namespace morskin::app {

/// How a skin is meshed: by a method of the library or by a baseline to compare it with.
/// Auto is the library's choice.
enum class MeshMethod { Auto, Sweep, Static, Dynamic, MarchingCubes };

/// The method called "auto", "sweep", "static", "dynamic" or "marching-cubes"; nothing for other
/// words.
std::optional<MeshMethod> parse_method(std::string_view name);
std::string_view name_of(MeshMethod method);

enum class ShowProgress { Auto, Always, Never };  ///< Auto: if standard error is a terminal

/// What files that can hold it tell of the skin beside the mesh.
struct VertexData {
  std::vector<morskin::Datum> data;
  bool residues = false;  ///< and chains
  bool charges = false;
  bool is_all = false;    ///< charges then only where there are any
  bool features = false;  ///< hydropathy, mass, the table of atoms and the Laplacian
};

/// What --for set, by option.
struct PresetUse {
  std::string name;
  std::vector<std::pair<std::string, std::string>> set;
};

struct MeshArguments {
  std::optional<PresetUse> preset;
  MoleculeArguments molecule;
  std::optional<ModelSet> models;  ///< several of the molecule's; each goes into files of its own
  bool fail_fast = false;          ///< the first of them that fails is the last
  TypedSkin typed;
  /// MSMS's two files both are among them.
  std::vector<std::filesystem::path> outputs;
  VertexData vertex_data;
  int order = 1;                               ///< of triangles in formats that have curved ones
  std::optional<int> decimals;                 ///< of MSMS's files
  std::optional<std::filesystem::path> areas;  ///< of atoms and residues, a CSV file
  certify::Sizing sizing;
  morskin::SizeGoal size_goal;
  std::optional<double> grading;
  std::optional<double> angle_goal_deg;  ///< of the smoothing; 0 for none
  std::optional<morse::MorseFunction> function;
  std::optional<std::filesystem::path> report;
  std::optional<std::filesystem::path> certificate;
  std::optional<std::filesystem::path> task_trace;
  bool json = false;
  bool quiet = false;
  bool is_brief = false;  ///< a report of one line; what only a longer one tells is not computed
  ShowProgress progress = ShowProgress::Auto;
  MeshMethod method = MeshMethod::Auto;
  std::optional<double> grid_step;  ///< of marching cubes, Angstrom
  double grow_to = 0;  ///< of the dynamic method: Angstrom^2 added to every weight at the end
  std::optional<double> growth_shown_from;  ///< and when its snapshots begin
  front::Guard guard = front::Guard::Everywhere;
  std::size_t snapshots = 0;            ///< at even steps of the Morse function
  std::vector<double> snapshot_values;  ///< and at these
  std::filesystem::path snapshot_folder = ".";
  bool has_snapshots() const { return snapshots > 0 || !snapshot_values.empty(); }
  std::optional<std::size_t> fronts;  ///< morskin::MeshingOptions::fronts
  unsigned threads = 1;               ///< at most; the result is the same for any number
  Limits limits{.advice = "make a coarser mesh with a larger -C"};
  std::optional<std::string> surface;  ///< in place of a molecule's skin: see surface_input.h
};

/// A mesh with all that learning on surfaces takes: features_options.h fills it in.
struct FeaturesArguments {
  MeshArguments mesh;
};

/// The treatment of critical points whose protecting spheres overlap.
enum class Simplify { Not, BySpheres, ByPersistence };

struct MorseArguments {
  MoleculeArguments molecule;
  std::filesystem::path output;
  std::optional<morse::MorseFunction> function;
  Simplify simplify = Simplify::BySpheres;
  double persistence = 0;  ///< of pairs to cancel, at most; Angstrom, or Angstrom^2 for a distance
  bool quiet = false;
  ShowProgress progress = ShowProgress::Auto;
};

struct BallsArguments {
  MoleculeArguments molecule;
  std::filesystem::path output;
  bool weights = false;  ///< in place of radii
  bool quiet = false;
};

struct InfoArguments {
  MoleculeArguments molecule;
  certify::Sizing sizing;
  /// All that was typed where it was no command: then the text says how to go on.
  std::vector<std::string> words;
  bool json = false;
  unsigned threads = 1;  ///< at most; the result is the same for any number
  ShowProgress progress = ShowProgress::Auto;
};

struct CheckArguments {
  std::filesystem::path mesh;
  std::optional<MoleculeArguments> against;
  certify::Sizing sizing;
  TypedSkin typed;                                   ///< what was given and is not to be doubted
  std::optional<std::filesystem::path> certificate;  ///< with `against` only
  bool self_intersections = true;                    ///< search for them
  bool json = false;
  unsigned threads = 1;  ///< at most; the result is the same for any number
  Limits limits{.advice = "leave out the search with --no-self-intersections"};
  ShowProgress progress = ShowProgress::Auto;
  std::optional<std::string> surface;  ///< in place of a molecule's skin: see surface_input.h
};

struct ViewArguments {
  MoleculeArguments molecule;  ///< its input may be a mesh: see names_a_mesh
  std::filesystem::path output;
  std::optional<std::filesystem::path> against;  ///< the molecule of a mesh
  std::vector<std::filesystem::path> growth;     ///< meshes to show one after the other
  certify::Sizing sizing;
  morskin::SizeGoal size_goal;  ///< of a molecule
  TypedSkin typed;              ///< what was given; the rest a mesh file may state
  std::optional<morse::MorseFunction> function;
  bool quiet = false;
  ShowProgress progress = ShowProgress::Auto;
  unsigned threads = 1;  ///< at most; the result is the same for any number
  Limits limits{.advice = "show a coarser mesh"};
};

/// The molecules of one run of many: every N-th, beginning with the I-th.
struct Shard {
  std::size_t number = 1, count = 1;  ///< I from 1 to N
};

struct BatchArguments {
  std::vector<std::string> sources;  ///< as batch_inputs takes them
  std::string only;                  ///< of folders and archives, the names to take; empty for all
  std::filesystem::path folder;
  std::vector<std::string> endings{"ply"};  ///< of the files that are made, without their dot
  bool features = false;                    ///< run `features` in place of `mesh`
  Shard shard;
  unsigned workers = 1;
  /// For the workers: what decides what they write, and the limits, which do not.
  std::vector<std::string> options, limit_options;
  bool json = false;
  bool quiet = false;
  ShowProgress progress = ShowProgress::Auto;
};

/// Whether a file's ending, before .gz and .unverified where there are these, is that of a mesh,
/// one that is only written too.
bool names_a_mesh(const std::filesystem::path& path);

/// The command ends here: it has printed help, the version or a complaint.
struct Finished {
  ExitCode code;
};

using Arguments = std::variant<Finished, MeshArguments, FeaturesArguments, MorseArguments,
                               BallsArguments, InfoArguments, CheckArguments, ViewArguments,
                               RenderArguments, FigureArguments, BatchArguments>;

/// Prints help, the version or a complaint about the arguments.
Arguments parse_arguments(int count, const char* const* words);

}  // namespace morskin::app

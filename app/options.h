#pragma once

/// The options of the commands: names, help texts and targets. arguments.cpp checks their values.

#include <optional>
#include <string>

#include "app/arguments.h"
#include "app/skin_arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// Options as typed, before conversion.
struct Typed {
  TypedSkin skin;
  std::optional<std::string> height, function;
  std::optional<double> persistence;
  bool is_raw = false;
  bool wants_short_help = false;  ///< not --help-all
  std::string progress = "auto";
  std::string method = "auto";
  std::string guard = "everywhere";
  std::optional<std::size_t> fronts;
  std::vector<std::string> snapshots_at;
  std::optional<double> density, triangles, grading, angle_goal;
  std::optional<std::string> grow, vertex_data, max_memory;
  std::optional<std::string> purpose;  ///< of --for
  TypedPicture picture;
};

/// The options of `batch`. Those that it shares with `mesh` go to the workers as they were typed.
struct TypedBatch {
  BatchArguments arguments;
  MeshArguments mesh;  ///< not used: the workers take theirs anew
  std::optional<std::string> shard, timeout, max_memory;
};

/// The options of all commands.
struct AllArguments {
  MeshArguments mesh;
  FeaturesArguments features;
  MorseArguments morse;
  BallsArguments balls;
  InfoArguments info;
  CheckArguments check;
  MoleculeArguments against;  ///< of `check`
  ViewArguments view;
  RenderArguments render;
  FigureArguments figure;
  TypedBatch batch;
};

// batch/options.cpp

void add_batch(CLI::App& app, TypedBatch& batch, Typed& typed);
/// @param command  as parsed
/// @throws UsageError
BatchArguments batch_arguments(const CLI::App& command, const TypedBatch& typed);

/// Adds all commands and options to the parser. Both must outlive it.
void add_commands(CLI::App& app, AllArguments& all, Typed& typed);

/// parse_arguments of words that a command makes of its own for another.
/// @param command  the one to whose help complaints point; empty: the one that the words name
Arguments parse_arguments(int count, const char* const* words, const std::string& command);

}  // namespace morskin::app

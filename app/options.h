#pragma once

/// The options of the commands, in words: names, help, what each fills in. What they may say is
/// checked in arguments.cpp.

#include <optional>
#include <string>

#include "app/arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// Options as typed, where that is not the value they stand for.
struct Typed {
  std::string model = "paper";
  std::optional<std::string> height, function;
  std::optional<double> persistence;
  bool is_raw = false;
  std::string progress = "auto";
  std::string method = "sweep";
  std::string max_memory;
  std::string guard = "everywhere";
  std::optional<int> fronts;
  std::optional<double> C, Q, size, angle_goal;
  std::optional<std::string> grow;
  TypedPicture picture;
};

/// Everything that any of the commands may be told.
struct AllArguments {
  MeshArguments mesh;
  MorseArguments morse;
  BallsArguments balls;
  InfoArguments info;
  CheckArguments check;
  MoleculeArguments against;  ///< of `check`
  ViewArguments view;
  RenderArguments render;
  FigureArguments figure;
};

/// Tells the parser of all commands and options. Both must outlive it.
void add_commands(CLI::App& app, AllArguments& all, Typed& typed);

}  // namespace morskin::app

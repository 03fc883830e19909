#pragma once

#include "app/arguments.h"

namespace morskin::app {

/// Each runs the command of its name, prints its report and returns the exit code.
/// @throws geometry::UnreadableInput, geometry::RefusedInput, geometry::UnwritableOutput,
/// UsageError
ExitCode mesh_command(const MeshArguments& arguments);
/// mesh_command() where a surface is given in place of a molecule.
ExitCode mesh_surface_command(const MeshArguments& arguments);
/// Runs the command and reports what it throws.
using MeshRun = ExitCode (*)(const MeshArguments& arguments);
/// `mesh` of each of arguments.models; returns the largest of their exit codes.
ExitCode mesh_models(const MeshArguments& arguments, MeshRun run);
ExitCode morse_command(const MorseArguments& arguments);
ExitCode balls_command(const BallsArguments& arguments);
ExitCode info_command(const InfoArguments& arguments);
ExitCode check_command(const CheckArguments& arguments);
ExitCode view_command(const ViewArguments& arguments);
ExitCode render_command(const RenderArguments& arguments);
ExitCode figure_command(const FigureArguments& arguments);
ExitCode batch_command(const BatchArguments& arguments);

}  // namespace morskin::app

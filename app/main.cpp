#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>
#include <variant>

#include "app/commands.h"
#include "app/interruption.h"
#include "app/limits.h"
#include "app/standard_streams.h"
#include "geometry/error.h"

namespace morskin::app {
namespace {

ExitCode run_apart(const MeshArguments& arguments);

struct Run {
  ExitCode operator()(Finished finished) const { return finished.code; }
  ExitCode operator()(const MeshArguments& arguments) const {
    return arguments.models ? mesh_models(arguments, run_apart) : mesh_command(arguments);
  }
  ExitCode operator()(const FeaturesArguments& arguments) const {
    return mesh_command(arguments.mesh);
  }
  ExitCode operator()(const MorseArguments& arguments) const { return morse_command(arguments); }
  ExitCode operator()(const BallsArguments& arguments) const { return balls_command(arguments); }
  ExitCode operator()(const InfoArguments& arguments) const { return info_command(arguments); }
  ExitCode operator()(const CheckArguments& arguments) const { return check_command(arguments); }
  ExitCode operator()(const ViewArguments& arguments) const { return view_command(arguments); }
  ExitCode operator()(const RenderArguments& arguments) const { return render_command(arguments); }
  ExitCode operator()(const FigureArguments& arguments) const { return figure_command(arguments); }
  ExitCode operator()(const BatchArguments& arguments) const { return batch_command(arguments); }
};

template <class Error>
bool is(const std::exception& error) {
  return dynamic_cast<const Error*>(&error) != nullptr;
}

/// A thread needs memory of its own, and so do other services of the system.
bool is_lack_of_memory(const std::exception& error) {
  if (is<std::bad_alloc>(error)) return true;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && (system->code() == std::errc::resource_unavailable_try_again ||
                               system->code() == std::errc::not_enough_memory);
}

struct ErrorClass {
  bool (*has)(const std::exception&);
  ExitCode code;
};

/// The exit code of each class of errors. Whatever else is thrown is a fault of the program.
constexpr ErrorClass error_classes[] = {
    {is<UsageError>, ExitCode::Usage},
    {is<geometry::UnreadableInput>, ExitCode::UnreadableInput},
    {is<geometry::RefusedInput>, ExitCode::RefusedInput},
    {is<geometry::LimitReached>, ExitCode::LimitReached},
    {is<geometry::UnwritableOutput>, ExitCode::UnwritableOutput},
};

ExitCode fail(ExitCode code, const char* what) {
  std::cerr << "morskin: " << what << "\n";
  return code;
}

ExitCode fail_inside(const char* what) {
  std::cerr << "morskin: internal error: " << what << "; please report it with the input\n";
  return ExitCode::InternalError;
}

ExitCode fail(const std::exception& error) {
  if (is_lack_of_memory(error)) return fail(ExitCode::LimitReached, out_of_memory_text());
  for (const ErrorClass& one : error_classes) {
    if (one.has(error)) return fail(one.code, error.what());
  }
  return fail_inside(error.what());
}

/// The limits that were given, to a command that takes any.
Limits limits_of(const Arguments& arguments) {
  return std::visit(
      []([[maybe_unused]] const auto& given) {
        if constexpr (requires { given.limits; }) return given.limits;
        if constexpr (requires { given.mesh.limits; }) return given.mesh.limits;
        return Limits{};
      },
      arguments);
}

/// The exit code of a piece of work, or of what it throws, which is reported.
template <class Work>
ExitCode reported(Work work) {
  try {
    const ExitCode code = work();
    if (std::cout.flush()) return code;
    return fail(ExitCode::UnwritableOutput,
                "standard output: cannot write; the report was not printed");
  } catch (const std::exception& error) {
    return fail(error);
  }
}

ExitCode run_apart(const MeshArguments& arguments) {
  return reported([&] { return mesh_command(arguments); });
}

ExitCode run(int count, const char* const* words) {
  return reported([&] {
    const Arguments arguments = parse_arguments(count, words);
    limit_memory(limits_of(arguments));
    return std::visit(Run{}, arguments);
  });
}

// For exceptions that leave a thread; must not allocate.
[[noreturn]] void end_without_traces() {
  remove_watched_files();
  ExitCode code = ExitCode::InternalError;
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    fail_inside("terminated");
  } catch (const std::exception& error) {
    code = fail(error);
  } catch (...) {
    fail_inside("terminated");
  }
  std::_Exit(static_cast<int>(code));
}

}  // namespace
}  // namespace morskin::app

int main(int count, char** words) {
  std::set_terminate(morskin::app::end_without_traces);
  // Makes a file at the system's limit (ulimit -f) an error of the write, with its own exit code.
  std::signal(SIGXFSZ, SIG_IGN);
  morskin::app::fill_closed_streams();
  const morskin::app::PrintableStream output(std::cout), errors(std::cerr);
  return static_cast<int>(morskin::app::run(count, words));
}

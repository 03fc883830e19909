#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <system_error>
#include <variant>

#include "app/commands.h"
#include "app/interruption.h"
#include "app/limits.h"
#include "geometry/error.h"

namespace morskin::app {
namespace {

struct Run {
  ExitCode operator()(Finished finished) const { return finished.code; }
  ExitCode operator()(const MeshArguments& arguments) const { return mesh_command(arguments); }
  ExitCode operator()(const MorseArguments& arguments) const { return morse_command(arguments); }
  ExitCode operator()(const BallsArguments& arguments) const { return balls_command(arguments); }
  ExitCode operator()(const InfoArguments& arguments) const { return info_command(arguments); }
  ExitCode operator()(const CheckArguments& arguments) const { return check_command(arguments); }
  ExitCode operator()(const ViewArguments& arguments) const { return view_command(arguments); }
  ExitCode operator()(const RenderArguments& arguments) const { return render_command(arguments); }
  ExitCode operator()(const FigureArguments& arguments) const { return figure_command(arguments); }
};

ExitCode fail(ExitCode code, const char* what) {
  std::cerr << "morskin: " << what << "\n";
  return code;
}

ExitCode fail_inside(const char* what) {
  std::cerr << "morskin: internal error: " << what << "; please report it with the input\n";
  return ExitCode::InternalError;
}

ExitCode run(int count, const char* const* words) {
  try {
    const Arguments arguments = parse_arguments(count, words);
    const auto* mesh = std::get_if<MeshArguments>(&arguments);
    limit_memory(mesh != nullptr ? mesh->max_memory : std::nullopt);
    const ExitCode code = std::visit(Run{}, arguments);
    if (!std::cout.flush()) {
      return fail(ExitCode::UnwritableOutput,
                  "standard output: cannot write; the report was not printed");
    }
    return code;
  } catch (const UsageError& error) {
    return fail(ExitCode::Usage, error.what());
  } catch (const geometry::UnreadableInput& error) {
    return fail(ExitCode::UnreadableInput, error.what());
  } catch (const geometry::RefusedInput& error) {
    return fail(ExitCode::RefusedInput, error.what());
  } catch (const geometry::UnwritableOutput& error) {
    return fail(ExitCode::UnwritableOutput, error.what());
  } catch (const geometry::LimitReached& error) {
    return fail(ExitCode::LimitReached, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::LimitReached, out_of_memory_text());
  } catch (const std::system_error& error) {
    // Threads and other services of the system need memory too.
    const bool is_lack = error.code() == std::errc::resource_unavailable_try_again ||
                         error.code() == std::errc::not_enough_memory;
    if (is_lack) return fail(ExitCode::LimitReached, out_of_memory_text());
    return fail_inside(error.what());
  } catch (const std::exception& error) {
    return fail_inside(error.what());
  }
}

// For exceptions that leave a thread; must not allocate.
[[noreturn]] void end_without_traces() {
  remove_watched_files();
  ExitCode code = ExitCode::InternalError;
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    fail_inside("terminated");
  } catch (const std::bad_alloc&) {
    code = fail(ExitCode::LimitReached, out_of_memory_text());
  } catch (const std::exception& error) {
    fail_inside(error.what());
  } catch (...) {
    fail_inside("terminated");
  }
  std::_Exit(static_cast<int>(code));
}

}  // namespace
}  // namespace morskin::app

int main(int count, char** words) {
  std::set_terminate(morskin::app::end_without_traces);
  return static_cast<int>(morskin::app::run(count, words));
}

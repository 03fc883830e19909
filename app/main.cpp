#include <exception>
#include <iostream>
#include <new>

#include "app/commands.h"
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
};

ExitCode fail(ExitCode code, const char* what) {
  std::cerr << "morskin: " << what << "\n";
  return code;
}

ExitCode run(int count, const char* const* words) {
  try {
    const ExitCode code = std::visit(Run{}, parse_arguments(count, words));
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
  } catch (const std::bad_alloc&) {
    return fail(
        ExitCode::LimitReached,
        "out of memory: the mesh is too big for this machine; a larger -C makes it smaller");
  } catch (const std::exception& error) {
    std::cerr << "morskin: internal error: " << error.what()
              << "; please report it with the input\n";
    return ExitCode::InternalError;
  }
}

}  // namespace
}  // namespace morskin::app

int main(int count, char** words) { return static_cast<int>(morskin::app::run(count, words)); }

#include "morskin/method.h"

#include <array>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/stopwatch.h"

namespace morskin {

namespace {

constexpr std::array<std::pair<std::string_view, Method>, 4> methods{
    {{"sweep", Method::Sweep},
     {"static", Method::Static},
     {"dynamic", Method::Dynamic},
     {"marching-cubes", Method::MarchingCubes}}};

}  // namespace

std::optional<Method> parse_method(std::string_view name) {
  for (const auto& [word, method] : methods) {
    if (word == name) return method;
  }
  return std::nullopt;
}

Mesher mesher_of(const MeshOptions& options) {
  if (options.mesher) return options.mesher;
  if (options.method == Method::Sweep) return sweep_method;
  if (options.method == Method::Static) return static_method;
  throw geometry::RefusedInput("the method " + std::string(name_of(options.method)) +
                               " needs a mesher");
}

std::string_view name_of(Method method) { return methods[static_cast<std::size_t>(method)].first; }

MethodResult run_method(const PreparedSkin& skin, const MeshOptions& options) {
  MethodResult made = mesher_of(options)(skin, options);
  // Another's mesh is left as it is, and so is one that could not be closed.
  if (options.mesher || made.open_edges > 0 || options.angle_goal_deg == 0) return made;
  if (options.progress) options.progress("smooth", geometry::unknown_share);
  geometry::timed(made.seconds.smooth, [&] {
    made.smoothing = refine::smooth(skin.surface, options.sizing, made.mesh, options.angle_goal_deg,
                                    options.threads);
  });
  return made;
}

}  // namespace morskin

#include "front/method.h"

#include <array>
#include <utility>

namespace morskin::front {

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

std::string_view name_of(Method method) { return methods[static_cast<std::size_t>(method)].first; }

}  // namespace morskin::front

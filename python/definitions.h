#pragma once

/// Functions and methods that tell a wrong call in one line. pybind11 would list all that they take
/// and all that they were given, every atom of a list too.

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>
#include <vector>

namespace morskin::python {

namespace py = pybind11;

struct Parameter {
  const char* name;
  bool is_required, is_keyword_only;
};

/// Those that pybind11 is told of.
template <class... Extra>
std::vector<Parameter> parameters_among(const Extra&... extra) {
  std::vector<Parameter> result;
  bool is_keyword_only = false;
  const auto append = [&]<class Each>([[maybe_unused]] const Each& each) {
    if constexpr (std::is_same_v<Each, py::kw_only>) is_keyword_only = true;
    if constexpr (std::is_base_of_v<py::arg, Each>) {
      result.push_back({each.name, std::is_same_v<Each, py::arg>, is_keyword_only});
    }
  };
  (append(extra), ...);
  return result;
}

/// @throws py::type_error  with what Python would say of such a call of a function of its own
[[noreturn]] void refuse_call(const std::string& function, const std::vector<Parameter>& parameters,
                              const py::args& values, const py::kwargs& keywords);

/// As scope.def(name, function, extra...).
/// @param scope  a module, or a class, whose methods have `self` beside what `extra` tells of
template <class Scope, class Function, class... Extra>
void define(Scope& scope, const char* name, Function function, const Extra&... extra) {
  scope.def(name, function, extra...);
  std::vector<Parameter> parameters = parameters_among(extra...);
  if (!std::is_same_v<Scope, py::module_>) {
    parameters.insert(parameters.begin(), {"self", true, false});
  }
  // Of one name pybind11 takes the first whose parameters the arguments fit; these fit any.
  scope.def(name, [name, parameters](const py::args& values, const py::kwargs& keywords) {
    refuse_call(name, parameters, values, keywords);
  });
}

/// As scope.def(py::init(function), extra...).
template <class Bound, class Function, class... Extra>
void define_init(py::class_<Bound>& scope, Function function, const Extra&... extra) {
  scope.def(py::init(function), extra...);
  const std::string name = py::str(scope.attr("__name__"));
  scope.def(py::init([name, parameters = parameters_among(extra...)](
                         const py::args& values, const py::kwargs& keywords) -> Bound {
    refuse_call(name, parameters, values, keywords);
  }));
}

}  // namespace morskin::python

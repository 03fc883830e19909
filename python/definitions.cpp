#include "python/definitions.h"

namespace morskin::python {

void refuse_call(const std::string& function, const std::vector<Parameter>& parameters,
                 const py::args& values, const py::kwargs& keywords) {
  const py::module_ inspect = py::module_::import("inspect");
  const py::object kind = inspect.attr("Parameter");
  const py::object required = kind.attr("empty"), optional = py::none();
  py::list all;
  for (const Parameter& p : parameters) {
    const py::object how = kind.attr(p.is_keyword_only ? "KEYWORD_ONLY" : "POSITIONAL_OR_KEYWORD");
    all.append(kind(p.name, how, py::arg("default") = p.is_required ? required : optional));
  }
  std::string reason = "self is of another class";
  try {
    inspect.attr("Signature")(all).attr("bind")(*values, **keywords);
  } catch (const py::error_already_set& wrong) {
    if (!wrong.matches(PyExc_TypeError)) throw;
    reason = py::str(wrong.value());
  }
  throw py::type_error(function + "(): " + reason);
}

}  // namespace morskin::python

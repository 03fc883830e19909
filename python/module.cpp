#include "python/bindings.h"
#include "python/interruptible.h"

PYBIND11_MODULE(_morskin, module) {
  pybind11::options options;
  options.disable_function_signatures();  // _morskin.pyi has them
  module.doc() = "The extension behind the package morskin.";
  module.attr("__version__") = MORSKIN_VERSION;
  morskin::python::end_runs_with_python();
  morskin::python::bind_errors();
  morskin::python::bind_mesh(module);
  morskin::python::bind_morse(module);
  morskin::python::bind_skin(module);
  morskin::python::bind_molecule(module);
}

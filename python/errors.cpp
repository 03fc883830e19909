#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "python/bindings.h"

namespace morskin::python {

namespace {

/// The exception's name in morskin/errors.py: that of the command's exit code.
const char* name_of(Error::Kind kind) {
  switch (kind) {
    case Error::Kind::Unreadable:
      return "UnreadableInput";
    case Error::Kind::Limit:
      return "LimitReached";
    case Error::Kind::Unwritable:
      return "UnwritableOutput";
    case Error::Kind::Stopped:  // interruptible() gives the reason in its place
      return "InternalError";
    default:
      return "RefusedInput";
  }
}

/// As Python spells names of files, which may hold any bytes.
py::object text_of(std::string_view bytes) {
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<py::ssize_t>(bytes.size()), "surrogateescape"));
}

py::object new_error(const char* name, std::string_view text) {
  return py::module_::import("morskin.errors").attr(name)(text_of(text));
}

void set_error(const py::object& error) { PyErr_SetObject(py::type::of(error).ptr(), error.ptr()); }

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const Error& error) {
    py::tuple atoms(error.atoms().size());
    for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = error.atoms()[i];
    const py::object raised = new_error(name_of(error.kind()), error.what());
    raised.attr("atoms") = atoms;
    set_error(raised);
  } catch (const std::bad_alloc&) {
    set_error(new_error("LimitReached", "out of memory"));
  } catch (const std::system_error&) {
    set_error(new_error("LimitReached", "the system gives no more threads"));
  } catch (const py::builtin_exception&) {
    throw;  // pybind11's own
  } catch (const std::exception& error) {
    set_error(new_error("InternalError", error.what()));
  }
}

}  // namespace

void raise_not_certified(SkinMesh mesh) {
  const py::object error = new_error("NotCertified", mesh.certificate().reason);
  error.attr("mesh") = std::make_unique<Mesh>(std::move(mesh));
  set_error(error);
  throw py::error_already_set();
}

void bind_errors() { py::register_local_exception_translator(translate); }

}  // namespace morskin::python

#include <pybind11/pybind11.h>

#include "opaline/error.h"
#include "opaline/version.h"
#include "python/bindings.h"
#include "python/keyword_names.h"

namespace opaline::python {
namespace {

/// Classes of Python live as long as the process.
struct Errors {
  PyObject* error = nullptr;
  PyObject* usageError = nullptr;
};
Errors errors;

PyObject* newError(py::module_& module, const char* name, const char* help,
                   const py::tuple& bases) {
  const std::string whole = std::string("opaline.") + name;
  PyObject* const made = PyErr_NewExceptionWithDoc(whole.c_str(), help, bases.ptr(), nullptr);
  if (!made) throw py::error_already_set();
  module.add_object(name, made);
  return made;
}

void bindErrors(py::module_& module) {
  errors.error =
      newError(module, "Error", "Bad input or a failed device: one sentence with the reason.",
               py::make_tuple(py::handle(PyExc_RuntimeError)));
  errors.usageError = newError(
      module, "UsageError", "A value out of range, an unknown name or an array of the wrong shape.",
      py::make_tuple(py::handle(errors.error), py::handle(PyExc_ValueError)));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const UsageError& error) {
      PyErr_SetString(errors.usageError, withKeywordNames(error.what()).c_str());
    } catch (const Error& error) {
      PyErr_SetString(errors.error, withKeywordNames(error.what()).c_str());
    } catch (const py::cast_error&) {
      PyErr_SetString(PyExc_TypeError, "an argument has a type that it cannot have");
    }
  });
}

}  // namespace
}  // namespace opaline::python

PYBIND11_MODULE(_opaline, module) {
  using namespace opaline::python;
  bindErrors(module);
  bindMedia(module);
  bindMaterials(module);
  bindScenes(module);
  bindRendering(module);
  bindReferences(module);
  bindPictures(module);
  module.attr("__version__") = OPALINE_VERSION;
}

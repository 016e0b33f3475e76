#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/error.h"
#include "opaline/log.h"
#include "opaline/material.h"
#include "opaline/medium.h"
#include "opaline/scene.h"

namespace opaline::python {

namespace py = pybind11;

/// A scene whose objects Python shares, so that one can be changed in its place.
struct SharedScene {
  Scene scene;  ///< without objects
  std::vector<std::shared_ptr<Object>> objects;

  explicit SharedScene(Scene whole = {});
  Scene whole() const;
};

/// The value, if it can be rendered. Throws UsageError.
template <typename Value>
Value sound(Value value) {
  const std::string complaint = complaintAbout(value);
  if (!complaint.empty()) throw UsageError(complaint);
  return value;
}

/// All that shines by itself, in the order of their kinds.
py::tuple lightsOf(const SharedScene& shared);
void setLights(SharedScene& shared, const py::iterable& lights);

/// A Medium, or the name of one.
Medium mediumOf(const py::handle& given);

/// What a body is made of, by the keywords that Object and Renderer.set_material share.
Material materialFrom(const py::object& medium, const py::object& opaqueColor,
                      const std::optional<OpaqueMaterial>& opaque,
                      const std::optional<Paint>& paint,
                      const std::optional<TranslucentSurface>& surface);

/// Of "observed" or "khr".
ColorModel colorModelOf(const std::string& name);

/// Messages go to Python's logger "opaline". May be called with the interpreter's lock or without.
LogCallback pythonLog();

void bindMedia(py::module_& module);
void bindMaterials(py::module_& module);
void bindLights(py::module_& module);
void bindScenes(py::module_& module);
void bindRendering(py::module_& module);
void bindReferences(py::module_& module);
void bindPictures(py::module_& module);

}  // namespace opaline::python

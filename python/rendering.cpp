#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "opaline/error.h"
#include "opaline/exposure.h"
#include "opaline/renderer.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/keyword_names.h"
#include "python/keywords.h"

namespace opaline::python {

LogCallback pythonLog() {
  return [](LogLevel level, std::string_view message) {
    const py::gil_scoped_acquire acquired;
    try {
      const char* const name = level == LogLevel::Warning ? "warning"
                               : level == LogLevel::Note  ? "info"
                                                          : "debug";
      const py::object logger = py::module_::import("logging").attr("getLogger")("opaline");
      logger.attr(name)("%s", withKeywordNames(message));
    } catch (py::error_already_set& error) {
      error.discard_as_unraisable("a handler of the logger 'opaline'");
    }
  };
}

namespace {

/// A renderer and the one view that its pictures share. Several threads of Python may use it, one
/// after the other.
class PythonRenderer {
 public:
  PythonRenderer(const SharedScene& scene, const std::string& device, bool validation,
                 std::optional<bool> rayQueries, std::optional<float> memoryLimitMb)
      : renderer_(optionsOf(device, validation, rayQueries, memoryLimitMb)) {
    setScene(scene);
  }

  void setScene(const SharedScene& shared) {
    Scene scene = shared.whole();
    change([&] { renderer_.setScene(scene); });
    exposureStops_ = automaticExposureStops(scene);
    vertices_.clear();
    for (const Object& object : scene.objects) vertices_.push_back(object.mesh.positionsMm.size());
    clips_.clear();
    for (const Clip& clip : scene.clips) clips_.push_back(clip.name);
  }

  py::object render(int width, int height, const py::object& names,
                    const std::optional<Camera>& camera, bool environmentBehind, bool reuseLight,
                    const py::kwargs& keywords) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.environmentBehind = environmentBehind;
    applyKeywords(keywords, options);
    FrameOrder order;
    order.aovs = aovsOf(names);
    order.reuseLight = reuseLight;
    RenderResult result;
    change([&] {
      if (!view_) {
        view_.emplace(renderer_, options);
      } else {
        view_->setOptions(options);
      }
      view_->setCamera(camera);
      result = view_->render(order);
    });
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return frameOf(order.aovs, std::move(result));
  }

  void setPositions(std::size_t object, const py::object& values) {
    const std::vector<Vec3> positions = positionsOf(values, "positions_mm");
    if (object < vertices_.size() && positions.size() != vertices_[object]) {
      throw UsageError(fmt::format("positions_mm has {} rows, but object {} has {} vertices.",
                                   positions.size(), object, vertices_[object]));
    }
    change([&] { renderer_.replacePositions(object, positions); });
  }

  void restorePositions(std::size_t object) {
    change([&] { renderer_.restorePositions(object); });
  }

  void setTime(double seconds, const py::object& clip) {
    SceneTime time{seconds, 0};
    if (clip.is_none()) {
      time.clip = -1;
    } else if (py::isinstance<py::str>(clip)) {
      const auto name = clip.cast<std::string>();
      const auto found = std::find(clips_.begin(), clips_.end(), name);
      if (found == clips_.end()) throw UsageError(fmt::format("There is no clip '{}'.", name));
      time.clip = static_cast<int>(found - clips_.begin());
    } else if (PyIndex_Check(clip.ptr()) != 0) {
      int isBeyond = 0;
      const long index = PyLong_AsLongAndOverflow(clip.ptr(), &isBeyond);
      if (index == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
      if (isBeyond != 0 || index != static_cast<int>(index))
        throw UsageError(fmt::format("There is no clip {}.", py::str(clip).cast<std::string>()));
      time.clip = static_cast<int>(index);
    } else {
      throw py::type_error("clip must be an index, a name or None");
    }
    change([&] { renderer_.setTime(time); });
  }

  void setMedium(std::size_t object, const py::object& medium) {
    const Medium set = mediumOf(medium);
    change([&] { renderer_.setMedium(object, set); });
  }

  void setMaterial(std::size_t object, const py::object& medium, const py::object& opaqueColor,
                   const std::optional<OpaqueMaterial>& opaque, const std::optional<Paint>& paint,
                   const std::optional<TranslucentSurface>& surface) {
    const Material set = materialFrom(medium, opaqueColor, opaque, paint, surface);
    change([&] { renderer_.setMaterial(object, set); });
  }

  void setCamera(const Camera& camera) {
    change([&] { renderer_.setCamera(camera); });
  }

  void setLights(const SharedScene& from) {
    change([&] { renderer_.setLighting(from.scene.lighting); });
    exposureStops_ = automaticExposureStops(from.whole());
  }

  std::size_t validationMessages() const { return renderer_.validationMessages(); }

 private:
  static RendererOptions optionsOf(const std::string& device, bool validation,
                                   std::optional<bool> rayQueries,
                                   std::optional<float> memoryLimitMb) {
    RendererOptions options;
    options.device = device;
    options.validation = validation;
    options.rayQueries = rayQueries;
    options.memoryLimit = memoryLimitMb;
    options.log = pythonLog();
    return options;
  }

  /// Others run meanwhile, but nobody else uses the renderer.
  template <typename Work>
  void change(Work&& work) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex_);
    work();
  }

  py::object frameOf(const std::vector<Aov>& aovs, RenderResult result) const {
    py::dict pictures;
    for (std::size_t i = 0; i < aovs.size(); ++i) {
      pictures[nameOf(aovs[i]).c_str()] = arrayOf(std::move(result.images[i]));
    }
    const RenderReport& report = result.report;
    py::dict facts;
    facts["device"] = report.device.name;
    facts["transport"] = nameOf(report.transport);
    facts["sum"] = nameOf(report.sum);
    facts["milliseconds"] = report.frameMilliseconds;
    facts["triangles"] = report.triangles;
    facts["vertices"] = report.vertices;
    facts["surfels"] = report.sources;
    facts["clusters"] = report.clusters;
    facts["peak_memory_megabytes"] = report.peakMemoryMegabytes;
    return py::module_::import("opaline").attr("Frame")(pictures, facts, exposureStops_);
  }

  std::mutex mutex_;
  Renderer renderer_;
  std::optional<View> view_;
  float exposureStops_ = 0;
  std::vector<std::size_t> vertices_;
  std::vector<std::string> clips_;
};

}  // namespace

void bindRendering(py::module_& module) {
  using py::arg;
  const std::string renderHelp = R"(Renders one picture and returns a Frame.

width, height: pixels, in [1, 16384]; aovs: a variable or several of radiance, exitance, irradiance, position, normal,
depth, evaluations, object, surfels; camera: a Camera instead of the scene's; environment_behind: environment and ambient
light fill what no surface covers; reuse_light: if only camera, size and antialias changed since the last picture, its
light is kept, and if lights changed too, all that tells where things lie: the same picture, sooner. Other options and their defaults:

)" + keywordHelp() + R"(
The interpreter's lock is released meanwhile. Ctrl C is heeded when the frame is done.)";
  static const std::string kept = renderHelp;  // pybind11 keeps the pointer
  py::class_<PythonRenderer>(module, "Renderer",
                             R"(A Vulkan device with one scene, of which it makes pictures.

Renderer(scene): the best device there is. device: index or part of a name; validation: run Vulkan's validation layer;
ray_queries: True or False, or None for where the device has them and is no software; memory_limit_mb: of the device's
memory, in [64, 1e7]. Notes and warnings go to the logger
"opaline". Several threads may use it, one after the other.)")
      .def(py::init<const SharedScene&, const std::string&, bool, std::optional<bool>,
                    std::optional<float>>(),
           arg("scene"), arg("device") = "", arg("validation") = false,
           arg("ray_queries") = py::none(), arg("memory_limit_mb") = py::none())
      .def("render", &PythonRenderer::render, kept.c_str(), arg("width") = 1024,
           arg("height") = 1024, arg("aovs") = "radiance", py::kw_only(),
           arg("camera") = py::none(), arg("environment_behind") = false,
           arg("reuse_light") = false)
      .def("set_scene", &PythonRenderer::setScene, arg("scene"), "Another scene, at time 0.")
      .def("set_positions", &PythonRenderer::setPositions, arg("object"), arg("positions_mm"),
           R"(Where the vertices of an object are from the next frame on.

object: its index; positions_mm: array (N, 3) of any kind of number and any strides, in the order of the object's
vertices. Copied. Normals follow by themselves.)")
      .def("restore_positions", &PythonRenderer::restorePositions, arg("object"),
           "Undoes set_positions.")
      .def("set_time", &PythonRenderer::setTime, arg("seconds"), arg("clip") = 0,
           "The moment of a clip, by index or name; None: no clip, deformers alone.")
      .def("set_medium", &PythonRenderer::setMedium, arg("object"), arg("medium"),
           "Another Medium, or the name of one, for an object by its index.")
      .def("set_material", &PythonRenderer::setMaterial, arg("object"), arg("medium") = "marble",
           py::kw_only(), arg("opaque_color") = py::none(), arg("material") = py::none(),
           arg("paint") = py::none(), arg("surface") = py::none(),
           "What an object is made of, by the keywords of Object. What is opaque stays so, and so\n"
           "does what light enters.")
      .def("set_camera", &PythonRenderer::setCamera, arg("camera"), "Another Camera.")
      .def("set_lights", &PythonRenderer::setLights, arg("scene"),
           "All lights, ambient light and environment of a scene.")
      .def_property_readonly("validation_messages", &PythonRenderer::validationMessages,
                             "How many messages Vulkan's validation layer had; 0 without it.");
  module.def(
      "devices",
      [] {
        py::list names;
        for (const DeviceDescription& device : listDevices()) names.append(device.name);
        return names;
      },
      "The names of this machine's Vulkan devices, in the order of their index.");
}

}  // namespace opaline::python

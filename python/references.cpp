#include <pybind11/stl.h>

#include <chrono>
#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "opaline/error.h"
#include "opaline/exposure.h"
#include "opaline/options/picture.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/keywords.h"
#include "reference/posed_scene.h"
#include "reference/truth.h"

namespace opaline::python {

namespace {

namespace rf = opaline::reference;

/// Works on another thread, without the interpreter's lock, until it is done or Ctrl C is pressed.
template <typename Work>
auto interruptible(Work work) {
  constexpr std::chrono::milliseconds pause{50};
  std::stop_source stop;
  auto result = std::async(std::launch::async, std::move(work), stop.get_token());
  while (true) {
    {
      const py::gil_scoped_release released;
      if (result.wait_for(pause) == std::future_status::ready) break;
    }
    if (PyErr_CheckSignals() == 0) continue;
    stop.request_stop();
    {
      const py::gil_scoped_release released;
      result.wait();
    }
    throw py::error_already_set();
  }
  return result.get();
}

rf::PictureOptions pictureOf(int width, int height, const std::string& aov, int antialias,
                             const rf::EyePathOptions& eye = {}) {
  rf::PictureOptions picture;
  picture.width = width;
  picture.height = height;
  picture.aov = aovOf(aov);
  picture.antialias = antialias;
  picture.eye = eye;
  RenderOptions like;
  like.width = width;
  like.height = height;
  like.antialias = antialias;
  like.roughness = static_cast<float>(eye.roughness);
  const std::string complaint = options::complaintAbout(like);
  if (!complaint.empty()) throw UsageError(complaint);
  if (showsMap(picture.aov) || picture.aov == Aov::Surfels || picture.aov == Aov::Evaluations) {
    throw UsageError("A reference has no " + aov + ".");
  }
  return picture;
}

py::object frameOf(const std::string& aov, Image image, const py::dict& facts, const Scene& scene) {
  py::dict pictures;
  pictures[aov.c_str()] = arrayOf(std::move(image));
  return py::module_::import("opaline").attr("Frame")(pictures, facts,
                                                      automaticExposureStops(scene));
}

py::object integral(const SharedScene& shared, int width, int height, const std::string& aov,
                    const std::string& transport, double tolerance, int antialias, double seconds,
                    int clip) {
  const Scene scene = shared.whole();
  const rf::PictureOptions picture = pictureOf(width, height, aov, antialias);
  const Transport halfSpace = transportOf(transport);
  if (halfSpace == Transport::Boundary) {
    throw UsageError("There is an integral of transport 'dipole' and 'better-dipole' alone.");
  }
  rf::IntegralTruth truth = interruptible([&](const std::stop_token& stop) {
    const rf::Scene posed = rf::posedScene(scene, {seconds, clip});
    const rf::Geometry geometry(posed);
    const rf::Irradiance irradiance(geometry);
    return rf::integralTruth(geometry, irradiance, {halfSpace, tolerance, stop}, picture,
                             [&](std::size_t, std::size_t) { rf::throwIfStopped(stop); });
  });
  py::dict facts;
  facts["method"] = "integral";
  facts["transport"] = transport;
  facts["patches"] = truth.patches;
  facts["relative_error"] = truth.picture.error.mean;
  facts["largest_relative_error"] = truth.picture.error.largest;
  return frameOf(aov, std::move(truth.picture.image), facts, scene);
}

py::object path(const SharedScene& shared, int width, int height, const std::string& aov,
                const std::optional<double>& error, const std::optional<double>& longestSeconds,
                const std::optional<std::uint64_t>& particles, int bounces, std::uint64_t seed,
                double cellMm, bool specular, double roughness, int antialias, double seconds,
                int clip) {
  struct Made {
    Image image;
    double error = 0;
    std::uint64_t particles = 0;
  };
  const Scene scene = shared.whole();
  const rf::PictureOptions picture =
      pictureOf(width, height, aov, antialias, {specular, roughness});
  if (bounces < 0 || !(cellMm >= 0)) throw UsageError("bounces and cell_mm must not be negative.");
  if ((error && !(*error > 0)) || (longestSeconds && !(*longestSeconds > 0)) ||
      (particles && *particles == 0)) {
    throw UsageError("error, longest_seconds and particles must be above 0.");
  }
  Made made = interruptible([&](const std::stop_token& stop) {
    const rf::Scene posed = rf::posedScene(scene, {seconds, clip});
    const rf::Geometry geometry(posed);
    const rf::Irradiance irradiance(geometry);
    rf::PathTracer tracer(geometry, {bounces, seed, cellMm});
    const rf::CameraRays rays(posed.camera, picture.width, picture.height);
    const rf::BlockError blocks(tracer, geometry, rays, picture.width, picture.height, stop);
    rf::PathLimits limits = rf::orUsual({particles, longestSeconds, error});
    limits.secondsOfBatch = 0.25;  // soon interrupted
    const double reached = rf::runPaths(
        tracer, blocks, limits, [&](std::uint64_t, double, double) { rf::throwIfStopped(stop); });
    rf::Picture truth = rf::pathTruth(tracer, geometry, irradiance, picture,
                                      [&](std::size_t, std::size_t) { rf::throwIfStopped(stop); });
    return Made{std::move(truth.image), reached, tracer.particles()};
  });
  py::dict facts;
  facts["method"] = "path";
  facts["block_error"] = made.error;
  facts["particles"] = made.particles;
  return frameOf(aov, std::move(made.image), facts, scene);
}

}  // namespace

void bindReferences(py::module_& module) {
  using py::arg;
  module.def("integral", &integral, arg("scene"), arg("width") = 1024, arg("height") = 1024,
             arg("aov") = "radiance", py::kw_only(), arg("transport") = "dipole",
             arg("tolerance") = 1e-3, arg("antialias") = 4, arg("seconds") = 0.0, arg("clip") = 0,
             R"(The exact surface integral of the dipole, on the CPU; returns a Frame.

aov: radiance (without the reflection on the surface), exitance, irradiance, position, normal, depth or object; transport:
dipole or better-dipole; tolerance: relative error allowed, in [1e-7, 0.5]; seconds, clip: the moment, clip -1 is none.
The interpreter's lock is released meanwhile, and Ctrl C ends it.)");
  module.def("path", &path, arg("scene"), arg("width") = 1024, arg("height") = 1024,
             arg("aov") = "radiance", py::kw_only(), arg("error") = py::none(),
             arg("longest_seconds") = py::none(), arg("particles") = py::none(),
             arg("bounces") = 1000, arg("seed") = 1, arg("cell_mm") = 0.0, arg("specular") = true,
             arg("roughness") = 0.25, arg("antialias") = 4, arg("seconds") = 0.0, arg("clip") = 0,
             R"(Light followed through the bodies particle by particle, on the CPU; returns a Frame.

It ends at the first of: error, the relative rms error of blocks of 8x8 pixels; longest_seconds; particles of each
channel. Without any of them at an error of 0.02. bounces: how often light may enter again; seed: of the random numbers; cell_mm: edge of the cells that count light, 0: by medium.
specular: whether radiance has what surfaces mirror; roughness: of translucent ones that state none.
The interpreter's lock is released meanwhile, and Ctrl C ends it.)");
}

}  // namespace opaline::python

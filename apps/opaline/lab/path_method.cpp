#include "lab/path_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/frame_names.h"
#include "cli/paths.h"
#include "cli/progress.h"
#include "cli/values.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/mesh.h"
#include "reference/truth.h"

namespace opaline::app {

namespace {

namespace rf = opaline::reference;
using Clock = std::chrono::steady_clock;

constexpr double secondsBetweenCheckpoints = 30;
constexpr std::size_t longestCheckpointBytes = std::size_t{4} << 30U;

constexpr std::array orders{std::pair{"unscattered", rf::Order::Unscattered},
                            std::pair{"single", rf::Order::Single},
                            std::pair{"multiple", rf::Order::Multiple}};

bool areClosed(const rf::Scene& scene) {
  struct Surface {
    std::vector<Vec3> positionsMm;
    std::vector<Triangle> triangles;
  };
  std::map<std::uint32_t, Surface> wholes;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    const rf::Body& body = scene.bodies[i];
    if (body.opaque) continue;
    Surface& whole = wholes[rf::wholeOf(scene, i)];
    const auto first = static_cast<std::uint32_t>(whole.positionsMm.size());
    for (const rf::Vector& p : body.positionsMm) whole.positionsMm.push_back(rf::toFloat(p));
    for (const Triangle& t : body.triangles)
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return std::ranges::all_of(wholes, [](const auto& whole) {
    return factsOf(whole.second.positionsMm, whole.second.triangles).closed;
  });
}

}  // namespace

void warnOfLostLight(const rf::PathTracer& tracer, const rf::Scene& scene, const LogCallback& log) {
  // A closed mesh only loses the particles, a few in a million, that rounding lets through an edge.
  constexpr double most = 1e-3;
  const double lost = std::max({tracer.lostShare(0), tracer.lostShare(1), tracer.lostShare(2)});
  if (lost <= most) return;
  const char* const why =
      areClosed(scene)
          ? "was lost where bodies overlap; --path is correct for bodies that stand apart"
          : "slipped through gaps of the surface and was lost; --path is correct for closed bodies "
            "only";
  log(LogLevel::Warning, fmt::format("{:.2g} % of the light {}", 100 * lost, why));
}

void PathMethod::addTo(CommandLine& line) {
  const auto value = [&](const char* name, const char* placeholder, const char* help, auto take) {
    line.value(name, placeholder, help, [this, take](const Given& given) {
      take(given);
      any_ = true;
    });
  };
  line.flag("--path", "light followed through the bodies, path tracing", wanted_);
  value("--samples", "N", "particles of each channel, and time, at most",
        [this](const Given& given) {
          const double particles = readNumber(given, {1, 1e15});
          if (particles != std::floor(particles))
            throw UsageError(fmt::format("--samples {}: must be a whole number", given.text));
          limits_.particles = static_cast<std::uint64_t>(particles);
        });
  value("--seconds", "S", "", [this](const Given& given) {
    limits_.seconds = readNumber(given, {0.01, 1e7, "s"});
  });
  value("--error", "X", "ends at this rms error of 8x8 blocks [0.02]", [this](const Given& given) {
    limits_.error = readNumber(given, {1e-5, 1});
  });
  value("--bounces", "N", "how often light may enter again [1000]",
        [this](const Given& given) { options_.bounces = readInteger(given, 0, 1000000); });
  value("--scattered", "HOW", "once or more: shows that light alone", [this](const Given& given) {
    options_.shown = readChoice<rf::Scattered>(
        given, {{"once", rf::Scattered::Single}, {"more", rf::Scattered::Multiple}});
  });
  value("--cone", "DEGREES", "only what leaves so near to the camera's direction",
        [this](const Given& given) {
          options_.coneDegrees = readNumber(given, {0.5, 60, "degrees"});
        });
  value("--cell-mm", "X", "edge of the cells that count light [by medium]",
        [this](const Given& given) {
          options_.cellMm = readNumber(given, {1e-4, 1e6, "mm"});
        });
  value("--paths", "N", "from the eye to a pixel [64], random numbers [1]",
        [this](const Given& given) { pathsOfPixel_ = readInteger(given, 1, 1000000); });
  value("--seed", "N", "", [this](const Given& given) {
    options_.seed = static_cast<std::uint64_t>(readInteger(given, 0, 1'000'000'000));
  });
  value("--checkpoint", "FILE", "state of the run; a later run continues from it",
        [this](const Given& given) { checkpoint_ = given.text; });
}

void PathMethod::check(const std::filesystem::path& output,
                       const std::optional<std::filesystem::path>& report, bool films) const {
  if (any_ && !wanted_) {
    throw UsageError(
        "--samples, --seconds, --error, --bounces, --scattered, --cone, --cell-mm, --paths, --seed "
        "and "
        "--checkpoint belong to --path");
  }
  const bool numbered = checkpoint_ && FrameNames::parse(checkpoint_->string());
  if (checkpoint_ && films != numbered) {
    throw UsageError(fmt::format("--checkpoint {}: {}", checkpoint_->string(),
                                 films ? "each frame has its own; name them like state_%04d"
                                       : "stands for many files and needs --frames A:B"));
  }
  const auto isCheckpoint = [&](const std::filesystem::path& file) {
    return checkpoint_ && checkpoint_->lexically_normal() == file.lexically_normal();
  };
  if (isCheckpoint(output) || (report && isCheckpoint(*report))) {
    throw UsageError(fmt::format("--checkpoint {}: the {} would overwrite it; name another file",
                                 checkpoint_->string(),
                                 isCheckpoint(output) ? "picture" : "report"));
  }
}

Json PathMethod::describe() const {
  const auto orNull = [](const auto& limit) { return limit ? Json(*limit) : Json(); };
  return {{"method", "path"},
          {"samples", orNull(limits_.particles)},
          {"seconds_of_tracing", orNull(limits_.seconds)},
          {"error", orNull(reference::orUsual(limits_).error)},
          {"bounces", options_.bounces},
          {"scattered", options_.shown == rf::Scattered::Single     ? Json("once")
                        : options_.shown == rf::Scattered::Multiple ? Json("more")
                                                                    : Json()},
          {"cone_degrees", options_.coneDegrees},
          {"cell_mm", options_.cellMm},
          {"paths", pathsOfPixel_},
          {"seed", options_.seed}};
}

std::optional<std::filesystem::path> PathMethod::checkpointOf(const PictureRun& run) const {
  return checkpoint_ && run.frame ? fileOf(*checkpoint_, *run.frame) : checkpoint_;
}

void PathMethod::resume(const PictureRun& run, rf::PathTracer& tracer) const {
  const auto file = checkpointOf(run);
  std::error_code ignored;
  if (!file || !std::filesystem::exists(*file, ignored)) return;
  try {
    tracer.restore(readFile(*file, longestCheckpointBytes));
  } catch (const Error& error) {
    throw Error(fmt::format("--checkpoint {}: {}; name another file to start anew", file->string(),
                            error.what()));
  }
}

// A state that cannot be saved ends no run: the picture is worth more.
double PathMethod::trace(const PictureRun& run, const rf::BlockError& error, rf::PathTracer& tracer,
                         std::string& unsaved) const {
  constexpr std::size_t steps = 1000;
  const rf::PathLimits ends = reference::orUsual(limits_);
  Progress progress(steps, run.quiet, "step", run.progress);
  const auto before =
      static_cast<std::size_t>(steps * reference::shareDone(ends, tracer.particles(), 0, error()));
  Clock::time_point saved = Clock::now();
  const auto file = checkpointOf(run);
  const auto save = [&] {
    if (!file) return;
    try {
      const std::vector<std::byte> bytes = tracer.save();
      writeWhole(*file,
                 std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
      unsaved.clear();
    } catch (const Error& failure) {
      unsaved = fmt::format("--checkpoint {}: {}", file->string(), failure.what());
    }
  };
  const double reached =
      rf::runPaths(tracer, error, ends, [&](std::uint64_t particles, double seconds, double now) {
        progress.show(
            static_cast<std::size_t>(steps * reference::shareDone(ends, particles, seconds, now)),
            before);
        if (std::chrono::duration<double>(Clock::now() - saved).count() < secondsBetweenCheckpoints)
          return;
        save();
        saved = Clock::now();
      });
  save();
  return reached;
}

rf::Picture PathMethod::make(const rf::Geometry& geometry, const rf::Irradiance& irradiance,
                             rf::PictureOptions picture, const PictureRun& run,
                             Json& report) const {
  picture.pathsOfPixel = pathsOfPixel_;
  if (const auto file = checkpointOf(run)) requireWritable(*file);
  const auto begin = Clock::now();
  rf::PathTracer tracer(geometry, options_);
  resume(run, tracer);
  const rf::CameraRays rays(geometry.scene().camera, picture.width, picture.height);
  const rf::BlockError error(tracer, geometry, rays, picture.width, picture.height);
  // Other variables show shape or what arrives, and need no particles.
  std::string unsaved;
  const double reached = rf::showsExitance(picture.aov) ? trace(run, error, tracer, unsaved) : 0;

  report["particles"] = tracer.particles();
  report["block_error"] = reached;
  report["seconds_of_tracing"] = std::chrono::duration<double>(Clock::now() - begin).count();
  report["cells"] = tracer.cells().count();
  report["bounces"] = options_.bounces;
  report[unsavedCheckpoint] = unsaved.empty() ? Json() : Json(unsaved);
  for (int c = 0; c < 3; ++c) {
    report["emitted_flux"].push_back(tracer.emittedFlux(c));
    report["lost_share"].push_back(tracer.lostShare(c));
    for (const auto& [name, order] : orders)
      report["left_flux"][name].push_back(tracer.leftFlux(c, order));
  }
  warnOfLostLight(tracer, geometry.scene(), run.log);
  return reference::pathTruth(tracer, geometry, irradiance, picture);
}

}  // namespace opaline::app

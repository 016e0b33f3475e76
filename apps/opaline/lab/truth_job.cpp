#include "lab/truth_job.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include "reference/run_control.h"
#include "reference/truth.h"

namespace opaline::app {

namespace {

namespace rf = opaline::reference;
using Clock = std::chrono::steady_clock;

/// Time between pictures of the particles, and the most that making them may take of the total.
constexpr double secondsBetweenPictures = 0.5;
constexpr double mostOfPictures = 0.2;
/// Short enough that the job can be cancelled between two batches.
constexpr double secondsOfBatch = 0.25;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

struct TruthJob::Work {
  Scene scene;
  SceneTime time;
  RenderOptions options;
  TruthOrder order;
  PositionsByObject positionsMm;
  Clock::time_point begin = Clock::now();

  rf::PictureOptions picture() const {
    rf::PictureOptions picture;
    picture.width = options.width;
    picture.height = options.height;
    picture.antialias = options.antialias;
    picture.environmentBehind = options.environmentBehind;
    picture.eye = {options.specular, double{options.roughness}};
    return picture;
  }
};

TruthJob::TruthJob(Scene scene, const SceneTime& time, const RenderOptions& options,
                   const TruthOrder& order, PositionsByObject positionsMm)
    : thread_([this, work = Work{std::move(scene), time, options, order, std::move(positionsMm)}](
                  const std::stop_token& stop) { run(work, stop); }) {}

TruthJob::~TruthJob() = default;

std::shared_ptr<const TruthPicture> TruthJob::picture() const {
  const std::lock_guard lock(mutex_);
  return picture_;
}

std::string TruthJob::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

void TruthJob::show(TruthPicture picture) {
  auto shared = std::make_shared<const TruthPicture>(std::move(picture));
  const std::lock_guard lock(mutex_);
  picture_ = std::move(shared);
}

void TruthJob::run(const Work& work, const std::stop_token& stop) {
  const auto fail = [&](const char* sentence) {
    const std::lock_guard lock(mutex_);
    error_ = sentence;
    state_ = State::Failed;
  };
  try {
    rf::onThreads(work.order.threads, [&] { compute(work, stop); });
    progress_ = 1;
    state_ = State::Done;
  } catch (const rf::Stopped&) {
    state_ = State::Cancelled;
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory for the reference");
  } catch (const std::exception& failure) {
    fail(failure.what());
  }
}

void TruthJob::compute(const Work& work, const std::stop_token& stop) {
  rf::requireSound(work.picture());
  const rf::Scene scene = reference::posedScene(work.scene, work.time, work.positionsMm);
  const rf::Geometry geometry(scene);
  rf::throwIfStopped(stop);
  if (work.order.method == TruthOrder::Method::Integral) {
    integrate(work, geometry, stop);
  } else {
    follow(work, geometry, stop);
  }
}

void TruthJob::integrate(const Work& work, const rf::Geometry& geometry,
                         const std::stop_token& stop) {
  const rf::Irradiance irradiance(geometry);
  const rf::IntegralOptions integral{reference::transportOfIntegral(work.options.transport),
                                     work.order.tolerance, stop};
  reference::IntegralTruth truth = reference::integralTruth(
      geometry, irradiance, integral, work.picture(), [&](std::size_t done, std::size_t total) {
        rf::throwIfStopped(stop);
        progress_ = static_cast<double>(done) / static_cast<double>(total);
      });
  show({std::move(truth.picture.image), truth.picture.error.mean, secondsSince(work.begin), 0});
}

void TruthJob::follow(const Work& work, const rf::Geometry& geometry, const std::stop_token& stop) {
  const rf::Irradiance irradiance(geometry);
  const rf::PictureOptions picture = work.picture();
  rf::PathTracer tracer(geometry, work.order.path);
  const rf::CameraRays rays(geometry.scene().camera, picture.width, picture.height);
  const rf::BlockError blockError(tracer, geometry, rays, picture.width, picture.height, stop);
  rf::PathLimits limits = reference::orUsual(work.order.limits);
  limits.secondsOfBatch = secondsOfBatch;

  const auto showNow = [&](double error) {
    rf::Picture made =
        reference::pathTruth(tracer, geometry, irradiance, picture,
                             [&](std::size_t, std::size_t) { rf::throwIfStopped(stop); });
    show({std::move(made.image), error, secondsSince(work.begin), tracer.particles()});
  };
  Clock::time_point shown = Clock::now();
  double pause = 0;  // none before the first picture
  const double reached = rf::runPaths(
      tracer, blockError, limits, [&](std::uint64_t particles, double seconds, double error) {
        rf::throwIfStopped(stop);
        progress_ = reference::shareDone(limits, particles, seconds, error);
        if (secondsSince(shown) < pause) return;
        const Clock::time_point begin = Clock::now();
        showNow(error);
        pause = std::max(secondsBetweenPictures, secondsSince(begin) / mostOfPictures);
        shown = Clock::now();
      });
  rf::throwIfStopped(stop);
  showNow(reached);
}

}  // namespace opaline::app

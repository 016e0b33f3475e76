#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "opaline/image.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/posed_scene.h"

namespace opaline::app {

/// How the truth is found.
struct TruthOrder {
  enum class Method {
    Integral,  ///< of the dipole, or the better one, over the surface
    Path,      ///< particles from the lights through the bodies
  };
  Method method = Method::Path;
  double tolerance = 1e-3;  ///< of the integral, relative, in [1e-7, 0.5]
  reference::PathOptions path;
  reference::PathLimits limits;  ///< of Path; none: until blocks are within 2 %
  int threads = 0;               ///< at most; 0: as many as there are cores
};

/// A picture of it.
struct TruthPicture {
  Image image;
  /// Relative: what the integral's pixels may be off in the mean, or the standard error of blocks
  /// of 8×8 pixels of the particles.
  double error = 0;
  double seconds = 0;           ///< since the job began
  std::uint64_t particles = 0;  ///< of each channel, of Path
};

/// What `opaline reference` computes, on threads of its own, for a program that meanwhile shows
/// something else. All functions may be called from any thread. Prints nothing.
class TruthJob {
 public:
  enum class State { Running, Done, Cancelled, Failed };

  /// Radiance without the reflection on the surface, of the size, samples and transport of
  /// `options`, seen by the scene's camera. Given positions are as those that a Renderer is
  /// given.
  TruthJob(Scene scene, const SceneTime& time, const RenderOptions& options,
           const TruthOrder& order, PositionsByObject positionsMm = {});
  /// Cancels.
  ~TruthJob();
  TruthJob(const TruthJob&) = delete;
  TruthJob& operator=(const TruthJob&) = delete;

  State state() const { return state_; }
  /// In [0, 1]; 0 while sources are sought.
  double progress() const { return progress_; }
  /// The latest, nothing before the first. Of Path there is one after the other, each nearer to the
  /// truth; one that was handed out stays as it is.
  std::shared_ptr<const TruthPicture> picture() const;
  /// One sentence where it failed, else empty.
  std::string error() const;

  /// Returns at once; the job ends within a second.
  void cancel() { thread_.request_stop(); }

 private:
  struct Work;

  void run(const Work& work, const std::stop_token& stop);
  void compute(const Work& work, const std::stop_token& stop);
  void integrate(const Work& work, const reference::Geometry& geometry,
                 const std::stop_token& stop);
  void follow(const Work& work, const reference::Geometry& geometry, const std::stop_token& stop);
  void show(TruthPicture picture);

  std::atomic<State> state_ = State::Running;
  std::atomic<double> progress_ = 0;
  mutable std::mutex mutex_;
  std::shared_ptr<const TruthPicture> picture_;
  std::string error_;
  std::jthread thread_;  ///< last, so that it ends before what it works with
};

}  // namespace opaline::app

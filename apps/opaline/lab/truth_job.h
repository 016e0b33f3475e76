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

/// The method and the limits of computing the truth.
struct TruthOrder {
  enum class Method {
    Integral,  ///< the dipole or the better dipole, integrated over the surface
    Path,      ///< particles traced from the lights through the bodies
  };
  Method method = Method::Path;
  double tolerance = 1e-3;  ///< relative, of the integral, in [1e-7, 0.5]
  reference::PathOptions path;
  reference::PathLimits limits;  ///< for Path; none: until blocks are within 2 %
  int threads = 0;               ///< at most; 0: as many as there are cores
};

/// A picture of the truth.
struct TruthPicture {
  Image image;
  /// Relative error: the mean error of the integral's pixels, or the standard error of the
  /// particles' blocks of 8×8 pixels.
  double error = 0;
  double seconds = 0;           ///< since the job began
  std::uint64_t particles = 0;  ///< per channel, with Path
};

/// Computes what `opaline reference` does, on threads of its own, for a program that shows
/// something else meanwhile. All functions are thread-safe. Nothing is printed.
class TruthJob {
 public:
  enum class State { Running, Done, Cancelled, Failed };

  /// Computes radiance without the reflection on the surface, seen by the scene's camera. `options`
  /// gives size, samples and transport. `positionsMm` has the same form as for a Renderer.
  TruthJob(Scene scene, const SceneTime& time, const RenderOptions& options,
           const TruthOrder& order, PositionsByObject positionsMm = {});
  /// Cancels the job.
  ~TruthJob();
  TruthJob(const TruthJob&) = delete;
  TruthJob& operator=(const TruthJob&) = delete;

  State state() const { return state_; }
  /// In [0, 1]; 0 while sources are being found.
  double progress() const { return progress_; }
  /// The latest picture; null before the first. Path makes a series of pictures, each closer to the
  /// truth. A picture does not change once it has been handed out.
  std::shared_ptr<const TruthPicture> picture() const;
  /// One sentence if the job failed, else empty.
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
  std::jthread thread_;  ///< last, so that it ends before the members that it uses
};

}  // namespace opaline::app

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "reference/camera_rays.h"
#include "reference/path/path_tracer.h"
#include "reference/run_control.h"

namespace opaline::reference {

/// When a run of the path tracer ends: at the first of these limits, or at once without any.
struct PathLimits {
  std::optional<std::uint64_t> particles;  ///< per channel
  std::optional<double> seconds;
  std::optional<double> error;  ///< as of BlockError
  double secondsOfBatch = 2;    ///< length to which batches grow
};

/// The standard error of a picture of exitance: rms over its blocks of 8×8 pixels, relative to the
/// mean block that shows media, all channels together. Opaque surfaces are not counted.
class BlockError {
 public:
  /// Throws Stopped.
  BlockError(const PathTracer& tracer, const Geometry& geometry, const CameraRays& rays, int width,
             int height, const std::stop_token& stop = {});

  double operator()() const;
  /// The same rms over all blocks of the picture, in the unit of exitance. A block's value is the
  /// sum over the pixels that show media, divided by the number of pixels in a whole block.
  double ofPicture() const;

 private:
  struct Share {
    std::size_t cell = 0;
    double pixels = 0;
  };
  using Block = std::vector<Share>;
  /// Over blocks and channels.
  struct Sums {
    double values = 0;
    double squaredErrors = 0;
  };
  Sums sums() const;

  static Block blockAt(int left, int top, int right, int bottom, const PathTracer& tracer,
                       const Geometry& geometry, const CameraRays& rays);

  const PathTracer& tracer_;
  std::vector<Block> blocks_;  ///< those that show a medium
  std::size_t blocksOfPicture_;
};

/// Called after every batch.
using PathProgress = std::function<void(std::uint64_t particles, double seconds, double error)>;

/// Traces particles in growing batches until a limit is reached, or none where no light shines.
/// Earlier particles count. Returns the error.
double runPaths(PathTracer& tracer, const BlockError& error, const PathLimits& limits,
                const PathProgress& progress = {});

}  // namespace opaline::reference

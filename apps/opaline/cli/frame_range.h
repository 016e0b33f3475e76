#pragma once

#include <cstddef>
#include <optional>

#include "cli/command_line.h"

namespace opaline::app {

/// The frames to render: the first, every step-th after it, and the last. Frame n shows time n /
/// perSecond.
struct FrameRange {
  int first = 0;
  int last = 0;  ///< a whole number of steps after the first
  double perSecond = 30;
  int step = 1;

  std::size_t count() const { return static_cast<std::size_t>((last - first) / step) + 1; }
  double seconds(int frame) const { return frame / perSecond; }
};

/// One of several programs that share the frames of a film.
struct Chunk {
  int number = 1;  ///< in [1, count]
  int count = 1;
};

/// The consecutive frames of a chunk. Chunks differ in length by at most one. None where there are
/// fewer frames than chunks and this chunk gets none.
std::optional<FrameRange> framesOf(const Chunk& chunk, const FrameRange& all);

/// Reads FIRST:LAST or FIRST:LAST:STEP. Throws UsageError.
FrameRange readFrames(const Given& given);

/// Reads NUMBER/COUNT. Throws UsageError.
Chunk readChunk(const Given& given);

/// Reads a number of frames per second. Throws UsageError.
double readFramesPerSecond(const Given& given);

}  // namespace opaline::app

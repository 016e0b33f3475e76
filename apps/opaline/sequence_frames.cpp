#include "sequence_frames.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "motion_options.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

[[noreturn]] void refuse(const MeshSequence& sequence, const std::string& what) {
  throw UsageError(fmt::format("{} is beyond the last of the sequence's {} files, {}", what,
                               sequence.frameCount(),
                               sequence.file(sequence.lastNumber()).string()));
}

}  // namespace

int numberOfFrame(const MeshSequence& sequence, int frame) {
  if (frame >= sequence.frameCount()) refuse(sequence, fmt::format("frame {}", frame));
  return sequence.firstNumber() + frame;
}

int numberAt(const MeshSequence& sequence, double seconds) {
  const double frame = std::round(seconds * FrameRange{}.perSecond);
  if (frame >= sequence.frameCount()) refuse(sequence, fmt::format("--time {}", seconds));
  return sequence.firstNumber() + static_cast<int>(frame);
}

}  // namespace opaline::app

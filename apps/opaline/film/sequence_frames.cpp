#include "film/sequence_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "opaline/error.h"

namespace opaline::app {

namespace {

[[noreturn]] void refuse(const MeshSequence& sequence, const std::string& what) {
  throw UsageError(
      fmt::format("{} is beyond the last of the sequence's {} files: frame {} shows {}", what,
                  sequence.frameCount(), sequence.frameCount() - 1,
                  sequence.file(sequence.lastNumber()).string()));
}

double frameAt(double seconds) {
  return std::round(seconds * FrameRange{}.perSecond);
}

}  // namespace

int numberOfFrame(const MeshSequence& sequence, int frame) {
  if (frame >= sequence.frameCount()) refuse(sequence, fmt::format("frame {}", frame));
  return sequence.firstNumber() + frame;
}

int numberAt(const MeshSequence& sequence, double seconds) {
  if (frameAt(seconds) >= sequence.frameCount()) {
    refuse(sequence, fmt::format("--time {}", seconds));
  }
  return nearestNumber(sequence, seconds);
}

int nearestNumber(const MeshSequence& sequence, double seconds) {
  const double frame = std::min(frameAt(seconds), sequence.frameCount() - 1.0);
  return sequence.firstNumber() + static_cast<int>(frame);
}

double shownAt(const MeshSequence* sequence, const FrameRange& frames, int frame) {
  return sequence != nullptr ? FrameRange{}.seconds(frame) : frames.seconds(frame);
}

double lastSecond(const MeshSequence& sequence) {
  return (sequence.frameCount() - 1) / FrameRange{}.perSecond;
}

double secondsOf(const MeshSequence& sequence) {
  return sequence.frameCount() / FrameRange{}.perSecond;
}

PositionsAhead positionsOf(std::shared_ptr<const MeshSequence> sequence, int lastNumber, int step,
                           std::shared_ptr<KeptPositions> kept) {
  return {lastNumber, step,
          [of = std::move(sequence), kept = std::move(kept)](int number,
                                                             std::vector<Vec3>& positionsMm) {
            if (!kept->take(number, positionsMm)) of->read(number, positionsMm);
          }};
}

}  // namespace opaline::app

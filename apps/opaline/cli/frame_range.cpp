#include "cli/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/values.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

constexpr int lastFrame = 999999;

}  // namespace

FrameRange readFrames(const Given& given) {
  const std::vector<std::string_view> ends = split(given.text, ':');
  if (ends.size() != 2 && ends.size() != 3) {
    throw UsageError(
        fmt::format("{} {}: must be FIRST:LAST or FIRST:LAST:STEP, as 0:239 or 0:239:10",
                    given.option, given.text));
  }
  FrameRange frames;
  frames.first = readInteger({given.option, std::string(ends[0]), given.text}, 0, lastFrame);
  frames.last = readInteger({given.option, std::string(ends[1]), given.text}, 0, lastFrame);
  if (frames.first > frames.last) {
    throw UsageError(
        fmt::format("{} {}: the last frame comes before the first", given.option, given.text));
  }
  if (ends.size() == 3) {
    frames.step = readInteger({given.option, std::string(ends[2]), given.text}, 1, lastFrame);
    frames.last -= (frames.last - frames.first) % frames.step;
  }
  return frames;
}

Chunk readChunk(const Given& given) {
  const std::vector<std::string_view> parts = split(given.text, '/');
  if (parts.size() != 2) {
    throw UsageError(fmt::format("{} {}: must be NUMBER/COUNT, as 1/6 for the first of six",
                                 given.option, given.text));
  }
  Chunk chunk;
  chunk.count = readInteger({given.option, std::string(parts[1]), given.text}, 1, lastFrame);
  chunk.number = readInteger({given.option, std::string(parts[0]), given.text}, 1, chunk.count);
  return chunk;
}

double readFramesPerSecond(const Given& given) {
  return readNumber(given, {1, 1000});
}

std::optional<FrameRange> framesOf(const Chunk& chunk, const FrameRange& all) {
  const auto count = static_cast<std::int64_t>(all.count());
  const std::int64_t begin = count * (chunk.number - 1) / chunk.count;
  const std::int64_t end = count * chunk.number / chunk.count;
  if (begin == end) return std::nullopt;
  FrameRange part = all;
  part.first = all.first + static_cast<int>(begin) * all.step;
  part.last = all.first + static_cast<int>(end - 1) * all.step;
  return part;
}

}  // namespace opaline::app

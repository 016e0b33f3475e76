#include "film/film_encoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "opaline/error.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* program = "ffmpeg";

fs::path foundFfmpeg() {
  std::optional<fs::path> found = findProgram(program);
  if (!found) {
    throw Error(
        "a film is made by the program ffmpeg, which is not installed: install it, or write "
        "numbered pictures with -o frame_%04d.png");
  }
  return *found;
}

int even(int pixels) {
  return pixels + pixels % 2;
}

/// The encoder is the first for H.264 that ffmpeg was built with, libx264 if available. The
/// pictures are full-range sRGB, but players expect limited-range BT.709, marked as such.
std::vector<std::string> argumentsFor(const fs::path& file, int width, int height,
                                      double framesPerSecond) {
  const std::string size = fmt::format("{}x{}", width, height);
  // A name that looks like an option or a protocol is still a file.
  const std::string target = "file:" + file.string();
  return {
      "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
      // input
      "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", size, "-framerate",
      fmt::format("{}", framesPerSecond), "-i", "pipe:0",
      // colour
      "-vf",
      "scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=accurate_rnd+full_chroma_int,"
      "format=yuv420p",
      "-color_primaries", "bt709", "-color_trc", "bt709", "-colorspace", "bt709", "-color_range",
      "tv",
      // output
      "-c:v", "h264", "-crf", "16", "-movflags", "+faststart", "-f", "mp4", target};
}

}  // namespace

void requireFfmpeg() {
  static_cast<void>(foundFfmpeg());
}

std::optional<std::string> noteOnFilmSize(int width, int height) {
  if (width == even(width) && height == even(height)) return std::nullopt;
  return fmt::format(
      "films have an even width and height, so this one of {}x{} has {}x{}, with its last row or "
      "column twice",
      width, height, even(width), even(height));
}

FilmEncoder::FilmEncoder(const fs::path& file, int width, int height, double framesPerSecond)
    : width_(even(width)),
      height_(even(height)),
      ffmpeg_(foundFfmpeg(), argumentsFor(file, width_, height_, framesPerSecond)) {}

void FilmEncoder::add(const Image8& picture) {
  constexpr std::size_t channels = 3;
  rgb_.resize(channels * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  auto out = rgb_.begin();
  for (int y = 0; y < height_; ++y) {
    const std::size_t row = static_cast<std::size_t>(std::min(y, picture.height - 1)) *
                            static_cast<std::size_t>(picture.width);
    for (int x = 0; x < width_; ++x) {
      const std::size_t pixel = row + static_cast<std::size_t>(std::min(x, picture.width - 1));
      const auto in = picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel);
      out = std::copy(in, in + channels, out);
    }
  }
  if (!ffmpeg_.write(rgb_)) fail();
}

void FilmEncoder::finish() {
  if (!ffmpeg_.finish()) fail();
}

void FilmEncoder::fail() {
  ffmpeg_.finish();
  const std::string words = ffmpeg_.lastWords();
  throw std::runtime_error(words.empty() ? "ffmpeg failed" : "ffmpeg says: " + words);
}

}  // namespace opaline::app

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/hdr_readers.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline::core {

namespace {

bool startsWith(std::span<const std::byte> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

}  // namespace

void failToReadImage(const std::filesystem::path& file, std::string_view reason) {
  throw Error(fmt::format("Cannot read {}: {}.", file.string(), reason));
}

void requireImageSize(const std::filesystem::path& file, long long width, long long height) {
  if (width >= 1 && height >= 1 && width <= largestImageEdge && height <= largestImageEdge) return;
  failToReadImage(file, fmt::format("it claims {}x{} pixels; accepted are 1x1 to {}x{}", width,
                                    height, largestImageEdge, largestImageEdge));
}

RowCollector::RowCollector(const std::filesystem::path& file, int width, int height,
                           std::size_t fileBytes, Negatives negatives)
    : file_(file), negatives_(negatives) {
  constexpr std::size_t plausibleFloatsPerByte = 64;
  image_.width = width;
  image_.height = height;
  const std::size_t floats =
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image_.rgba.reserve(std::min(floats, plausibleFloatsPerByte * fileBytes));
}

void RowCollector::append(std::span<const float> rgbaRows) {
  const bool finite = std::all_of(rgbaRows.begin(), rgbaRows.end(),
                                  [](float value) { return std::isfinite(value); });
  if (!finite) {
    failToReadImage(file_,
                    "it holds pixels that are infinite or not a number; save it as float "
                    "EXR if half floats overflowed");
  }
  const auto first = static_cast<std::ptrdiff_t>(image_.rgba.size());
  image_.rgba.insert(image_.rgba.end(), rgbaRows.begin(), rgbaRows.end());
  if (negatives_ == Negatives::Stay) return;
  std::for_each(image_.rgba.begin() + first, image_.rgba.end(),
                [](float& value) { value = std::max(value, 0.0F); });
}

Image RowCollector::take() {
  assert(image_.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image_.width) *
                                   static_cast<std::size_t>(image_.height));
  return std::move(image_);
}

}  // namespace opaline::core

namespace opaline {

Image readHdrImage(const std::filesystem::path& file, Negatives negatives) {
  // Uncompressed RGBE of the largest image, its run markers and a generous header.
  constexpr std::size_t edge = core::largestImageEdge;
  constexpr std::size_t limitBytes = edge * edge * 4 + edge * edge / 16 + (std::size_t{1} << 20U);
  constexpr std::string_view exrMagic = "\x76\x2f\x31\x01";
  constexpr std::string_view radianceMagic = "#?";

  const std::vector<std::byte> head = readFileHead(file, exrMagic.size());
  if (core::startsWith(head, exrMagic)) return core::readExr(file, negatives);
  if (core::startsWith(head, radianceMagic))
    return core::readRadiance(file, readFile(file, limitBytes));
  core::failToReadImage(file,
                        head.empty() ? "it is empty" : "it is neither OpenEXR nor Radiance RGBE");
}

}  // namespace opaline

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "opaline/image.h"
#include "opaline/image_file.h"

namespace opaline::core {

constexpr int largestImageEdge = 16384;

/// The two formats of readHdrImage.
Image readExr(const std::filesystem::path& file, Negatives negatives);
Image readRadiance(const std::filesystem::path& file, std::span<const std::byte> bytes);

[[noreturn]] void failToReadImage(const std::filesystem::path& file, std::string_view reason);

/// Throws Error when width or height is not in [1, largestImageEdge].
void requireImageSize(const std::filesystem::path& file, long long width, long long height);

/// Collects the pixels of an image row by row. A header alone cannot make it allocate much: it
/// reserves only as much memory as the length of the file makes plausible.
class RowCollector {
 public:
  RowCollector(const std::filesystem::path& file, int width, int height, std::size_t fileBytes,
               Negatives negatives);

  /// Appends whole rows of R G B A. Throws Error on infinities and NaN.
  void append(std::span<const float> rgbaRows);

  /// The image, after the last row.
  Image take();

 private:
  std::filesystem::path file_;
  Negatives negatives_;
  Image image_;
};

}  // namespace opaline::core

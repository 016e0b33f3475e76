#pragma once

#include <filesystem>
#include <optional>

#include "opaline/compare.h"
#include "opaline/image.h"
#include "opaline/image_file.h"
#include "opaline/tone.h"

namespace opaline::app {

/// Two images made ready for comparison. They hold the files' linear values or, when at least one
/// file is a PNG, sRGB-encoded values in [0,1].
struct ComparedImages {
  Image a;
  Image b;
  bool pictures = false;
  Image8 shownA;  ///< as a screen shows them, over black
  Image8 shownB;
};

struct CompareTone {
  std::optional<float> exposureStops;
  std::optional<ToneCurve> curve;
};

/// Throws Error when an image cannot be read or the sizes differ, and UsageError when `tone` asks
/// for what two PNG files cannot provide.
ComparedImages readCompared(const std::filesystem::path& a, const std::filesystem::path& b,
                            const CompareTone& tone);

/// Reads a mask. Throws Error unless it is as large as `image`, which was read from `imageFile`.
compare::Selection readMask(const std::filesystem::path& file, const Image& image,
                            const std::filesystem::path& imageFile);

}  // namespace opaline::app

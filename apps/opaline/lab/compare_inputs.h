#pragma once

#include <filesystem>
#include <optional>

#include "opaline/compare.h"
#include "opaline/image.h"
#include "opaline/image_file.h"
#include "opaline/tone.h"

namespace opaline::app {

/// Two images made ready to be compared: linear values as their files hold them, or, when at least
/// one is a PNG, pictures: sRGB-encoded values in [0,1].
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

/// Throws Error when one cannot be read or they differ in size, UsageError when `tone` asks for
/// what two PNG pictures cannot do.
ComparedImages readCompared(const std::filesystem::path& a, const std::filesystem::path& b,
                            const CompareTone& tone);

/// Throws Error unless the mask is as large as `image`, which is that of `imageFile`.
compare::Selection readMask(const std::filesystem::path& file, const Image& image,
                            const std::filesystem::path& imageFile);

}  // namespace opaline::app

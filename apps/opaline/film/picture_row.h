#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/frame_range.h"
#include "opaline/image.h"

namespace opaline::app {

/// Numbered pictures, as chunks of a film leave them.
struct PictureRow {
  std::filesystem::path names;  ///< a folder and a name with one %d or %0Nd
  FrameRange frames;

  std::filesystem::path file(int frame) const;
  bool isExr() const;
};

/// The row in a folder that has one, or whose names are given. Without `frames` it goes from the
/// smallest number there is to the largest. Throws Error where there is none, and UsageError where
/// there are several.
PictureRow findPictureRow(const std::filesystem::path& given,
                          const std::optional<FrameRange>& frames);

/// The picture of a frame, linear. Throws Error.
Image readPicture(const PictureRow& row, int frame);

/// Throws Error that counts and numbers what is missing or not whole, judged by the ends of the
/// files, or that names the first of another size.
void requireWhole(const PictureRow& row);

/// The speed at which the pictures were rendered, where their stamps tell.
std::optional<double> framesPerSecondOf(const PictureRow& row);

/// A sentence about pictures that were made with another scene or other options than the first, or
/// nothing.
std::optional<std::string> noteOnOthers(const PictureRow& row);

}  // namespace opaline::app

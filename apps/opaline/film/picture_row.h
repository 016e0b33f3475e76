#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/frame_range.h"
#include "opaline/image.h"

namespace opaline::app {

/// Numbered pictures, as the chunks of a film leave them.
struct PictureRow {
  std::filesystem::path names;  ///< a folder and a name with one %d or %0Nd
  FrameRange frames;

  std::filesystem::path file(int frame) const;
  bool isExr() const;
};

/// The row in a folder, or the row with the given names. Without `frames` it spans from the
/// smallest existing number to the largest. Throws Error where there is none, and UsageError where
/// there are several.
PictureRow findPictureRow(const std::filesystem::path& given,
                          const std::optional<FrameRange>& frames);

/// The picture of a frame in linear colours. Throws Error.
Image readPicture(const PictureRow& row, int frame);

/// Throws Error with the numbers of missing or incomplete pictures, judged by the ends of the
/// files, or with the first picture of another size.
void requireWhole(const PictureRow& row);

/// The frame rate of the rendering, where the pictures' stamps tell it.
std::optional<double> framesPerSecondOf(const PictureRow& row);

/// A sentence about pictures that were made with another scene or other options than the first;
/// none where all agree.
std::optional<std::string> noteOnOthers(const PictureRow& row);

}  // namespace opaline::app

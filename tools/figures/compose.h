#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "opaline/image.h"
#include "opaline/image_file.h"
#include "opaline/types.h"

namespace opaline::figures {

/// The mean of every two by two pixels, weighted by coverage; an odd last row or column is dropped.
Image halved(const Image& image);

/// Background colour under a picture and between its panels: R, G, B from 0 to 255.
using Paper = std::array<std::uint8_t, 3>;

/// Values in [0,1] unchanged, without a tone curve or sRGB, over the paper.
Image8 plain(const Image& image, const Paper& paper);

/// The picture at the left of a sheet at least that wide.
Image8 padded(const Image8& picture, int width, const Paper& paper);

/// Arranges panels of one size from left to right and from top to bottom, with `gap` pixels of
/// paper between them. Throws std::invalid_argument where there is no panel or the sizes differ.
Image8 sheet(const std::vector<Image8>& panels, int columns, int gap, const Paper& paper);

/// All six faces of a cube map as a cross of four by three faces with +z in the middle. Faces that
/// meet in the picture meet in the cube. Pixels outside have no coverage.
Image cubeCross(int faceSize, const std::function<Rgb(const Vec3& direction)>& colour);

}  // namespace opaline::figures

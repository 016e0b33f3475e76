#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/export.h"
#include "opaline/image.h"

namespace opaline::compare {

/// One number a pixel, rows from top to bottom.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int widthPixels, int heightPixels)
      : width(widthPixels),
        height(heightPixels),
        values(static_cast<std::size_t>(widthPixels) * static_cast<std::size_t>(heightPixels)) {}
};

/// Which pixels count, 1 or 0, rows from top to bottom.
using Selection = std::vector<std::uint8_t>;

/// Pixels that both images cover: alpha above 0. Here and below, images of different sizes, numbers
/// out of range, and selected values that are not finite are a UsageError.
OPALINE_API Selection commonPixels(const Image& a, const Image& b);

/// Pixels that the mask covers and where its largest channel is above 0.5.
OPALINE_API Selection maskedPixels(const Image& mask);

/// How many pixels are in it.
OPALINE_API std::size_t countOf(const Selection& selection);

/// Errors of A against B. What is relative is over the mean of |B|; where that is 0, it is 0 if all
/// errors are and infinite otherwise.
struct ErrorFigures {
  double relRmse = 0;
  double relBias = 0;  ///< mean of A - B, negative where A is too dark
  double p95Rel = 0;   ///< 95th percentile of |A - B|, linear between the ranks next to it
  double maxAbs = 0;
  double psnrDb = 0;  ///< 10 log10(peak²/MSE), infinite for equal images
};

/// Of one image against another, over the pixels that are selected.
struct Figures {
  std::size_t coveredPixels = 0;
  ErrorFigures all;  ///< over the values of all three channels
  std::array<ErrorFigures, 3> channels;
};

/// No figures when nothing is selected. Without a peak it is the largest value of B over the
/// selected pixels, the same for all channels.
OPALINE_API std::optional<Figures> figuresOver(const Image& a, const Image& b,
                                               const Selection& selection,
                                               std::optional<double> peak = {});

/// The same for blocks of pixels, in which the noise of a reference mostly cancels. The value of a
/// block is the sum over its selected pixels over the number of pixels it has when whole; blocks
/// begin in the upper left corner.
struct BlockFigures {
  int edgePixels = 0;
  std::size_t blocks = 0;
  std::size_t coveredBlocks = 0;  ///< with at least one selected pixel
  double relRmse = 0;         ///< RMSE over all blocks, over the mean of |B| over selected pixels
  double coveredRelRmse = 0;  ///< the same with the RMSE over covered blocks
  std::array<double, 3> channelRelRmse{};
};

/// The same of means over blocks of pixels; none where no block is covered.
OPALINE_API std::optional<BlockFigures> blockFiguresOver(const Image& a, const Image& b,
                                                         const Selection& selection,
                                                         int edgePixels);

/// Of each selected pixel, |A - B| over the mean of |B|, averaged over the channels; 0 elsewhere.
OPALINE_API Plane relativeErrors(const Image& a, const Image& b, const Selection& selection);

/// The same of the means of blocks: every selected pixel has the error of its block.
OPALINE_API Plane relativeBlockErrors(const Image& a, const Image& b, const Selection& selection,
                                      int edgePixels);

/// Of the pixels that are selected.
OPALINE_API double meanOver(const Plane& plane, const Selection& selection);

/// Of an image's first channel, over the pixels it covers; 0 where it covers none.
OPALINE_API double meanOverCovered(const Image& image);

/// The least of 1, 2 and 5 times a power of ten, from 1e-5 on, that no more than 1 % of the
/// selected errors exceed.
OPALINE_API double heatmapTop(const Plane& errors, const Selection& selection);

/// Relative errors in colors of equal steps from 0 to `top`, above 0, with a scale in percent at
/// the right; where nothing is selected the picture is white.
OPALINE_API Image8 drawHeatmap(const Plane& errors, const Selection& selection, double top);

/// Andersson et al. 2020's usual viewer: 0.7 m from a 0.7 m wide screen of 3840 pixels.
inline constexpr double usualPixelsPerDegree = 67.020643;

/// The difference that somebody sees who flips between two pictures, in [0,1] for each pixel:
/// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
/// Evaluator for Alternating Images". Alpha is not looked at. Both pictures have the same size;
/// `pixelsPerDegree` of visual angle lies in [1, 1000].
OPALINE_API Plane flipMap(const Image8& a, const Image8& b,
                          double pixelsPerDegree = usualPixelsPerDegree);

}  // namespace opaline::compare

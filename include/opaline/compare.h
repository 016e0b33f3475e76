#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/export.h"
#include "opaline/image.h"

namespace opaline::compare {

/// One number per pixel, rows from top to bottom.
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

/// Pixels that both images cover: alpha above 0. Like the functions below, it throws UsageError for
/// images of different sizes, numbers out of range, and selected values that are not finite.
OPALINE_API Selection commonPixels(const Image& a, const Image& b);

/// Pixels that the mask covers and where its largest channel is above 0.5.
OPALINE_API Selection maskedPixels(const Image& mask);

/// How many pixels a selection has.
OPALINE_API std::size_t countOf(const Selection& selection);

/// Errors of A against B. Relative errors are divided by the mean of |B|; if that is 0, they are 0
/// if all errors are, else infinite.
struct ErrorFigures {
  double relRmse = 0;
  double relBias = 0;  ///< mean of A - B, negative where A is too dark
  double p95Rel = 0;   ///< 95th percentile of |A - B|, linear between the ranks next to it
  double maxAbs = 0;
  double psnrDb = 0;  ///< 10 log10(peak²/MSE), infinite for equal images
};

/// Errors of one image against another, over the selected pixels.
struct Figures {
  std::size_t coveredPixels = 0;
  ErrorFigures all;  ///< over the values of all three channels
  std::array<ErrorFigures, 3> channels;
};

/// Compares the selected pixels; no figures if nothing is selected. Without a value, `peak` is the
/// largest value of B over the selected pixels and all channels.
OPALINE_API std::optional<Figures> figuresOver(const Image& a, const Image& b,
                                               const Selection& selection,
                                               std::optional<double> peak = {});

/// Errors of blocks of pixels, in which the noise of a reference mostly cancels. A block's value is
/// the sum over its selected pixels, divided by the number of pixels in a whole block. Blocks begin
/// in the upper left corner.
struct BlockFigures {
  int edgePixels = 0;
  std::size_t blocks = 0;
  std::size_t coveredBlocks = 0;  ///< with at least one selected pixel
  double relRmse = 0;  ///< RMSE over all blocks, divided by the mean of |B| over selected pixels
  double coveredRelRmse = 0;  ///< the same with the RMSE over covered blocks
  std::array<double, 3> channelRelRmse{};
};

/// Compares blocks of pixels; no figures if no block is covered.
OPALINE_API std::optional<BlockFigures> blockFiguresOver(const Image& a, const Image& b,
                                                         const Selection& selection,
                                                         int edgePixels);

/// For each selected pixel, |A - B| divided by the mean of |B|, averaged over the channels; 0
/// elsewhere.
OPALINE_API Plane relativeErrors(const Image& a, const Image& b, const Selection& selection);

/// The same for blocks: every selected pixel has the error of its block.
OPALINE_API Plane relativeBlockErrors(const Image& a, const Image& b, const Selection& selection,
                                      int edgePixels);

/// The mean over the selected pixels.
OPALINE_API double meanOver(const Plane& plane, const Selection& selection);

/// The mean of an image's first channel over the pixels it covers; 0 if it covers none.
OPALINE_API double meanOverCovered(const Image& image);

/// The top of a heatmap's scale: the least of 1, 2 and 5 times a power of ten, from 1e-5 on, that
/// no more than 1 % of the selected errors exceed.
OPALINE_API double heatmapTop(const Plane& errors, const Selection& selection);

/// Relative errors as colors in perceptually equal steps from 0 to `top`, which is above 0, with a
/// scale in percent at the right. Pixels that are not selected are white; if every N-th column and
/// row is selected, each selected pixel fills a square of NxN.
OPALINE_API Image8 drawHeatmap(const Plane& errors, const Selection& selection, double top);

/// Andersson et al. 2020's usual viewer: 0.7 m from a 0.7 m wide screen of 3840 pixels.
inline constexpr double usualPixelsPerDegree = 67.020643;

/// The difference that a viewer sees when flipping between two pictures, in [0,1] for each pixel:
/// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
/// Evaluator for Alternating Images". Alpha is ignored. Both pictures must have the same size;
/// `pixelsPerDegree` of visual angle is in [1, 1000].
OPALINE_API Plane flipMap(const Image8& a, const Image8& b,
                          double pixelsPerDegree = usualPixelsPerDegree);

}  // namespace opaline::compare

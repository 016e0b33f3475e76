#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/plane.h"
#include "opaline/image.h"

namespace opaline::compare {

/// Which pixels count, 1 or 0, rows from top to bottom.
using Selection = std::vector<std::uint8_t>;

/// Pixels that both images cover: alpha above 0. Both have the same size, here and below.
Selection commonPixels(const Image& a, const Image& b);

/// Pixels that the mask covers and where its largest channel is above 0.5.
Selection maskedPixels(const Image& mask);

std::size_t countOf(const Selection& selection);

/// Errors of A against B. What is relative is over the mean of |B|; where that is 0, it is 0 if all
/// errors are and infinite otherwise.
struct ErrorFigures {
  double relRmse = 0;
  double relBias = 0;  ///< mean of A - B, negative where A is too dark
  double p95Rel = 0;   ///< 95th percentile of |A - B|, linear between the ranks next to it
  double maxAbs = 0;
  double psnrDb = 0;  ///< 10 log10(peak²/MSE), infinite for equal images
};

struct Figures {
  std::size_t coveredPixels = 0;
  ErrorFigures all;  ///< over the values of all three channels
  std::array<ErrorFigures, 3> channels;
};

/// No figures when nothing is selected. Without a peak it is the largest value of B over the
/// selected pixels, the same for all channels.
std::optional<Figures> figuresOver(const Image& a, const Image& b, const Selection& selection,
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

std::optional<BlockFigures> blockFiguresOver(const Image& a, const Image& b,
                                             const Selection& selection, int edgePixels);

/// Of each selected pixel, |A - B| over the mean of |B|, averaged over the channels; 0 elsewhere.
Plane relativeErrors(const Image& a, const Image& b, const Selection& selection);

/// The same of the means of blocks: every selected pixel has the error of its block.
Plane relativeBlockErrors(const Image& a, const Image& b, const Selection& selection,
                          int edgePixels);

double meanOver(const Plane& plane, const Selection& selection);

/// Of an image's first channel, over the pixels it covers; 0 where it covers none.
double meanOverCovered(const Image& image);

}  // namespace opaline::compare

#include "opaline/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sound_image.h"
#include "opaline/error.h"

namespace opaline::compare {

namespace {

constexpr std::size_t channels = 3;

double ratio(double error, double mean) {
  if (error == 0) return 0;
  return mean > 0 ? error / mean : std::copysign(std::numeric_limits<double>::infinity(), error);
}

/// Sums from which the figures of some values follow.
struct Sums {
  std::size_t count = 0;
  double squares = 0;
  double differences = 0;  ///< of A - B
  double reference = 0;    ///< of |B|
  double largest = 0;

  void add(double a, double b) {
    const double error = std::abs(a - b);
    ++count;
    squares += error * error;
    differences += a - b;
    reference += std::abs(b);
    largest = std::max(largest, error);
  }
  void add(const Sums& other) {
    count += other.count;
    squares += other.squares;
    differences += other.differences;
    reference += other.reference;
    largest = std::max(largest, other.largest);
  }
  double mean() const { return reference / static_cast<double>(count); }
  double meanDifference() const { return differences / static_cast<double>(count); }
  double meanSquare() const { return squares / static_cast<double>(count); }
};

/// Requires at least one value, and reorders the values.
double percentile(std::vector<float>& values, double share) {
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(rank);
  const auto middle = values.begin() + below;
  std::nth_element(values.begin(), middle, values.end());
  const auto next =
      middle + 1 == values.end() ? middle : std::min_element(middle + 1, values.end());
  return std::lerp(static_cast<double>(*middle), static_cast<double>(*next),
                   rank - static_cast<double>(below));
}

ErrorFigures toFigures(const Sums& sums, std::vector<float>& errors, double peak) {
  ErrorFigures figures;
  figures.relRmse = ratio(std::sqrt(sums.meanSquare()), sums.mean());
  figures.relBias = ratio(sums.meanDifference(), sums.mean());
  figures.p95Rel = ratio(percentile(errors, 0.95), sums.mean());
  figures.maxAbs = sums.largest;
  figures.psnrDb = sums.squares > 0 ? 10 * std::log10(peak * peak / sums.meanSquare())
                                    : std::numeric_limits<double>::infinity();
  return figures;
}

template <typename Function>
void forEachSelected(const Selection& selection, Function function) {
  for (std::size_t i = 0; i < selection.size(); ++i) {
    if (selection[i] != 0) function(i);
  }
}

double valueOf(const Image& image, std::size_t pixel, std::size_t channel) {
  return static_cast<double>(image.rgba[4 * pixel + channel]);
}

double meanMagnitude(const Image& image, const Selection& selection, std::size_t channel) {
  double sum = 0;
  forEachSelected(selection, [&](std::size_t i) { sum += std::abs(valueOf(image, i, channel)); });
  return sum / static_cast<double>(countOf(selection));
}

/// Blocks from the upper left corner on; the last ones may reach beyond the border.
struct Blocks {
  Blocks(const Image& image, int edgePixels)
      : edge(static_cast<std::size_t>(edgePixels)),
        width(static_cast<std::size_t>(image.width)),
        across((width + edge - 1) / edge),
        count(across * ((static_cast<std::size_t>(image.height) + edge - 1) / edge)) {}

  std::size_t of(std::size_t pixel) const {
    return pixel / width / edge * across + pixel % width / edge;
  }

  /// A's block means minus B's, in one channel.
  std::vector<double> differences(const Image& a, const Image& b, const Selection& selection,
                                  std::size_t channel) const {
    const double pixels = static_cast<double>(edge) * static_cast<double>(edge);
    std::vector<double> result(count);
    forEachSelected(selection, [&](std::size_t i) {
      result[of(i)] += (valueOf(a, i, channel) - valueOf(b, i, channel)) / pixels;
    });
    return result;
  }

  std::size_t edge;
  std::size_t width;
  std::size_t across;
  std::size_t count;
};

/// The mean of |B| over all channels.
double meanMagnitude(const Image& b, const Selection& selection) {
  double mean = 0;
  for (std::size_t c = 0; c < channels; ++c) mean += meanMagnitude(b, selection, c) / channels;
  return mean;
}

/// The relative error, kept finite so that it can be drawn.
float paintable(double error, double mean) {
  return static_cast<float>(std::min(ratio(error, mean), 1e30));
}

void require(bool met, const char* otherwise) {
  if (!met) throw UsageError(otherwise);
}

void requireOneSize(const Image& a, const Image& b) {
  require(a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size(),
          "images that are compared must have the same size");
  core::requireSound(a);
  core::requireSound(b);
}

void requireComparable(const Image& a, const Image& b, const Selection& selection) {
  requireOneSize(a, b);
  require(4 * selection.size() == a.rgba.size(), "a selection must have one number a pixel");
  forEachSelected(selection, [&](std::size_t i) {
    for (std::size_t c = 0; c < channels; ++c) {
      require(std::isfinite(valueOf(a, i, c)),
              "the first picture has a pixel that is infinite or not a number");
      require(std::isfinite(valueOf(b, i, c)),
              "the second picture has a pixel that is infinite or not a number");
    }
  });
}

void requireEdge(int edgePixels) {
  require(edgePixels > 0, "blocks must be at least one pixel wide");
}

}  // namespace

Selection commonPixels(const Image& a, const Image& b) {
  requireOneSize(a, b);
  Selection selection(a.rgba.size() / 4);
  for (std::size_t i = 0; i < selection.size(); ++i) {
    selection[i] = a.rgba[4 * i + 3] > 0 && b.rgba[4 * i + 3] > 0 ? 1 : 0;
  }
  return selection;
}

Selection maskedPixels(const Image& mask) {
  Selection selection(mask.rgba.size() / 4);
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const float* const pixel = &mask.rgba[4 * i];
    const float largest = std::max({pixel[0], pixel[1], pixel[2]});
    selection[i] = pixel[3] > 0 && largest > 0.5F ? 1 : 0;
  }
  return selection;
}

std::size_t countOf(const Selection& selection) {
  return static_cast<std::size_t>(
      std::count_if(selection.begin(), selection.end(), [](auto one) { return one != 0; }));
}

std::optional<Figures> figuresOver(const Image& a, const Image& b, const Selection& selection,
                                   std::optional<double> peak) {
  requireComparable(a, b, selection);
  Figures figures;
  figures.coveredPixels = countOf(selection);
  if (figures.coveredPixels == 0) return {};

  double largest = 0;
  std::array<Sums, channels> sums;
  std::array<std::vector<float>, channels> errors;
  for (std::size_t c = 0; c < channels; ++c) {
    errors[c].reserve(figures.coveredPixels);
    forEachSelected(selection, [&](std::size_t i) {
      const double valueA = valueOf(a, i, c);
      const double valueB = valueOf(b, i, c);
      sums[c].add(valueA, valueB);
      errors[c].push_back(static_cast<float>(std::abs(valueA - valueB)));
      largest = std::max(largest, valueB);
    });
  }

  Sums together;
  std::vector<float> allErrors;
  for (std::size_t c = 0; c < channels; ++c) {
    figures.channels[c] = toFigures(sums[c], errors[c], peak.value_or(largest));
    together.add(sums[c]);
    allErrors.insert(allErrors.end(), errors[c].begin(), errors[c].end());
  }
  figures.all = toFigures(together, allErrors, peak.value_or(largest));
  return figures;
}

std::optional<BlockFigures> blockFiguresOver(const Image& a, const Image& b,
                                             const Selection& selection, int edgePixels) {
  requireComparable(a, b, selection);
  requireEdge(edgePixels);
  if (countOf(selection) == 0) return {};

  const Blocks blocks(a, edgePixels);
  BlockFigures figures;
  figures.edgePixels = edgePixels;
  figures.blocks = blocks.count;
  Selection covered(blocks.count);
  forEachSelected(selection, [&](std::size_t i) { covered[blocks.of(i)] = 1; });
  figures.coveredBlocks = countOf(covered);

  double allSquares = 0;
  for (std::size_t c = 0; c < channels; ++c) {
    double squares = 0;
    for (const double difference : blocks.differences(a, b, selection, c)) {
      squares += difference * difference;
    }
    figures.channelRelRmse[c] = ratio(std::sqrt(squares / static_cast<double>(blocks.count)),
                                      meanMagnitude(b, selection, c));
    allSquares += squares / channels;
  }
  const double mean = meanMagnitude(b, selection);
  figures.relRmse = ratio(std::sqrt(allSquares / static_cast<double>(blocks.count)), mean);
  figures.coveredRelRmse =
      ratio(std::sqrt(allSquares / static_cast<double>(figures.coveredBlocks)), mean);
  return figures;
}

Plane relativeErrors(const Image& a, const Image& b, const Selection& selection) {
  requireComparable(a, b, selection);
  const double mean = meanMagnitude(b, selection);
  Plane plane(a.width, a.height);
  forEachSelected(selection, [&](std::size_t i) {
    double error = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      error += std::abs(valueOf(a, i, c) - valueOf(b, i, c)) / channels;
    }
    plane.values[i] = paintable(error, mean);
  });
  return plane;
}

Plane relativeBlockErrors(const Image& a, const Image& b, const Selection& selection,
                          int edgePixels) {
  requireComparable(a, b, selection);
  requireEdge(edgePixels);
  const Blocks blocks(a, edgePixels);
  std::vector<double> errors(blocks.count);
  for (std::size_t c = 0; c < channels; ++c) {
    const std::vector<double> differences = blocks.differences(a, b, selection, c);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i] += std::abs(differences[i]) / channels;
    }
  }
  const double mean = meanMagnitude(b, selection);
  Plane plane(a.width, a.height);
  forEachSelected(selection,
                  [&](std::size_t i) { plane.values[i] = paintable(errors[blocks.of(i)], mean); });
  return plane;
}

double meanOver(const Plane& plane, const Selection& selection) {
  require(plane.values.size() == selection.size(), "a selection must have one number a pixel");
  double sum = 0;
  forEachSelected(selection, [&](std::size_t i) { sum += static_cast<double>(plane.values[i]); });
  const std::size_t count = countOf(selection);
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

double meanOverCovered(const Image& image) {
  double sum = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] <= 0) continue;
    sum += double{image.rgba[i]};
    ++covered;
  }
  return covered > 0 ? sum / static_cast<double>(covered) : 0;
}

}  // namespace opaline::compare

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {

/// Of one picture beside another, over all channels of the pixels that it covers.
struct SumErrors {
  double rms = 0;           ///< relative to the picture's mean
  double localLargest = 0;  ///< relative to the pixel, or to a twentieth of its brightest channel
  int pixels = 0;
};

inline std::array<double, 3> meanOf(const Image& image) {
  std::array<double, 3> sum{};
  const int count = forEachCovered(image, [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(image.rgba[i + c]);
  });
  for (double& value : sum) value /= std::max(count, 1);
  return sum;
}

/// Of the pixels for which `counts(index)`.
template <typename Counts>
SumErrors errorsWhere(const Image& found, const Image& exact, const Counts& counts) {
  const std::array<double, 3> mean = meanOf(exact);
  SumErrors errors;
  forEachCovered(exact, [&](std::size_t i) {
    if (!counts(i)) return;
    ++errors.pixels;
    const auto brightest =
        static_cast<double>(std::max({exact.rgba[i], exact.rgba[i + 1], exact.rgba[i + 2]}));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = static_cast<double>(exact.rgba[i + c]);
      const double off = std::abs(static_cast<double>(found.rgba[i + c]) - value);
      const double relative = off / mean[c];
      const double local = off / std::max({value, brightest / 20, 1e-30});
      errors.rms += relative * relative;
      errors.localLargest = std::max(errors.localLargest, local);
    }
  });
  errors.rms = std::sqrt(errors.rms / (3.0 * errors.pixels));
  return errors;
}

inline SumErrors errorsOf(const Image& found, const Image& exact) {
  return errorsWhere(found, exact, [](std::size_t) { return true; });
}

/// Exitance of the scene that is set by Sum::Tree, and by Sum::All.
struct TreeAndAll {
  Image tree;
  Image all;
};

inline TreeAndAll treeAndAll(RenderOptions options) {
  Renderer& renderer = *sharedRenderer().renderer;
  options.sum = Sum::Tree;
  TreeAndAll images{renderer.render(options, {Aov::Exitance}).images[0], {}};
  options.sum = Sum::All;
  images.all = renderer.render(options, {Aov::Exitance}).images[0];
  return images;
}

/// The bear lit from behind.
inline Scene backlitBear(float diagonalMm, const Medium& medium) {
  LoadOptions load;
  load.diagonalMm = diagonalMm;
  load.medium = medium;
  Scene scene = builtInBear(load);
  constexpr auto pi = std::numbers::pi_v<float>;
  scene.lighting = {};
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {pi, pi, pi}}};
  return scene;
}

}  // namespace opaline::test

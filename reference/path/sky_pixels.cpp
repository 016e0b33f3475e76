#include "reference/path/sky_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "environment/lat_long.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;

}  // namespace

SkyPixels::SkyPixels(const Image& image, const Colour& weights) : image_(image) {
  sumsSoFar_.reserve(image.rgba.size() / 4);
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    const double each = solidAngle(y);
    for (int x = 0; x < image.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        sum += weights[c] * std::max(double{image.pixel(x, y)[c]}, 0.0) * each;
      sumsSoFar_.push_back(sum);
    }
  }
}

double SkyPixels::solidAngle(int row) const {
  const double top = std::cos(pi * row / image_.height);
  const double bottom = std::cos(pi * (row + 1) / image_.height);
  return 2 * pi / image_.width * (top - bottom);
}

Vector SkyPixels::direction(Random& random) const {
  const double wanted = random() * sum();
  const auto found = std::upper_bound(sumsSoFar_.begin(), sumsSoFar_.end(), wanted);
  const auto index = static_cast<int>(std::min<std::ptrdiff_t>(
      found - sumsSoFar_.begin(), static_cast<std::ptrdiff_t>(sumsSoFar_.size()) - 1));
  const int x = index % image_.width;
  const int y = index / image_.width;
  // Uniform in solid angle within the pixel: in the cosine of the polar angle.
  const double top = std::cos(pi * y / image_.height);
  const double bottom = std::cos(pi * (y + 1) / image_.height);
  const double v = std::acos(std::clamp(top + (bottom - top) * random(), -1.0, 1.0)) / pi;
  return toVector(latLongDirection((x + random()) / image_.width, v));
}

std::size_t SkyPixels::pixelAt(const Vector& direction) const {
  const auto [u, v] = latLongCoordinates(toFloat(direction));
  const int x = std::clamp(static_cast<int>(u * image_.width), 0, image_.width - 1);
  const int y = std::clamp(static_cast<int>(v * image_.height), 0, image_.height - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
         static_cast<std::size_t>(x);
}

double SkyPixels::density(const Vector& direction) const {
  if (!(sum() > 0)) return 0;
  const std::size_t pixel = pixelAt(direction);
  const double own = sumsSoFar_[pixel] - (pixel > 0 ? sumsSoFar_[pixel - 1] : 0);
  const int row = static_cast<int>(pixel) / image_.width;
  return own / sum() / solidAngle(row);
}

Colour SkyPixels::radiance(const Vector& direction) const {
  const float* pixel = &image_.rgba[4 * pixelAt(direction)];
  Colour radiance{};
  for (std::size_t c = 0; c < 3; ++c) radiance[c] = std::max(double{pixel[c]}, 0.0);
  return radiance;
}

}  // namespace opaline::reference

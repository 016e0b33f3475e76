#include "environment/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "environment/lat_long.h"

namespace opaline {

namespace {

using std::numbers::pi;
using Colour = std::array<double, 3>;

// Calls part(index, from, to) for every one of `parts` parts that pixel `i` of `pixels` covers;
// `from` and `to` are the ends of the covered stretch, in parts.
template <typename Part>
void forEachCovered(int i, int pixels, int parts, const Part& part) {
  const double from = static_cast<double>(i) * parts / pixels;
  const double to = static_cast<double>(i + 1) * parts / pixels;
  for (int k = static_cast<int>(from); k < parts && k < to; ++k)
    part(static_cast<std::size_t>(k), std::max(from, static_cast<double>(k)),
         std::min(to, static_cast<double>(k + 1)));
}

double cosineAt(double row) {
  return std::cos(pi * row / SkyParts::height);
}

// Adds up a row's radiance times width in each column of the parts.
void addRow(const Image& image, int y, std::vector<Colour>& columns) {
  std::fill(columns.begin(), columns.end(), Colour{});
  const float* pixel = image.pixel(0, y);
  for (int x = 0; x < image.width; ++x, pixel += 4)
    forEachCovered(x, image.width, SkyParts::width, [&](std::size_t k, double from, double to) {
      for (std::size_t c = 0; c < 3; ++c) columns[k][c] += (to - from) * double{pixel[c]};
    });
}

// Means over the parts, row by row.
std::vector<Colour> meansOf(const Image& image) {
  std::vector<Colour> means(SkyParts::count);
  std::vector<Colour> columns(SkyParts::width);
  for (int y = 0; y < image.height; ++y) {
    addRow(image, y, columns);
    forEachCovered(y, image.height, SkyParts::height, [&](std::size_t row, double from, double to) {
      const auto top = static_cast<double>(row);
      const double share = (cosineAt(from) - cosineAt(to)) / (cosineAt(top) - cosineAt(top + 1));
      for (std::size_t k = 0; k < columns.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
          means[row * SkyParts::width + k][c] += share * columns[k][c];
    });
  }
  return means;
}

}  // namespace

bool skyIsDark(const Lighting& lighting) {
  return !lighting.environment && lighting.ambient == Rgb{0, 0, 0};
}

bool sameSky(const Lighting& a, const Lighting& b) {
  return a.ambient == b.ambient && a.environment == b.environment;
}

Rgb SkyParts::radianceAt(const Vec3& direction) const {
  if (parts.empty()) return ambient;
  const auto [u, v] = latLongCoordinates(direction);
  const int x = std::clamp(static_cast<int>(u * width), 0, width - 1);
  const int y = std::clamp(static_cast<int>(v * height), 0, height - 1);
  Rgb radiance = parts[static_cast<std::size_t>(y * width + x)].radiance;
  for (std::size_t c = 0; c < 3; ++c) radiance[c] += ambient[c];
  return radiance;
}

SkyParts partsOfSky(const Lighting& lighting) {
  SkyParts sky{lighting.ambient, {}};
  const Image* image = lighting.environment.get();
  if (image == nullptr || image->width == 0 || image->height == 0) return sky;
  const std::vector<Colour> means = meansOf(*image);
  sky.parts.reserve(means.size());
  for (int y = 0; y < SkyParts::height; ++y) {
    const double solidAngle = 2 * pi / SkyParts::width * (cosineAt(y) - cosineAt(y + 1));
    for (int x = 0; x < SkyParts::width; ++x) {
      const Colour& mean = means[sky.parts.size()];
      sky.parts.push_back(
          {latLongDirection((x + 0.5) / SkyParts::width, (y + 0.5) / SkyParts::height),
           static_cast<float>(solidAngle),
           {static_cast<float>(mean[0]), static_cast<float>(mean[1]),
            static_cast<float>(mean[2])}});
    }
  }
  return sky;
}

}  // namespace opaline

#include "environment/suns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "environment/halved.h"
#include "environment/lat_long.h"
#include "opaline/error.h"

namespace opaline {

namespace {

using std::numbers::pi;

constexpr int mostColumns = 2048;          // so many that a sun is several pixels wide
constexpr double brightness = 30;          // relative to the mean
constexpr double leastPart = 0.01;         // of all light
constexpr double largestRadius = pi / 36;  // 5°
constexpr double surroundings = pi * 25 / 180;
constexpr std::size_t mostSamples = 20'000;  // taken from the surroundings

using Colour = std::array<double, 3>;

// ITU-R BT.709.
double luminance(const float* rgb) {
  return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
}

double dot(const Vec3& a, const std::array<double, 3>& b) {
  return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
}

struct Place {
  int x = 0;
  int y = 0;
};

// A part of the environment that may be a sun.
struct Spot {
  std::vector<Place> pixels;
  std::array<double, 3> towards{};  // unit
  double radius = 0;                // angle of a disc whose mean direction has the same length
  Colour around{};                  // radiance
  Colour irradiance{};              // above `around`, on a surface that faces the spot
};

class SunFinder {
 public:
  explicit SunFinder(const Image& image) : image_(image), seen_(pixelCount(), 0) {
    for (int y = 0; y < image_.height; ++y) {
      const double top = std::cos(pi * y / image_.height);
      const double bottom = std::cos(pi * (y + 1) / image_.height);
      solidAngleOfRow_.push_back(2 * pi / image_.width * (top - bottom));
    }
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x)
        allLight_ += solidAngleOfRow_[index(y)] * luminance(image_.pixel(x, y));
  }

  // Brightest first.
  std::vector<Spot> find() {
    std::vector<Spot> spots;
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x) {
        if (!isBright({x, y}) || wasSeen({x, y})) continue;
        std::vector<Place> pixels = connectedTo({x, y});
        // There may be very many faint ones, and measuring one takes long.
        if (!(grossLightOf(pixels) > leastPart * allLight_)) continue;
        Spot spot = measured(std::move(pixels));
        if (spot.radius <= largestRadius) spots.push_back(std::move(spot));
      }
    for (Spot& spot : spots) weigh(spot);
    std::erase_if(spots, [&](const Spot& spot) { return !(light(spot) > leastPart * allLight_); });
    std::stable_sort(spots.begin(), spots.end(),
                     [](const Spot& a, const Spot& b) { return light(a) > light(b); });
    if (spots.size() > maxSuns) spots.resize(maxSuns);
    return spots;
  }

  // The environment without the suns.
  Image rest(const std::vector<Spot>& suns) const {
    Image rest = image_;
    for (const Spot& sun : suns) {
      for (const Place& at : sun.pixels)
        for (std::size_t c = 0; c < 3; ++c) {
          float& value = rest.pixel(at.x, at.y)[c];
          value = std::min(value, static_cast<float>(sun.around[c]));
        }
    }
    return rest;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::size_t pixelCount() const { return index(image_.width) * index(image_.height); }

  Vec3 direction(const Place& at) const {
    return latLongDirection((at.x + 0.5) / image_.width, (at.y + 0.5) / image_.height);
  }
  bool isBright(const Place& at) const {
    return luminance(image_.pixel(at.x, at.y)) > brightness * allLight_ / (4 * pi);
  }
  bool wasSeen(const Place& at) const {
    return seen_[index(at.y) * index(image_.width) + index(at.x)] != 0;
  }
  static double light(const Spot& spot) {
    const std::array<float, 3> rgb{static_cast<float>(spot.irradiance[0]),
                                   static_cast<float>(spot.irradiance[1]),
                                   static_cast<float>(spot.irradiance[2])};
    return luminance(rgb.data());
  }

  // Bright pixels that touch each other, across the seam as well.
  std::vector<Place> connectedTo(const Place& first) {
    std::vector<Place> found;
    const auto take = [&](const Place& at) {
      if (!isBright(at) || wasSeen(at)) return;
      seen_[index(at.y) * index(image_.width) + index(at.x)] = 1;
      found.push_back(at);
    };
    take(first);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Place at = found[i];
      for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, image_.height - 1); ++y)
        for (int dx = -1; dx <= 1; ++dx) take({(at.x + dx + image_.width) % image_.width, y});
    }
    return found;
  }

  // The light of these pixels, including what would be there without a sun.
  double grossLightOf(const std::vector<Place>& pixels) const {
    double sum = 0;
    for (const Place& at : pixels)
      sum += solidAngleOfRow_[index(at.y)] * luminance(image_.pixel(at.x, at.y));
    return sum;
  }

  Spot measured(std::vector<Place> pixels) const {
    std::array<double, 3> sum{};
    double all = 0;
    for (const Place& at : pixels) {
      const double weight = solidAngleOfRow_[index(at.y)] * luminance(image_.pixel(at.x, at.y));
      const Vec3 towards = direction(at);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * double{towards[i]};
      all += weight;
    }
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    Spot spot{.pixels = std::move(pixels)};
    spot.radius = std::acos(std::clamp(2 * length / all - 1, -1.0, 1.0));
    for (std::size_t i = 0; i < 3; ++i) spot.towards[i] = length > 0 ? sum[i] / length : 0;
    return spot;
  }

  void weigh(Spot& spot) const {
    spot.around = medianAround(spot);
    for (const Place& at : spot.pixels)
      for (std::size_t c = 0; c < 3; ++c)
        spot.irradiance[c] += solidAngleOfRow_[index(at.y)] *
                              std::max(double{image_.pixel(at.x, at.y)[c]} - spot.around[c], 0.0);
  }

  // The median, by channel, of the pixels around a spot that are not candidates themselves. Each
  // sample stands for the same solid angle, because shorter rows near the poles are sampled more
  // sparsely.
  Colour medianAround(const Spot& spot) const {
    const double nearest = std::cos(surroundings);
    const auto sparse = static_cast<int>(std::ceil(
        std::sqrt(static_cast<double>(pixelCount()) * (1 - nearest) / 2 / double{mostSamples})));
    std::array<std::vector<float>, 3> values;
    for (int y = 0; y < image_.height; y += sparse) {
      const double narrow = std::sin(pi * (y + 0.5) / image_.height);
      const int step = std::clamp(static_cast<int>(sparse / narrow), 1, image_.width);
      for (int x = 0; x < image_.width; x += step) {
        if (isBright({x, y}) || dot(direction({x, y}), spot.towards) < nearest) continue;
        for (std::size_t c = 0; c < 3; ++c) values[c].push_back(image_.pixel(x, y)[c]);
      }
    }
    Colour median{};
    for (std::size_t c = 0; c < 3; ++c) {
      if (values[c].empty()) continue;
      const auto middle = values[c].begin() + static_cast<std::ptrdiff_t>(values[c].size() / 2);
      std::nth_element(values[c].begin(), middle, values[c].end());
      median[c] = double{*middle};
    }
    return median;
  }

  const Image& image_;
  std::vector<std::uint8_t> seen_;
  std::vector<double> solidAngleOfRow_;
  double allLight_ = 0;
};

DirectionalLight lightOf(const Spot& sun) {
  DirectionalLight light;
  for (std::size_t i = 0; i < 3; ++i) {
    light.directionToLight[i] = static_cast<float>(sun.towards[i]);
    light.irradiance[i] = static_cast<float>(sun.irradiance[i]);
  }
  light.angularRadiusDegrees = static_cast<float>(sun.radius * 180 / pi);
  return light;
}

}  // namespace

Suns findSuns(std::shared_ptr<const Image> environment) {
  if (environment) {
    const std::string complaint = complaintAboutEnvironment(*environment);
    if (!complaint.empty()) throw Error(complaint);
  }
  while (environment && environment->width > mostColumns)
    environment = std::make_shared<const Image>(halved(*environment));
  Suns suns{{}, environment};
  if (!environment) return suns;
  SunFinder finder(*environment);
  const std::vector<Spot> found = finder.find();
  if (found.empty()) return suns;
  for (const Spot& sun : found) suns.lights.push_back(lightOf(sun));
  suns.rest = std::make_shared<const Image>(finder.rest(found));
  return suns;
}

void separate(const Suns& suns, Lighting& lighting) {
  lighting.environment = suns.rest;
  lighting.directional.insert(lighting.directional.end(), suns.lights.begin(), suns.lights.end());
}

}  // namespace opaline

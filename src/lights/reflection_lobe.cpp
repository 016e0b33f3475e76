#include "lights/reflection_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lights/vectors.h"

namespace opaline {

namespace {

using std::numbers::pi;

// In the frame of the mirrored direction: z along it, x in the plane of the view.
using namespace lights;
using Direction = Double3;

struct Sample {
  Direction direction;
  double value;  // of the reflection, per unit of its power
  double weight;
};

// The surface and the eye, in the frame of the mirrored direction.
struct Surface {
  Direction normal;
  Direction out;
  double alpha;
  double cosine;
};

Surface surfaceOf(double alpha, double cosine) {
  const double sine = std::sqrt(1 - cosine * cosine);
  // The mirrored direction is z. The normal lies towards -x from it, and the eye at twice that
  // angle.
  return {{-sine, 0, cosine}, {-2 * sine * cosine, 0, 2 * cosine * cosine - 1}, alpha, cosine};
}

double lambda(double cosine, double alpha) {
  const double tangentSquared = (1 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1 + alpha * alpha * tangentSquared) - 1);
}

// D G₂ / 4 μ_o, the reflection times the cosine without Fresnel's reflectance.
double reflected(const Surface& surface, const Direction& in) {
  const double cosineIn = dot(in, surface.normal);
  if (cosineIn <= 1e-6) return 0;
  const Direction half = unit(in + surface.out);
  const double cosineHalf = dot(half, surface.normal);
  if (cosineHalf <= 0) return 0;
  const double a2 = surface.alpha * surface.alpha;
  const double t = cosineHalf * cosineHalf * (a2 - 1) + 1;
  const double density = a2 / (pi * t * t);
  const double masking =
      1 / (1 + lambda(surface.cosine, surface.alpha) + lambda(cosineIn, surface.alpha));
  return density * masking / (4 * surface.cosine);
}

struct Frame {
  double sine;
  double cosine;

  // From the lobe's own frame, and into it.
  Direction outOf(const Direction& v) const {
    return {cosine * v[0] + sine * v[2], v[1], cosine * v[2] - sine * v[0]};
  }
  Direction into(const Direction& v) const {
    return {cosine * v[0] - sine * v[2], v[1], cosine * v[2] + sine * v[0]};
  }
};

Direction mapped(const ReflectionLobe& lobe, const Direction& v) {
  return {lobe.along * v[0] + lobe.skew * v[2], lobe.across * v[1], v[2]};
}

double valueOf(const ReflectionLobe& lobe, const Frame& frame, const Direction& direction) {
  const Direction in = frame.into(direction);
  const Direction cosineLobe{(in[0] - lobe.skew * in[2]) / lobe.along, in[1] / lobe.across, in[2]};
  const double squared = dot(cosineLobe, cosineLobe);
  return std::max(cosineLobe[2], 0.0) / (pi * squared * squared * lobe.along * lobe.across);
}

// Samples spread over directions by a grid that is transformed to the widths of the narrow lobe.
std::vector<Sample> samplesOf(const Surface& surface) {
  constexpr int rings = 16;
  constexpr int sectors = 12;
  const ReflectionLobe grid{0, 2 * surface.alpha, 2 * surface.alpha * std::max(surface.cosine, 0.1),
                            0};
  const Frame frame{0, 1};
  std::vector<Sample> samples;
  double power = 0;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < sectors; ++k) {
      const double squared = (i + 0.5) / rings;
      const double radius = std::sqrt(squared);
      const double angle = 2 * pi * (k + 0.5 * (i % 2)) / sectors;
      const Direction direction = unit(mapped(
          grid, {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - squared)}));
      const double weight = 1 / (valueOf(grid, frame, direction) * rings * sectors);
      samples.push_back({direction, reflected(surface, direction), weight});
      power += samples.back().value * weight;
    }
  for (Sample& sample : samples) sample.value /= power;
  return samples;
}

// Mean direction in the plane of the view.
double tiltOf(const std::vector<Sample>& samples) {
  double x = 0;
  double z = 0;
  for (const Sample& sample : samples) {
    x += sample.value * sample.weight * sample.direction[0];
    z += sample.value * sample.weight * sample.direction[2];
  }
  return std::atan2(x, z);
}

using Point = std::array<double, 3>;  // logarithms of the widths, and the skew over the width

ReflectionLobe lobeAt(double tilt, const Point& at) {
  const double along = std::exp(at[0]);
  return {tilt, along, std::exp(at[1]), at[2] * along};
}

double errorOf(const std::vector<Sample>& samples, double tilt, const Point& at) {
  const ReflectionLobe lobe = lobeAt(tilt, at);
  const Frame frame{std::sin(tilt), std::cos(tilt)};
  double sum = 0;
  for (const Sample& sample : samples) {
    const double difference = valueOf(lobe, frame, sample.direction) - sample.value;
    sum += difference * difference * sample.weight;
  }
  return sum;
}

Point blend(const Point& a, const Point& b, double part) {
  Point result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] + part * (b[i] - a[i]);
  return result;
}

// Nelder and Mead 1965.
Point minimised(const std::vector<Sample>& samples, double tilt, const Point& start) {
  constexpr int rounds = 60;
  struct Vertex {
    Point at;
    double error;
  };
  const auto vertexAt = [&](const Point& at) { return Vertex{at, errorOf(samples, tilt, at)}; };
  std::array<Vertex, 4> simplex;
  for (std::size_t i = 0; i < 4; ++i) {
    Point at = start;
    if (i > 0) at[i - 1] += 0.2;
    simplex[i] = vertexAt(at);
  }
  const auto less = [](const Vertex& a, const Vertex& b) { return a.error < b.error; };
  for (int round = 0; round < rounds; ++round) {
    std::sort(simplex.begin(), simplex.end(), less);
    Point middle{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) middle[k] += simplex[i].at[k] / 3;
    Vertex& worst = simplex[3];
    const Vertex mirrored = vertexAt(blend(worst.at, middle, 2));
    if (mirrored.error < simplex[0].error) {
      const Vertex further = vertexAt(blend(worst.at, middle, 3));
      worst = less(further, mirrored) ? further : mirrored;
    } else if (mirrored.error < simplex[2].error) {
      worst = mirrored;
    } else {
      const Vertex inside = vertexAt(blend(worst.at, middle, 0.5));
      if (inside.error < worst.error)
        worst = inside;
      else
        for (std::size_t i = 1; i < 4; ++i)
          simplex[i] = vertexAt(blend(simplex[0].at, simplex[i].at, 0.5));
    }
  }
  return std::min_element(simplex.begin(), simplex.end(), less)->at;
}

}  // namespace

ReflectionLobe reflectionLobeOf(double alpha, double cosine) {
  const Surface surface = surfaceOf(alpha, cosine);
  const std::vector<Sample> samples = samplesOf(surface);
  const double tilt = tiltOf(samples);
  const Point start{std::log(2 * alpha), std::log(2 * alpha * std::max(cosine, 0.1)), 0};
  return lobeAt(tilt, minimised(samples, tilt, start));
}

}  // namespace opaline

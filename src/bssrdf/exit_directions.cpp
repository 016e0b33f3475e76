#include "bssrdf/exit_directions.h"

#include <cassert>
#include <cmath>
#include <vector>

#include "bssrdf/fresnel.h"

namespace opaline::bssrdf {

namespace {

struct Sample {
  double cosine = 0;  // inside
  double weight = 0;
};

// By the midpoint rule over μ².
std::vector<Sample> samplesOf(double eta) {
  constexpr int steps = 2048;
  std::vector<Sample> samples;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double squared = (i + 0.5) / steps;
    const double transmitted = 1.0 - fresnelReflectance(eta, std::sqrt(squared));
    samples.push_back({std::sqrt(1.0 - (1.0 - squared) / (eta * eta)), transmitted});
    sum += transmitted;
  }
  for (Sample& sample : samples) sample.weight /= sum;
  return samples;
}

}  // namespace

ExitDirections exitDirections(double eta) {
  assert(eta >= 1.0);
  const std::vector<Sample> samples = samplesOf(eta);
  double mean = 0;
  for (const Sample& sample : samples) mean += sample.weight * sample.cosine;
  double variance = 0;
  double skew = 0;
  for (const Sample& sample : samples) {
    const double off = sample.cosine - mean;
    variance += sample.weight * off * off;
    skew += sample.weight * off * off * off;
  }
  // The points are the roots of x² - skew/variance x - variance, from the mean on.
  const double middle = skew / variance / 2;
  const double half = std::sqrt(middle * middle + variance);
  ExitDirections directions;
  directions.cosines = {mean + middle - half, mean + middle + half};
  directions.weights = {(half + middle) / (2 * half), (half - middle) / (2 * half)};
  for (std::size_t i = 0; i < directions.cosines.size(); ++i)
    directions.mirrored[i] = fresnelReflectanceInside(eta, directions.cosines[i]);
  return directions;
}

}  // namespace opaline::bssrdf

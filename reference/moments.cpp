#include "reference/moments.h"

#include <algorithm>
#include <cmath>

namespace opaline::reference {

namespace {

double total(const Colour& colour) {
  return std::abs(colour[0]) + std::abs(colour[1]) + std::abs(colour[2]);
}

std::array<double, 6> outer(const Vector& v) {
  return {v[0] * v[0], v[1] * v[1], v[2] * v[2], v[1] * v[2], v[2] * v[0], v[0] * v[1]};
}

}  // namespace

bool Moments::isDark() const {
  return std::all_of(channels.begin(), channels.end(), [](const Channel& channel) {
    return channel.flux == 0 && channel.third == 0 && channel.smoothError == 0 &&
           channel.borderVariance == 0;
  });
}

template <std::size_t Count>
Moments momentsOf(const std::array<FluxSample, Count>& samples,
                  const std::array<Vector, 3>& corners) {
  Moments moments;
  double weights = 0;
  for (const FluxSample& sample : samples) {
    const double weight = total(sample.flux);
    weights += weight;
    moments.centre += weight * sample.position;
  }
  moments.centre = weights > 0 ? (1 / weights) * moments.centre
                               : (1. / 3) * (corners[0] + corners[1] + corners[2]);
  for (const Vector& corner : corners) {
    moments.radiusMm = std::max(moments.radiusMm, length(corner - moments.centre));
  }
  for (const FluxSample& sample : samples) {
    const Vector offset = sample.position - moments.centre;
    const std::array<double, 6> square = outer(offset);
    const double squared = dot(offset, offset);
    const double cube = squared * std::sqrt(squared);
    for (std::size_t c = 0; c < 3; ++c) {
      Moments::Channel& channel = moments.channels[c];
      const double flux = sample.flux[c];
      channel.flux += flux;
      channel.first += flux * offset;
      for (std::size_t i = 0; i < 6; ++i) channel.second[i] += flux * square[i];
      channel.third += std::abs(flux) * cube;
    }
  }
  return moments;
}

template Moments momentsOf<6>(const std::array<FluxSample, 6>&, const std::array<Vector, 3>&);
template Moments momentsOf<24>(const std::array<FluxSample, 24>&, const std::array<Vector, 3>&);

Moments joined(const Moments* first, std::size_t count) {
  Moments sum;
  double weights = 0;
  Vector middle{};
  for (std::size_t i = 0; i < count; ++i) {
    const Moments& part = first[i];
    const double weight =
        total({part.channels[0].flux, part.channels[1].flux, part.channels[2].flux});
    weights += weight;
    sum.centre += weight * part.centre;
    middle += (1 / static_cast<double>(count)) * part.centre;
  }
  sum.centre = weights > 0 ? (1 / weights) * sum.centre : middle;
  for (std::size_t i = 0; i < count; ++i) {
    const Moments& part = first[i];
    const Vector shift = part.centre - sum.centre;
    const double distance = length(shift);
    const std::array<double, 6> square = outer(shift);
    sum.radiusMm = std::max(sum.radiusMm, distance + part.radiusMm);
    for (std::size_t c = 0; c < 3; ++c) {
      const Moments::Channel& from = part.channels[c];
      Moments::Channel& to = sum.channels[c];
      const Vector& f = from.first;
      to.flux += from.flux;
      to.first += from.first + from.flux * shift;
      const std::array<double, 6> mixed{
          2 * shift[0] * f[0],
          2 * shift[1] * f[1],
          2 * shift[2] * f[2],
          shift[1] * f[2] + shift[2] * f[1],
          shift[2] * f[0] + shift[0] * f[2],
          shift[0] * f[1] + shift[1] * f[0],
      };
      for (std::size_t k = 0; k < 6; ++k) {
        to.second[k] += from.second[k] + mixed[k] + from.flux * square[k];
      }
      // Minkowski's inequality for ∫|δ + shift|³.
      const double edge = std::cbrt(from.third) + distance * std::cbrt(std::abs(from.flux));
      to.third += edge * edge * edge;
      to.smoothError += from.smoothError;
      to.borderVariance += from.borderVariance;
    }
  }
  return sum;
}

bool isExpandable(const Moments& moments, const Vector& place, double depthMm) {
  const double distance = length(place - moments.centre);
  const double least = std::max(distance - moments.radiusMm, 0.0);
  const double radius2 = moments.radiusMm * moments.radiusMm;
  return least * least + depthMm * depthMm >= 4 * radius2;
}

// With d = place - centre, u = -2 d·δ + δ², R_d(|d - δ|²) = G₀(s + u) and dG_k/ds = -G_{k+1}/2:
// R_d = G₀ + G₁ d·δ - ½ G₁ δ² + ½ G₂ (d·δ)² + …, the third derivative along a unit vector at
// cosine c to d being G₃ (|d|c)³ - 3 G₂ |d|c.
Contribution contribution(const Moments& moments, const Vector& place,
                          const std::array<Kernel, 3>& kernels) {
  const Vector d = place - moments.centre;
  const double squared = dot(d, d);
  const double distance = std::sqrt(squared);
  const double least = std::max(distance - moments.radiusMm, 0.0);
  const double most = distance + moments.radiusMm;
  Contribution result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Moments::Channel& channel = moments.channels[c];
    const Kernel::Derivatives g = kernels[c](squared, least);
    const std::array<double, 6>& m = channel.second;
    const double trace = m[0] + m[1] + m[2];
    const double along = d[0] * d[0] * m[0] + d[1] * d[1] * m[1] + d[2] * d[2] * m[2] +
                         2 * (d[1] * d[2] * m[3] + d[2] * d[0] * m[4] + d[0] * d[1] * m[5]);
    result.exitance[c] = g.values[0] * channel.flux +
                         g.values[1] * (dot(d, channel.first) - 0.5 * trace) +
                         0.5 * g.values[2] * along;
    const double derivative = std::max(3 * g.mostG2 * most, g.mostG3 * most * most * most);
    result.bound[c] = derivative / 6 * channel.third;
    result.reflectance[c] = g.values[0];
  }
  return result;
}

}  // namespace opaline::reference

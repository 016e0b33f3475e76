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

/// Indices of a symmetric tensor's entries, in the order of Moments::Channel::third.
constexpr std::array<std::array<std::size_t, 3>, 10> triples{{{0, 0, 0},
                                                              {0, 0, 1},
                                                              {0, 0, 2},
                                                              {0, 1, 1},
                                                              {0, 1, 2},
                                                              {0, 2, 2},
                                                              {1, 1, 1},
                                                              {1, 1, 2},
                                                              {1, 2, 2},
                                                              {2, 2, 2}}};
/// How often each entry occurs in the tensor.
constexpr std::array<double, 10> multiplicity{1, 3, 3, 3, 6, 3, 1, 3, 3, 1};

/// Index of a symmetric matrix's entry in the order xx yy zz yz zx xy.
constexpr std::array<std::array<std::size_t, 3>, 3> pairPlace{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};

std::array<double, 10> triple(const Vector& v) {
  std::array<double, 10> result;
  for (std::size_t k = 0; k < 10; ++k) {
    result[k] = v[triples[k][0]] * v[triples[k][1]] * v[triples[k][2]];
  }
  return result;
}

/// Adds a piece's moments to those about another centre, which is `-shift` away from the piece's
/// own.
void addShifted(const Moments::Channel& from, const Vector& shift, Moments::Channel& to) {
  const std::array<double, 6> square = outer(shift);
  const Vector& f = from.first;
  const std::array<double, 6>& m = from.second;
  to.flux += from.flux;
  to.first += f + from.flux * shift;
  const std::array<double, 6> mixed{2 * shift[0] * f[0],
                                    2 * shift[1] * f[1],
                                    2 * shift[2] * f[2],
                                    shift[1] * f[2] + shift[2] * f[1],
                                    shift[2] * f[0] + shift[0] * f[2],
                                    shift[0] * f[1] + shift[1] * f[0]};
  for (std::size_t k = 0; k < 6; ++k) to.second[k] += m[k] + mixed[k] + from.flux * square[k];
  for (std::size_t n = 0; n < 10; ++n) {
    const auto [i, j, k] = triples[n];
    to.third[n] += from.third[n] + shift[i] * m[pairPlace[j][k]] + shift[j] * m[pairPlace[i][k]] +
                   shift[k] * m[pairPlace[i][j]] + square[pairPlace[i][j]] * f[k] +
                   square[pairPlace[i][k]] * f[j] + square[pairPlace[j][k]] * f[i] +
                   from.flux * shift[i] * shift[j] * shift[k];
  }
  // Minkowski's inequality for ∫|δ + shift|⁴.
  const double edge =
      std::sqrt(std::sqrt(from.fourth)) + length(shift) * std::sqrt(std::sqrt(std::abs(from.flux)));
  to.fourth += edge * edge * edge * edge;
  to.smoothError += from.smoothError;
  to.borderVariance += from.borderVariance;
}

}  // namespace

bool Moments::isDark() const {
  return std::all_of(channels.begin(), channels.end(), [](const Channel& channel) {
    return channel.flux == 0 && channel.fourth == 0 && channel.smoothError == 0 &&
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
    const std::array<double, 10> cube = triple(offset);
    for (std::size_t c = 0; c < 3; ++c) {
      Moments::Channel& channel = moments.channels[c];
      const double flux = sample.flux[c];
      channel.flux += flux;
      channel.first += flux * offset;
      for (std::size_t i = 0; i < 6; ++i) channel.second[i] += flux * square[i];
      for (std::size_t i = 0; i < 10; ++i) channel.third[i] += flux * cube[i];
      channel.fourth += std::abs(flux) * squared * squared;
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
    sum.radiusMm = std::max(sum.radiusMm, length(shift) + part.radiusMm);
    for (std::size_t c = 0; c < 3; ++c) addShifted(part.channels[c], shift, sum.channels[c]);
  }
  return sum;
}

bool isExpandable(const Moments& moments, const Vector& place, double depthMm) {
  const Vector d = place - moments.centre;
  return dot(d, d) + depthMm * depthMm >= 4 * moments.radiusMm * moments.radiusMm;
}

// With d = place - centre, w = d·δ and dG_k/ds = -G_{k+1}/2, the expansion of R_d(|d - δ|²) is
// G₀ + G₁ (w - δ²/2) + G₂ (w²/2 - wδ²/2 + δ⁴/8) + G₃ (w³/6 - w²δ²/4) + G₄ w⁴/24 + …
Contribution contribution(const Moments& moments, const Vector& place,
                          const std::array<Kernel, 3>& kernels) {
  const Vector d = place - moments.centre;
  const double squared = dot(d, d);
  const std::array<double, 6> pairs = outer(d);
  const std::array<double, 10> cubes = triple(d);
  Contribution result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Moments::Channel& channel = moments.channels[c];
    const auto g = kernels[c](squared);
    const std::array<double, 6>& m = channel.second;
    const std::array<double, 10>& t = channel.third;
    const double w2 = pairs[0] * m[0] + pairs[1] * m[1] + pairs[2] * m[2] +
                      2 * (pairs[3] * m[3] + pairs[4] * m[4] + pairs[5] * m[5]);
    double w3 = 0;
    for (std::size_t n = 0; n < 10; ++n) w3 += multiplicity[n] * cubes[n] * t[n];
    const double wDelta2 =
        d[0] * (t[0] + t[3] + t[5]) + d[1] * (t[1] + t[6] + t[8]) + d[2] * (t[2] + t[7] + t[9]);
    result.exitance[c] = g[0] * channel.flux +
                         g[1] * (dot(d, channel.first) - 0.5 * (m[0] + m[1] + m[2])) +
                         0.5 * g[2] * (w2 - wDelta2) + g[3] / 6 * w3;
    // The largest fourth-order term over all directions of δ.
    const double along = g[2] / 8 - squared * (g[3] / 4 - squared * g[4] / 24);
    const double term = std::max({g[2] / 8, std::abs(along), 0.375 * g[3] * g[3] / g[4]});
    result.bound[c] = term * kernels[c].growth(squared, moments.radiusMm) * channel.fourth;
    result.reflectance[c] = g[0];
  }
  return result;
}

}  // namespace opaline::reference

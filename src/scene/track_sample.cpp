#include "scene/track_sample.h"

#include <algorithm>
#include <cmath>

namespace opaline::scene {

namespace {

std::size_t valuesPerKey(const Track& track) {
  const std::size_t parts = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
  return track.seconds.empty() ? 0 : track.values.size() / (track.seconds.size() * parts);
}

}  // namespace

KeyPlace placeAmong(const std::vector<float>& keys, double seconds) {
  const auto next = std::upper_bound(keys.begin(), keys.end(), seconds);
  if (next == keys.begin()) return {};
  const auto before = static_cast<std::size_t>(next - keys.begin()) - 1;
  if (next == keys.end()) return {before, before, 0, 0};
  const double length = double{*next} - double{keys[before]};
  return {before, before + 1, (seconds - double{keys[before]}) / length, length};
}

TrackSample::TrackSample(const Track& track, double seconds)
    : track_(track),
      width_(valuesPerKey(track)),
      place_(placeAmong(track.seconds, seconds)),
      cubic_(track.interpolation == Interpolation::CubicSpline) {
  if (track.interpolation == Interpolation::Step) place_.to = place_.from;
}

double TrackSample::interpolated(std::size_t component) const {
  const double v0 = value(place_.from, component);
  if (place_.from == place_.to) return v0;
  const double v1 = value(place_.to, component);
  const double t = place_.t;
  if (!cubic_) return (1 - t) * v0 + t * v1;
  const double out = part(place_.from, 2, component);
  const double in = part(place_.to, 0, component);
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * v0 + place_.keySeconds * (t3 - 2 * t2 + t) * out +
         (3 * t2 - 2 * t3) * v1 + place_.keySeconds * (t3 - t2) * in;
}

std::array<double, 4> TrackSample::rotation() const {
  std::array<double, 4> q{};
  if (cubic_ || place_.from == place_.to) {
    for (std::size_t c = 0; c < 4; ++c) q[c] = interpolated(c);
    return q;
  }
  const std::array<double, 4> a = unitValue(place_.from);
  const std::array<double, 4> b = unitValue(place_.to);
  const double d = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double angle = std::acos(std::min(std::abs(d), 1.0));
  // Between quaternions this close, chord and arc are equal.
  const bool close = angle < 1e-6;
  const double fromA = close ? 1 - place_.t : std::sin((1 - place_.t) * angle);
  const double fromB = (close ? place_.t : std::sin(place_.t * angle)) * (d < 0 ? -1 : 1);
  for (std::size_t c = 0; c < 4; ++c) q[c] = fromA * a[c] + fromB * b[c];
  return q;
}

double TrackSample::part(std::size_t key, std::size_t which, std::size_t component) const {
  return double{track_.values[(3 * key + which) * width_ + component]};
}

double TrackSample::value(std::size_t key, std::size_t component) const {
  return cubic_ ? part(key, 1, component) : double{track_.values[key * width_ + component]};
}

std::array<double, 4> TrackSample::unitValue(std::size_t key) const {
  std::array<double, 4> q{};
  double norm = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    q[c] = value(key, c);
    norm += q[c] * q[c];
  }
  if (!(norm > 0)) return {0, 0, 0, 1};
  for (double& component : q) component /= std::sqrt(norm);
  return q;
}

}  // namespace opaline::scene

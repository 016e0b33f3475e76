#include "reference/picture.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "environment/lat_long.h"
#include "lights/area.h"
#include "opaline/error.h"
#include "reference/camera_rays.h"
#include "reference/opaque_surface.h"
#include "reference/own_surface.h"

namespace opaline::reference {

namespace {

constexpr int mostPixels = 16384;
constexpr int mostPaths = 1'000'000;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename T>
void requireWithin(const char* name, T value, T low, T high) {
  if (value >= low && value <= high) return;
  throw UsageError(fmt::format("{} is {}, but must be from {} to {}", name, value, low, high));
}

struct Place {
  int x;
  int y;
};

std::vector<Place> placesOf(const PictureOptions& options) {
  const Region whole{0, 0, options.width, options.height};
  const Region region = options.region.value_or(whole);
  const auto firstOf = [&](int begin) { return (begin + options.every - 1) / options.every; };
  std::vector<Place> places;
  for (int y = firstOf(region.y) * options.every; y < region.y + region.height;
       y += options.every) {
    for (int x = firstOf(region.x) * options.every; x < region.x + region.width;
         x += options.every) {
      places.push_back({x, y});
    }
  }
  return places;
}

/// Where in a pixel its samples are.
std::span<const std::array<double, 2>> offsetsOf(const PictureOptions& options) {
  return antialiasingOffsets(options.aov == Aov::Radiance ? options.antialias : 1);
}

/// The sum over a pixel's samples.
struct PixelSum {
  Colour value{};
  Colour error{};
  int hits = 0;
  Colour behind{};  ///< samples that see an emitter or sky instead of a surface
  int others = 0;
};

class Painter {
 public:
  Painter(const Geometry& geometry, const Irradiance& irradiance, const LeavingLight& light,
          const PictureOptions& options)
      : geometry_(geometry),
        irradiance_(irradiance),
        light_(light),
        aov_(options.aov),
        environmentBehind_(options.environmentBehind),
        pictureWidth_(static_cast<std::uint64_t>(options.width)),
        rays_(geometry.scene().camera, options.width, options.height),
        offsets_(offsetsOf(options)) {}

  PixelSum pixel(const Place& place) const {
    PixelSum sum;
    for (const auto& offset : offsets_) {
      const Ray ray = rays_.through(place.x, place.y, offset);
      const auto hit = geometry_.closestHit(ray.origin, ray.direction);
      if (aov_ == Aov::Radiance) {
        if (const auto other = lookPast(ray, hit ? hit->distanceMm : infinity)) {
          sum.behind += *other;
          ++sum.others;
          continue;
        }
      }
      if (!hit) continue;
      ++sum.hits;
      const std::uint64_t number =
          offsets_.size() * (static_cast<std::uint64_t>(place.y) * pictureWidth_ +
                             static_cast<std::uint64_t>(place.x)) +
          static_cast<std::uint64_t>(&offset - offsets_.data());
      const Exitance seen = look(hit->point, ray, number);
      sum.value += seen.value;
      sum.error += seen.error;
    }
    return sum;
  }

  std::size_t samples() const { return offsets_.size(); }

 private:
  bool isOpaque(const SurfacePoint& point) const {
    return geometry_.scene().bodies[point.body].opaque.has_value();
  }

  Exitance look(const SurfacePoint& point, const Ray& ray, std::uint64_t number) const {
    const bool radiant = aov_ == Aov::Radiance;
    if (isOpaque(point) ? showsExitance(aov_) : radiant && light_.looksAtMedia)
      return light_.look({point, -ray.direction, radiant, number});
    switch (aov_) {
      case Aov::Exitance:
        return light_.exitance(point);
      case Aov::Irradiance:
        return {irradiance_(point), {}};
      case Aov::Position:
        return {point.position, {}};
      case Aov::Normal:
        return {seenNormal(point, ray), {}};
      case Aov::Depth: {
        const double depth = rays_.depthMm(point.position);
        return {{depth, depth, depth}, {}};
      }
      case Aov::Object: {
        const double object = point.body;
        return {{object, object, object}, {}};
      }
      default:
        return radiance(point, ray);
    }
  }

  // The light in front of a surface at that distance, or what is behind everything where there is
  // no surface.
  std::optional<Colour> lookPast(const Ray& ray, double distanceMm) const {
    const Lighting& lighting = geometry_.scene().lighting;
    const AreaLight* seen = nullptr;
    for (const AreaLight& light : lighting.areas) {
      if (!isVisible(light)) continue;
      const auto distance = distanceAlong(ray.origin, ray.direction, light);
      if (!distance || *distance >= distanceMm) continue;
      distanceMm = *distance;
      seen = &light;
    }
    if (seen != nullptr) return toColour(radianceOf(*seen));
    if (distanceMm < infinity || !environmentBehind_) return std::nullopt;
    Colour behind = toColour(lighting.ambient);
    if (lighting.environment)
      behind += toColour(radianceFrom(*lighting.environment, toFloat(ray.direction)));
    return behind;
  }

  /// The shading normal on the visible side.
  static Vector seenNormal(const SurfacePoint& point, const Ray& ray) {
    return dot(point.facetNormal, ray.direction) > 0 ? -point.shadingNormal : point.shadingNormal;
  }

  // Jensen et al. 2001, Eq. 5, and d'Eon 2012.
  Exitance radiance(const SurfacePoint& point, const Ray& ray) const {
    const double cosine = std::clamp(-dot(seenNormal(point, ray), ray.direction), 1e-3, 1.0);
    const double eta = geometry_.scene().bodies[point.body].medium.eta;
    const double factor =
        light_.exitFactor[point.body] * (1 - bssrdf::fresnelReflectance(eta, cosine));
    const Exitance exitance = light_.exitance(point);
    return {factor * exitance.value, factor * exitance.error};
  }

  const Geometry& geometry_;
  const Irradiance& irradiance_;
  const LeavingLight& light_;
  Aov aov_;
  bool environmentBehind_;
  std::uint64_t pictureWidth_;
  CameraRays rays_;
  std::span<const std::array<double, 2>> offsets_;
};

ErrorSummary summarised(const std::vector<PixelSum>& sums) {
  std::vector<double> errors;
  for (const PixelSum& sum : sums) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (sum.value[c] > 0) errors.push_back(sum.error[c] / sum.value[c]);
    }
  }
  if (errors.empty()) return {};
  ErrorSummary summary;
  std::sort(errors.begin(), errors.end());
  for (const double error : errors) summary.mean += error;
  summary.mean /= static_cast<double>(errors.size());
  summary.percentile95 = errors[(errors.size() - 1) * 95 / 100];
  summary.largest = errors.back();
  return summary;
}

}  // namespace

void requireSound(const PictureOptions& options) {
  requireWithin("the width", options.width, 1, mostPixels);
  requireWithin("the height", options.height, 1, mostPixels);
  requireWithin("every", options.every, 1, mostPixels);
  requireWithin("the number of paths of a pixel", options.pathsOfPixel, 1, mostPaths);
  if (options.aov >= Aov::DsmPosition) {
    throw UsageError("the reference has no diffusion source map to show");
  }
  if (options.aov == Aov::Evaluations) {
    throw UsageError("the reference has no sums whose evaluations it could count");
  }
  if (options.aov == Aov::Surfels) throw UsageError("the reference has no surfels to show");
  if (!options.region) return;
  const Region& region = *options.region;
  if (region.x < 0 || region.y < 0 || region.width < 1 || region.height < 1 ||
      region.width > options.width - region.x || region.height > options.height - region.y) {
    throw UsageError(fmt::format("the region {},{},{},{} does not lie in the picture of {}x{}",
                                 region.x, region.y, region.width, region.height, options.width,
                                 options.height));
  }
}

std::vector<double> exitFactors(const Scene& scene, Transport transport) {
  std::vector<double> factors;
  for (const Body& body : scene.bodies) {
    factors.push_back(bssrdf::exitFactor(bssrdf::modelOf(transport), body.medium.eta));
  }
  return factors;
}

Exitance directLightOf(const Scene& scene, const Irradiance& irradiance, const Look& look) {
  const Body& body = scene.bodies[look.point.body];
  const OpaqueSurface surface = opaqueSurfaceAt(body, look.point);
  if (look.radiance && surface.unlit) return {surface.emission, {}};
  SurfacePoint seen = look.point;
  const double side = dot(seen.facetNormal, look.toEye) < 0 ? -1 : 1;
  seen.shadingNormal = side * normalAt(body, look.point, look.point.shadingNormal);
  seen.facetNormal = side * seen.facetNormal;
  const Colour arrives = irradiance(seen);
  Colour behind{};
  if (surface.through != Colour{}) {
    seen.shadingNormal = -seen.shadingNormal;
    seen.facetNormal = -seen.facetNormal;
    behind = irradiance(seen);
  }
  Exitance given;
  for (std::size_t c = 0; c < 3; ++c) {
    given.value[c] = surface.diffuse[c] * arrives[c] + surface.through[c] * behind[c];
    if (look.radiance) given.value[c] = given.value[c] / std::numbers::pi + surface.emission[c];
  }
  return given;
}

bool showsExitance(Aov aov) {
  return aov == Aov::Radiance || aov == Aov::Exitance;
}

bool seesMedia(const Geometry& geometry, const PictureOptions& options) {
  requireSound(options);
  const CameraRays rays(geometry.scene().camera, options.width, options.height);
  const auto offsets = offsetsOf(options);
  return std::ranges::any_of(placesOf(options), [&](const Place& place) {
    return std::ranges::any_of(offsets, [&](const std::array<double, 2>& offset) {
      const Ray ray = rays.through(place.x, place.y, offset);
      const auto hit = geometry.closestHit(ray.origin, ray.direction);
      return hit && !geometry.scene().bodies[hit->point.body].opaque;
    });
  });
}

Picture makePicture(const Geometry& geometry, const Irradiance& irradiance,
                    const LeavingLight& light, const PictureOptions& options,
                    const PictureProgress& progress) {
  requireSound(options);
  const std::vector<Place> places = placesOf(options);
  const Painter painter(geometry, irradiance, light, options);
  std::vector<PixelSum> sums(places.size());
  std::mutex mutex;
  std::size_t done = 0;
  constexpr std::size_t share = 16;
  const std::size_t shares = (places.size() + share - 1) / share;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, shares, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t s = range.begin(); s != range.end(); ++s) {
          const std::size_t last = std::min((s + 1) * share, places.size());
          for (std::size_t i = s * share; i < last; ++i) sums[i] = painter.pixel(places[i]);
          const std::lock_guard lock(mutex);
          done += last - s * share;
          if (progress) progress(done, places.size());
        }
      },
      tbb::simple_partitioner());

  Picture picture{Image(options.width, options.height), 0, {}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int seen = sums[i].hits + sums[i].others;
    if (seen == 0) continue;
    if (sums[i].hits > 0) ++picture.pixels;
    float* pixel = picture.image.pixel(places[i].x, places[i].y);
    for (std::size_t c = 0; c < 3; ++c) {
      pixel[c] = static_cast<float>((sums[i].value[c] + sums[i].behind[c]) / seen);
    }
    pixel[3] = static_cast<float>(seen) / static_cast<float>(painter.samples());
  }
  if (showsExitance(options.aov)) picture.error = summarised(sums);
  return picture;
}

}  // namespace opaline::reference

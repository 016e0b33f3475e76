#include "reference/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lights/area.h"
#include "opaline/error.h"

namespace opaline::reference {

namespace {

constexpr std::size_t mostTriangles = 100'000'000;

template <typename T>
bool finite(const T& values) {
  return std::all_of(values.begin(), values.end(), [](auto v) { return std::isfinite(v); });
}

bool isPower(const Rgb& rgb) {
  return finite(rgb) && std::all_of(rgb.begin(), rgb.end(), [](float v) { return v >= 0; });
}

void requireSound(const Body& body, std::size_t index) {
  if (body.normals.size() != body.positionsMm.size()) {
    throw Error(fmt::format("body {} has {} normals for {} vertices", index, body.normals.size(),
                            body.positionsMm.size()));
  }
  const auto isFinite = [](const Vector& v) { return finite(v); };
  if (!std::all_of(body.positionsMm.begin(), body.positionsMm.end(), isFinite) ||
      !std::all_of(body.normals.begin(), body.normals.end(), isFinite)) {
    throw Error(fmt::format("body {} has coordinates that are not finite", index));
  }
  for (const Triangle& triangle : body.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= body.positionsMm.size()) {
        throw Error(fmt::format("body {} has a triangle of vertex {} but only {} vertices", index,
                                vertex, body.positionsMm.size()));
      }
    }
  }
  if (body.opaque) {
    const std::string complaint = complaintAbout(*body.opaque);
    if (!complaint.empty()) throw Error(complaint);
    return;
  }
  const Medium& medium = body.medium;
  for (std::size_t c = 0; c < 3; ++c) {
    const double s = medium.sigmaSPrimePerMm[c];
    const double a = medium.sigmaAPerMm[c];
    if (!(s > 0) || !(a >= 0) || !std::isfinite(s) || !std::isfinite(a)) {
      throw Error(fmt::format(
          "medium '{}' must have scattering above 0 and absorption of at least 0 per mm in every "
          "channel, but has {} and {}",
          medium.name, s, a));
    }
  }
  if (!(medium.eta >= 1.01 && medium.eta <= 3)) {
    throw Error(
        fmt::format("the index of refraction of medium '{}' is {}, but must be from 1.01 to 3",
                    medium.name, medium.eta));
  }
}

void requireSound(const Lighting& lighting) {
  const bool directional = std::all_of(
      lighting.directional.begin(), lighting.directional.end(), [](const DirectionalLight& light) {
        return finite(light.directionToLight) && length(toVector(light.directionToLight)) > 0 &&
               isPower(light.irradiance);
      });
  const bool points = std::all_of(
      lighting.points.begin(), lighting.points.end(),
      [](const PointLight& light) { return finite(light.positionMm) && isPower(light.intensity); });
  const bool spots =
      std::all_of(lighting.spots.begin(), lighting.spots.end(), [](const SpotLight& light) {
        return finite(light.positionMm) && finite(light.direction) &&
               length(toVector(light.direction)) > 0 && isPower(light.intensity) &&
               light.innerDegrees >= 0 && light.innerDegrees <= light.outerDegrees &&
               light.outerDegrees > 0 && light.outerDegrees <= 90;
      });
  for (const AreaLight& light : lighting.areas) {
    const AreaPoint point = pointOn(light, 0.25, 0.25);
    if (!finite(point.positionMm) || !finite(point.normal) || !(areaMm2(light) > 0) ||
        !std::isfinite(areaMm2(light)) || !isPower(radianceOf(light)))
      throw Error("every area light must have a place, an area and a radiance of at least 0");
  }
  if (!directional || !points || !spots || !isPower(lighting.ambient)) {
    throw Error(
        "every light must have a direction or a place, a cone of at most 90 degrees where it has "
        "one, "
        "and power of at least 0");
  }
}

void requireSound(const Camera& camera) {
  const bool placed = finite(camera.positionMm) && finite(camera.targetMm) && finite(camera.up) &&
                      camera.positionMm != camera.targetMm;
  if (!placed || !(camera.verticalFovDegrees >= 1 && camera.verticalFovDegrees <= 170)) {
    throw Error(
        "the camera must look from one place at another, with a field of view from 1 to 170 "
        "degrees");
  }
}

}  // namespace

namespace {

template <typename Counts>
Box boxWhere(const Scene& scene, const Counts& counts) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box box{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
  bool any = false;
  for (const Body& body : scene.bodies) {
    if (!counts(body)) continue;
    for (const Vector& p : body.positionsMm) {
      any = true;
      for (std::size_t i = 0; i < 3; ++i) {
        box.minMm[i] = std::min(box.minMm[i], p[i]);
        box.maxMm[i] = std::max(box.maxMm[i], p[i]);
      }
    }
  }
  return any ? box : Box{};
}

}  // namespace

Box boxOf(const Scene& scene) {
  const bool onlyGround = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                      [](const Body& body) { return body.isGround; });
  return boxWhere(scene, [&](const Body& body) { return onlyGround || !body.isGround; });
}

Box boxOfMedia(const Scene& scene) {
  return boxWhere(scene, [](const Body& body) { return !body.opaque; });
}

bool hasMedia(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return !body.opaque; });
}

void requireSound(const Scene& scene) {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    requireSound(scene.bodies[i], i);
    triangles += scene.bodies[i].triangles.size();
  }
  if (triangles == 0) throw Error("the scene has no surface");
  if (triangles > mostTriangles) {
    throw Error(
        fmt::format("the scene has {} triangles, but there may be {}", triangles, mostTriangles));
  }
  requireSound(scene.lighting);
  requireSound(scene.camera);
}

}  // namespace opaline::reference

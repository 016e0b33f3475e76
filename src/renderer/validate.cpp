#include "renderer/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "opaline/error.h"
#include "renderer/frame/light_views.h"
#include "renderer/scene/scene_resources.h"
#include "shaders/shared/frame.h"

namespace opaline {

namespace {

template <typename T>
void requireWithin(const char* name, T value, T low, T high) {
  if (value >= low && value <= high) return;  // false for NaN
  throw UsageError(fmt::format("{} is {}, but must be from {} to {}", name, value, low, high));
}

template <typename T>
bool finite(const T& values) {
  return std::all_of(values.begin(), values.end(), [](auto v) { return std::isfinite(v); });
}

void validateMesh(const Object& object) {
  const Mesh& mesh = object.mesh;
  if (mesh.normals.size() != mesh.positionsMm.size())
    throw Error(fmt::format("object '{}' has {} normals for {} vertices", object.name,
                            mesh.normals.size(), mesh.positionsMm.size()));
  const auto allFinite = [](const std::vector<Vec3>& list) {
    return std::all_of(list.begin(), list.end(), [](const Vec3& v) { return finite(v); });
  };
  if (!allFinite(mesh.positionsMm) || !allFinite(mesh.normals))
    throw Error(fmt::format("object '{}' has coordinates that are not finite", object.name));
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle)
      if (index >= mesh.positionsMm.size())
        throw Error(fmt::format("object '{}' has a triangle of vertex {} but only {} vertices",
                                object.name, index, mesh.positionsMm.size()));
}

bool isDirection(const Vec3& v) {
  return finite(v) && (v[0] != 0 || v[1] != 0 || v[2] != 0);
}

bool isPower(const Rgb& rgb) {
  return finite(rgb) && std::all_of(rgb.begin(), rgb.end(), [](float v) { return v >= 0; });
}

}  // namespace

void requireObject(std::size_t object, std::size_t count) {
  if (object >= count)
    throw UsageError(fmt::format("there is no object {}: the scene has {}", object, count));
}

void validate(const RenderOptions& options) {
  if (options.transport == Transport::Boundary && options.sum == Sum::Pattern)
    throw UsageError("boundary transport works with surfels; the pattern needs another transport");
  requireWithin("the width", options.width, 1, 16384);
  requireWithin("the height", options.height, 1, 16384);
  requireWithin("the tolerance", options.tolerance, 1e-4F, 1.0F);
  requireWithin("the number of sources", options.maxSources, 1024, 1 << 22);
  requireWithin("the number of boundary surfels", options.boundarySurfels, 64, mostClusters);
  requireWithin("the number of bounces", options.bounces, 0, maxBounces);
  requireWithin("the number of near rings", options.pattern.nearRings, 0, 15);
  requireWithin("the near spacing", options.pattern.nearSpacing, 1e-3F, 100.0F);
  requireWithin("the far distance", options.pattern.farDistance, 1e-3F, 1000.0F);
  requireWithin("the size of the diffusion source map", options.dsmSize, 64, 4096);
  requireWithin("the size of the shadow maps", options.shadowSize, 64, 8192);
  requireWithin("the level of the tree", options.treeLevel, 0, 64);
  requireWithin("the roughness", options.roughness, 0.05F, 1.0F);
  requireWithin("the number of frames", options.frames, 1, 1'000'000);
  requireWithin("the time in seconds", options.seconds, 0.0, 1e9);
  requireWithin("the clip", options.clip, -1, std::numeric_limits<int>::max());
  if (options.antialias != 1 && options.antialias != 2 && options.antialias != 4 &&
      options.antialias != 8)
    throw UsageError(fmt::format(
        "the number of antialiasing samples is {}, but must be 1, 2, 4 or 8", options.antialias));
}

void validate(const RenderOptions& options, const std::vector<Aov>& aovs) {
  if (options.sum == Sum::Pattern &&
      std::find(aovs.begin(), aovs.end(), Aov::Surfels) != aovs.end())
    throw UsageError("the pattern has no surfels to show; the sums tree and all have");
}

void validate(const Medium& medium) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double s = medium.sigmaSPrimePerMm[c];
    const double a = medium.sigmaAPerMm[c];
    if (!(s > 0) || !(a >= 0) || !std::isfinite(s) || !std::isfinite(a))
      throw Error(fmt::format(
          "medium '{}' must have scattering above 0 and absorption of at least 0 per mm in every "
          "channel, but has {} and {}",
          medium.name, s, a));
  }
  if (!(medium.eta >= 1.01 && medium.eta <= 3))
    throw Error(
        fmt::format("the index of refraction of medium '{}' is {}, but must be from 1.01 to 3",
                    medium.name, medium.eta));
}

void validate(const Lighting& lighting) {
  if (lighting.directional.size() + lighting.points.size() > shared::maxLights ||
      shadowViewCount(lighting) > shared::maxShadowViews)
    throw Error(
        fmt::format("the scene has {} directional and {} point lights, but there may be {} lights "
                    "in all, and at "
                    "most {} point lights",
                    lighting.directional.size(), lighting.points.size(), shared::maxLights,
                    shared::maxShadowViews / 6));
  for (const DirectionalLight& light : lighting.directional)
    if (!isDirection(light.directionToLight) || !isPower(light.irradiance))
      throw Error(
          "a directional light needs a direction other than 0,0,0 and an irradiance of at least 0");
  for (const PointLight& light : lighting.points)
    if (!finite(light.positionMm) || !isPower(light.intensity))
      throw Error("a point light needs a finite position and an intensity of at least 0");
  if (!isPower(lighting.ambient)) throw Error("ambient radiance must be finite and at least 0");
}

void validate(const Camera& camera) {
  if (!finite(camera.positionMm) || !finite(camera.targetMm) || !finite(camera.up) ||
      camera.positionMm == camera.targetMm)
    throw Error("the camera needs a finite position that differs from its target");
  requireWithin("the field of view in degrees", camera.verticalFovDegrees, 1.0F, 170.0F);
}

void validate(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Object& object : scene.objects) {
    validateMesh(object);
    validate(object.medium);
    triangles += object.mesh.triangles.size();
  }
  if (triangles == 0) throw Error(fmt::format("scene '{}' has no triangles", scene.name));
  validateMotion(scene);
  validate(scene.lighting);
  validate(scene.camera);
}

}  // namespace opaline

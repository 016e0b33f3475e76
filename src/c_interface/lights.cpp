#include <cmath>
#include <memory>
#include <utility>

#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/environment.h"
#include "opaline/scene.h"

namespace opaline::c {

namespace {

void requireEnvironment(float intensity, double rotationDegrees) {
  constexpr float brightest = 1e6F;
  constexpr double mostDegrees = 1e6;
  if (!(intensity >= 0 && intensity <= brightest)) {
    throw UsageError(fmt::format("intensity {}: must be from 0 to 1e6", intensity));
  }
  if (!(std::abs(rotationDegrees) <= mostDegrees)) {
    throw UsageError(
        fmt::format("rotationDegrees {}: must be from -1e6 to 1e6 degrees", rotationDegrees));
  }
}

Lighting& lightingOf(OpalineScene* scene) {
  return required(scene, "scene").scene.lighting;
}

/// Throws for lighting that cannot be rendered; the scene's lights then stay as they are.
void set(OpalineScene* scene, Lighting lighting) {
  lightingOf(scene) = sound(std::move(lighting));
}

template <typename Light>
void add(OpalineScene* scene, std::vector<Light> Lighting::*list, const Light& light) {
  Lighting lighting = lightingOf(scene);
  (lighting.*list).push_back(light);
  set(scene, std::move(lighting));
}

void addArea(OpalineScene* scene, const AreaLight& light) {
  add(scene, &Lighting::areas, light);
}

}  // namespace
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;
using opaline::c::vectorOf;

extern "C" {

OpalineStatus opalineClearLights(OpalineScene* scene) {
  return guarded([&] { c::lightingOf(scene) = {}; });
}

OpalineStatus opalineUseDefaultLights(OpalineScene* scene) {
  return guarded([&] { c::lightingOf(scene) = defaultLighting(); });
}

OpalineStatus opalineAddDirectionalLight(OpalineScene* scene, const float directionToLight[3],
                                         const float irradiance[3]) {
  return opalineAddSun(scene, directionToLight, irradiance, 0);
}

OpalineStatus opalineAddPointLight(OpalineScene* scene, const float positionMm[3],
                                   const float intensity[3]) {
  return guarded([&] {
    c::add(scene, &Lighting::points,
           PointLight{vectorOf(positionMm, "positionMm"), vectorOf(intensity, "intensity")});
  });
}

OpalineStatus opalineAddSpotLight(OpalineScene* scene, const float positionMm[3],
                                  const float direction[3], const float intensity[3],
                                  float innerDegrees, float outerDegrees) {
  return guarded([&] {
    c::add(scene, &Lighting::spots,
           SpotLight{vectorOf(positionMm, "positionMm"), vectorOf(direction, "direction"),
                     vectorOf(intensity, "intensity"), innerDegrees, outerDegrees});
  });
}

OpalineStatus opalineAddSun(OpalineScene* scene, const float directionToLight[3],
                            const float irradiance[3], float angularRadiusDegrees) {
  return guarded([&] {
    c::add(scene, &Lighting::directional,
           DirectionalLight{vectorOf(directionToLight, "directionToLight"),
                            vectorOf(irradiance, "irradiance"), angularRadiusDegrees});
  });
}

OpalineStatus opalineAddRectangleLight(OpalineScene* scene, const float centreMm[3],
                                       const float uMm[3], const float vMm[3],
                                       const float radiance[3]) {
  return guarded([&] {
    c::addArea(scene, RectangleLight{vectorOf(centreMm, "centreMm"), vectorOf(uMm, "uMm"),
                                     vectorOf(vMm, "vMm"), vectorOf(radiance, "radiance")});
  });
}

OpalineStatus opalineAddDiscLight(OpalineScene* scene, const float centreMm[3],
                                  const float normal[3], float radiusMm, const float radiance[3]) {
  return guarded([&] {
    c::addArea(scene, DiscLight{vectorOf(centreMm, "centreMm"), vectorOf(normal, "normal"),
                                radiusMm, vectorOf(radiance, "radiance")});
  });
}

OpalineStatus opalineAddSphereLight(OpalineScene* scene, const float centreMm[3], float radiusMm,
                                    const float radiance[3]) {
  return guarded([&] {
    c::addArea(scene, SphereLight{vectorOf(centreMm, "centreMm"), radiusMm,
                                  vectorOf(radiance, "radiance")});
  });
}

OpalineStatus opalineAddTubeLight(OpalineScene* scene, const float fromMm[3], const float toMm[3],
                                  float radiusMm, const float radiance[3]) {
  return guarded([&] {
    c::addArea(scene, TubeLight{vectorOf(fromMm, "fromMm"), vectorOf(toMm, "toMm"), radiusMm,
                                vectorOf(radiance, "radiance")});
  });
}

OpalineStatus opalineSetAreaLight(OpalineScene* scene, size_t light, int32_t twoSided,
                                  int32_t visible) {
  return guarded([&] {
    AreaLight& area = c::oneOf(c::lightingOf(scene).areas, light, "area light");
    std::visit(
        [&](auto& of) {
          if constexpr (requires { of.twoSided; }) {
            of.twoSided = twoSided != 0;
          } else if (twoSided != 0) {
            throw UsageError("Only rectangles and discs shine to two sides.");
          }
          of.visible = visible != 0;
        },
        area);
  });
}

OpalineStatus opalineSetAmbientLight(OpalineScene* scene, const float radiance[3]) {
  return guarded([&] {
    Lighting lighting = c::lightingOf(scene);
    lighting.ambient = vectorOf(radiance, "radiance");
    c::set(scene, std::move(lighting));
  });
}

OpalineStatus opalineSetEnvironment(OpalineScene* scene, const char* file, float intensity,
                                    double rotationDegrees) {
  return guarded([&] {
    c::requireEnvironment(intensity, rotationDegrees);
    c::lightingOf(scene).environment =
        readEnvironment({&required(file, "file"), intensity, rotationDegrees});
  });
}

OpalineStatus opalineSetEnvironmentPixels(OpalineScene* scene, const float* rgba, int32_t width,
                                          int32_t height, float intensity, double rotationDegrees) {
  return guarded([&] {
    c::requireEnvironment(intensity, rotationDegrees);
    Image image = c::imageOf(rgba, width, height, "rgba");
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      image.rgba[i] = i % 4 == 3 ? 1.0F : intensity * image.rgba[i];
      if (!(image.rgba[i] >= 0 && std::isfinite(image.rgba[i])))
        throw UsageError(fmt::format(
            "The radiance of pixel {} is negative, or not finite with this intensity.", i / 4));
    }
    c::lightingOf(scene).environment =
        std::make_shared<const Image>(turned(image, rotationDegrees));
  });
}

}  // extern "C"

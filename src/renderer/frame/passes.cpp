#include "renderer/frame/passes.h"

#include "gpu/device.h"

namespace opaline {

Passes::Passes(gpu::Device& device)
    : deform(device),
      fit(device),
      shadow(device),
      surfels(device),
      areaLights(device),
      surface(device),
      sum(device),
      interpolation(device),
      nearby(device),
      opaque(device),
      opaqueLights(device),
      paint(device),
      rays(device),
      clusters(device),
      occludedSky(device),
      beams(device),
      reentry(device),
      solver(device),
      carry(device),
      sky(device),
      ownSurfaces(device),
      mirroredScene(device),
      reflectedSky(device),
      reflectedLights(device),
      seenThrough(device),
      shade(device),
      backdrop(device),
      centres(device),
      seenSurfels(device),
      seenIrradiance(device) {}

}  // namespace opaline

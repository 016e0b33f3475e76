// Paint on translucent bodies in storage buffers (bssrdf/paint.h). Included by C++ and GLSL.
#ifndef OPALINE_SHARED_PAINT_H
#define OPALINE_SHARED_PAINT_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::vec4;
#define OPALINE_PAINT_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_PAINT_CONSTANT const uint
#endif

/// Of each paint's table: for the squares of 0 to 1 times the colour of the medium below.
OPALINE_PAINT_CONSTANT paintEntries = 128u;

/// An entry of such a table. The one behind the last has the colour of the medium as its thickness.
struct PaintEntry {
  vec4 thickness;  // rgb, as bssrdf::PaintedBoundary has it; so have the others
  vec4 entering;
  vec4 layer;
  vec4 leaving;
  vec4 takenOff;
  vec4 source;
  vec4 deep;
};

/// Its means over a cluster.
struct ClusterPaint {
  vec4 entering;  // w: 1 where its body is painted
  vec4 layer;
  vec4 leaving;
  vec4 takenOff;
  vec4 deep;
  vec4 atSurface;  // fluence there at which as much leaves as has entered, over what got through
                   // the interface
};

/// Light below the paint of a cluster.
struct BareLight {
  vec4 exitance;  // rgb: as if there were no layer to leave through
  vec4 entered;   // rgb: irradiance of light that has entered the diffusion at the surface, before
                  // the layer
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif

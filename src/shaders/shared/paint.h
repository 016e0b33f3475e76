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

/// Entries of each paint's table: for the squares of 0 to 1 times the colour of the medium below.
OPALINE_PAINT_CONSTANT paintEntries = 128u;

/// An entry of such a table. One more behind the last has the medium's colour as its thickness.
struct PaintEntry {
  vec4 thickness;  // rgb, as in bssrdf::PaintedBoundary; so are the others
  vec4 entering;
  vec4 layer;
  vec4 leaving;
  vec4 takenOff;
  vec4 source;
  vec4 deep;
};

/// Means of a paint over a cluster.
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

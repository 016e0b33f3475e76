// Data that the host writes and every shader reads. Included by C++ and GLSL; the layout rules of
// both agree because every member is a mat4, a vec4 or a uvec4.
#ifndef OPALINE_SHARED_FRAME_H
#define OPALINE_SHARED_FRAME_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec4;
#define OPALINE_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_CONSTANT const uint
#endif

OPALINE_CONSTANT maxLights = 20;
OPALINE_CONSTANT maxShadowViews = 52;
OPALINE_CONSTANT maxSamples = 8;

/// Kinds of lights. A spot light is a point light with a cone.
OPALINE_CONSTANT directionalLight = 0;
OPALINE_CONSTANT pointLight = 1;
OPALINE_CONSTANT areaLight = 2;

/// Shapes of area lights.
OPALINE_CONSTANT rectangleShape = 0;
OPALINE_CONSTANT discShape = 1;
OPALINE_CONSTANT sphereShape = 2;
OPALINE_CONSTANT tubeShape = 3;

/// One light that casts shadows.
struct LightData {
  vec4 place;  // xyz: direction to the light, unit (directional), or its position in mm (point),
               // or its middle (area); w: of a directional light, what it adds to α² of a highlight
  vec4 power;  // rgb: irradiance (directional), intensity (point) or radiance (area);
               // w: 1 where an area light has two sides
  vec4 depth;  // depth d of its shadow map in mm: x + y·d (directional), x / (y + d) (point);
               // x: 1 where an area light is seen in the picture itself
  vec4 texel;  // x: edge of a shadow texel in mm (directional), or per mm of distance (point)
  vec4 axis;   // xyz: unit, where a spot light shines to; of an area light, mm, from the middle to
               // the edge of a rectangle or a disc, or to an end of a tube
  vec4 cone;   // x, y: scale and offset of its falloff (lights/spot.h), 0 and 1 of any other point;
               // z: tangent of the outer angle. xyz of an area light: from the middle to another
               // edge; w: radius of a sphere or a tube
  uvec4 kind;  // x: of light; y: first shadow view; z: number of them; w: shape of an area light
};

struct FrameData {
  mat4 worldToClip;
  vec4 cameraPosition;  // xyz mm, w 1; of an orthographic camera the direction to it, w 0
  vec4 cameraAxis;      // xyz unit, towards the scene; w: 1 where what lies nearer is seen too
  uvec4 counts;         // x: lights with shadow maps, which come first; y: size of these;
                        // z: antialiasing samples; w: all lights
  LightData lights[maxLights];
  vec4 samples[maxSamples];          // xy: from the pixel's centre, pixels
  mat4 shadowViews[maxShadowViews];  // world to clip
};

/// One body.
struct ObjectData {
  uvec4 table;  // x: medium; y: first surfel; z: number of surfels; w: 1 where light is summed at
                // fragments, 0 at vertices
  uvec4 tree;   // x: root, among the nodes; y: the node after all of its tree; z: how many clusters
                // an opaque sheet, or what lets light through, has of its back, each so many after
                // that of the front, 0 of others; w: the node after the
                // tree of its lining, which follows its own
  uvec4 clusters;  // of boundary transport, x: root among their nodes; y: the node after their
                   // tree; z: 1 where they have what is seen of some part of the body; w: 1 where
                   // it is opaque, 2 where light may go through it all the same
  uvec4 body;      // x: the first of the objects that are one body with it
  vec4 darkest;  // rgb: exitance below which differences do not count, over the body's flux, mm⁻²;
                 // w: reach of coarse sources (shared/nearby.h), mm, 0 where they are not
  vec4 nearbyDisc;  // rgb: what they lack there in even light, part of the irradiance
  vec4 nearbyInner;
  vec4 nearbyOuter;
  vec4 nearbyKept;  // rgb: what they give, by nearbyWeight
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif

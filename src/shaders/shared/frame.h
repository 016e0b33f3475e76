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
  vec4 place;  // xyz: unit direction to the light (directional), its position in mm (point), or its
               // middle (area); w: for a directional light, what it adds to α² of a highlight
  vec4 power;  // rgb: irradiance (directional), intensity (point) or radiance (area);
               // w: 1 where an area light has two sides
  vec4 depth;  // depth d of its shadow map in mm: x + y·d (directional), x / (y + d) (point);
               // x: 1 where an area light is seen in the picture itself
  vec4 texel;  // x: edge of a shadow texel in mm (directional), or per mm of distance (point)
  vec4 axis;   // xyz: unit, the direction in which a spot light shines; of an area light, mm, from
               // the middle to the edge of a rectangle or a disc, or to an end of a tube
  vec4 cone;   // x, y: scale and offset of its falloff (lights/spot.h), 0 and 1 for any other point
               // light; z: tangent of the outer angle. For an area light xyz: from the middle to
               // another edge; w: radius of a sphere or a tube
  uvec4 kind;  // x: of light; y: first shadow view; z: room for so many; w: shape of an area light
  vec4 view;   // from gather/fit.comp: xyz: unit, the direction of its only view; w: 1 where it has
               // only one
};

struct FrameData {
  mat4 worldToClip;
  vec4 cameraPosition;  // xyz mm, w 1; for an orthographic camera the direction to it, w 0
  vec4 cameraAxis;      // xyz unit, towards the scene; w: 1 where what is nearer than the scene is
                        // seen too
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
  uvec4 tree;   // x: root, among the nodes; y: the node after all of its tree; z: number of
                // clusters of the back of an opaque sheet or of what lets light through, each that
                // many after its front, else 0; w: the node after the tree of its lining, which
                // follows its own
  uvec4 clusters;  // for boundary transport, x: root among the nodes of clusters; y: the node after
                   // their tree; z: 1 where clusters hold what is seen of some part of the body; w:
                   // 1 where it is opaque, 2 where it may let light through all the same
  uvec4 body;      // x: the first of the objects that form one body with it
  vec4 darkest;  // rgb: exitance below which differences do not count, over the body's flux, mm⁻²;
                 // w: reach of coarse sources (shared/nearby.h), mm, 0 where there are none
  vec4 nearbyDisc;  // rgb: what coarse sources lack there in even light, part of the irradiance
  vec4 nearbyInner;
  vec4 nearbyOuter;
  vec4 nearbyKept;  // rgb: what they do give, weighted by nearbyWeight
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif

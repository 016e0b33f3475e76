// Ambient occlusion of the diffusion source map: takes away the part of the sky's light that does not
// reach its texels. The paper names it as future work.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_SKY_IRRADIANCE 2
#define BINDING_CLUSTER_NODES 3
#define BINDING_CLUSTERS 4
#define BINDING_SKY_SHARES 5
#include "lib/material.glsl"
#include "lib/sky.glsl"
#include "lib/sky_share.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 6) uniform sampler2D positionArea;
layout(set = 0, binding = 7) uniform sampler2D unitNormal;
layout(set = 0, binding = 8, rgba32f) uniform image2D irradianceObject;

void main() {
  ivec2 texel = pixelOfInvocation();
  if (any(greaterThanEqual(texel, imageSize(irradianceObject)))) return;
  vec4 gathered = imageLoad(irradianceObject, texel);
  if (gathered.w < 1.0) return;  // no surface
  ObjectData body = objects[uint(gathered.w) - 1u];
  vec3 place = texelFetch(positionArea, texel, 0).xyz;
  vec3 normal = texelFetch(unitNormal, texel, 0).xyz;
  vec3 hidden = 1.0 - skyShareAt(place, normal, body);
  vec3 sky = skyIrradianceAt(normal, mediumAt(body, place));
  imageStore(irradianceObject, texel, vec4(max(gathered.rgb - hidden * sky, 0.0), gathered.w));
}

// Adds to the exitance of visible pixels what sums over coarse sources leave out nearby.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_NODES 8
#define BINDING_SOURCES 9
#define BINDING_SURFEL_NORMALS 10
#include "lib/irradiance.glsl"
#include "lib/nearby.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2, rgba32f) uniform image2D exitance;
layout(set = 0, binding = 3) uniform sampler2D surfaceNormal;

layout(push_constant) uniform Push { uint site; };

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(exitance)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  if (surface.w == 0.0) return;
  ObjectData body = objects[uint(surface.w) - 1u];
  if (body.darkest.w == 0.0 || !isSummedAtFragments(body, site)) return;
  vec4 seen = texelFetch(surfaceNormal, pixel, 0);
  vec3 normal = seen.w * seen.xyz;
  imageStore(exitance, pixel,
             imageLoad(exitance, pixel) + nearbyExitance(surface.xyz, normal, body));
}

// An opaque surface under the same lights and shadows: what a frame costs without translucency.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SHADOW_BINDING 3
#include "lib/frame.glsl"
#include "lib/shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfaceNormal;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D radiance;

layout(push_constant) uniform Push { vec4 ambient; };

const vec3 albedo = vec3(0.8);

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(radiance)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  vec4 value = vec4(0.0);
  if (surface.w > 0.0) {
    vec3 normal = texelFetch(surfaceNormal, pixel, 0).xyz;
    value = vec4(albedo * ambient.rgb, 1.0);
    for (uint i = 0u; i < frame.counts.x; ++i) {
      IncidentLight light = incidentLight(i, surface.xyz);
      float cosine = dot(normal, light.direction);
      if (cosine <= 0.0) continue;
      value.rgb += albedo / 3.14159265 * light.irradiance *
                   (cosine * visibilityOf(light, surface.xyz, normal));
    }
  }
  imageStore(radiance, pixel, value);
}

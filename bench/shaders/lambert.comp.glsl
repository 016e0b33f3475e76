// An opaque surface under the same lights and shadows: the cost of a frame without translucency.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define SHADOW_BINDING 3
#define MESH_BINDING 5
#include "lib/frame.glsl"
#include "lib/seen.glsl"
#include "lib/shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D radiance;

layout(push_constant) uniform Push { vec4 ambient; };

const vec3 albedo = vec3(0.8);

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(radiance)))) return;
  uint word = seenWord(pixel, 0u);
  vec4 value = vec4(0.0);
  if (word != 0u) {
    MeshPlace place = seenPlace(pixel, word);
    value = vec4(albedo * ambient.rgb, 1.0);
    for (uint i = 0u; i < frame.counts.x; ++i) {
      IncidentLight light = incidentLight(i, place.position);
      float cosine = dot(place.normal, light.direction);
      if (cosine <= 0.0) continue;
      value.rgb += albedo / 3.14159265 * light.irradiance *
                   (cosine * visibilityOf(light, place.position, place.normal));
    }
  }
  imageStore(radiance, pixel, value);
}

// Lights that hide the surface: a sample that sees one sees no triangle.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/sight.glsl"
#include "lib/visible_light.glsl"

layout(push_constant) uniform Push {
  vec2 size;    // of the picture
  vec2 offset;  // of the sample from the pixel's centre, pixels
};

layout(location = 0) out uint seen;

void main() {
  Sight sight = sightThrough(2.0 * (gl_FragCoord.xy + offset) / size - 1.0);
  vec3 radiance;
  float far = distanceToLights(sight.origin, sight.direction, true, radiance);
  if (isinf(far)) discard;
  vec4 clip = frame.worldToClip * vec4(sight.origin + far * sight.direction, 1.0);
  gl_FragDepth = clamp(clip.z / clip.w, 0.0, 1.0);
  seen = 0u;
}

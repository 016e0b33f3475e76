// The diffusion source map (Gong et al. 2008, section 3): position, normal, the irradiance that enters
// (Eq. 7 and 9) and the area that the texel stands for on the surface as it is in this frame.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_IRRADIANCE 7
#include "lib/irradiance.glsl"
#include "lib/material.glsl"
#include "lib/unit.glsl"

layout(set = 0, binding = 8) uniform sampler2D texelSurface;

layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in uint object;

layout(location = 0) out vec4 positionArea;      // mm, mm²
layout(location = 1) out vec4 unitNormal;
layout(location = 2) out vec4 irradianceObject;  // object + 1

void main() {
  // Everything is taken at the middle of what the texel stands for. Beside the border of a chart that
  // is not the texel's centre.
  vec3 along = dFdx(centre);
  vec3 across = dFdy(centre);
  vec3 surface = texelFetch(texelSurface, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 position = centre + surface.x * along + surface.y * across;
  vec3 n = unitOr(normal + surface.x * dFdx(normal) + surface.y * dFdy(normal), vec3(0.0, 1.0, 0.0));
  vec3 irradiance =
      irradianceAt(position, n, cross(along, across), mediumAt(objects[object], position));

  positionArea = vec4(position, surface.z * length(cross(along, across)));
  unitNormal = vec4(n, 0.0);
  irradianceObject = vec4(irradiance, float(object + 1u));
}

// Visibility of the frame's lights. Needs lib/frame.glsl and, before it, a definition of
// SHADOW_BINDING.
#ifndef OPALINE_LIB_SHADOW
#define OPALINE_LIB_SHADOW
#include "lib/light.glsl"

layout(set = 0, binding = SHADOW_BINDING) uniform sampler2DArray shadowMaps;

// Face of the cube map that a direction falls on: +x, -x, +y, -y, +z, -z.
uint cubeFace(vec3 direction) {
  vec3 size = abs(direction);
  if (size.x >= size.y && size.x >= size.z) return direction.x > 0.0 ? 0u : 1u;
  if (size.y >= size.z) return direction.y > 0.0 ? 2u : 3u;
  return direction.z > 0.0 ? 4u : 5u;
}

// Depth 0 is where nothing casts a shadow. What receives one may lie beyond all that casts one.
float shadowDepthMm(LightData light, float depth) {
  return isParallel(light.kind.x) ? light.depth.x + light.depth.y * depth
                                  : light.depth.x / (light.depth.y + depth);
}

vec4 litAt(LightData light, vec4 depths, float receiverMm) {
  vec4 lit;
  for (int i = 0; i < 4; ++i) lit[i] = depths[i] <= 0.0 || receiverMm <= shadowDepthMm(light, depths[i]) ? 1.0 : 0.0;
  return lit;
}

// How far from a place the shadow map is read there, mm; `away` is the distance of the light.
float filteredOver(IncidentLight incident, float away) {
  const float texels = 2.0;
  return texels * frame.lights[incident.light].texel.x * (isParallel(incident.kind) ? 1.0 : away);
}

// How the depth of a plane changes from one point of the light's view to the next, relative to their
// distance. Cube faces hold depth along their axis, so a plane that faces a point light away from
// that axis has a slope too. With z(d) = const / n·d for rays d = (u, v, 1), |∇z| = z |n_uv| / |n·d|.
float depthSlope(LightData light, vec3 toLight, vec3 normal) {
  float alongAxis = dot(normal, toLight);
  float facing = alongAxis;
  if (!isParallel(light.kind.x)) {
    vec3 size = abs(toLight);
    float depth = max(size.x, max(size.y, size.z));
    alongAxis = depth == size.x ? normal.x : depth == size.y ? normal.y : normal.z;
    if (hasOneView(light)) {
      depth = -dot(toLight, light.view.xyz);
      alongAxis = dot(normal, light.view.xyz);
    }
    facing /= depth;
  }
  return sqrt(max(1.0 - alongAxis * alongAxis, 0.0)) / max(facing, 1e-3);
}

// Depth from a distant light is rounded to this part of the distance.
const float roundingOfDepth = 4e-7;

// Percentage-closer filtering (Reeves et al. 1987) over a box of 3×3 texels, continuous in the
// position of the receiver. The bias is what the slope of the surface makes of the way to the
// furthest texel read, 2√2 texels. So it stays a few shadow texels whatever the size of the object.
float visibilityOf(IncidentLight incident, vec3 position, vec3 normal) {
  LightData light = frame.lights[incident.light];
  bool parallel = isParallel(incident.kind);
  vec3 toLight = parallel ? light.place.xyz : light.place.xyz - position;
  if (!parallel && incident.irradiance == vec3(0.0)) return 0.0;  // it may lie beside its only view
  uint layer = light.kind.y + (hasOneView(light) ? 0u : cubeFace(-toLight));

  vec4 clip = frame.shadowViews[layer] * vec4(position, 1.0);
  if (clip.w <= 0.0) return 1.0;  // the light is between it and all that casts shadows
  float size = float(frame.counts.y);
  vec2 place = (clip.xy / clip.w * 0.5 + 0.5) * size - 0.5;
  float receiverMm = shadowDepthMm(light, clip.z / clip.w);
  float texelMm = light.texel.x * (parallel ? 1.0 : receiverMm);
  receiverMm -= texelMm * (0.5 + 2.83 * min(depthSlope(light, toLight, normal), 8.0));
  if (!parallel) receiverMm -= roundingOfDepth * receiverMm;

  vec2 base = floor(place);
  vec2 f = place - base;
  vec4 weightX = vec4(1.0 - f.x, 1.0, 1.0, f.x);
  vec4 weightY = vec4(1.0 - f.y, 1.0, 1.0, f.y);
  float sum = 0.0;
  for (int j = 0; j < 4; j += 2) {
    for (int i = 0; i < 4; i += 2) {
      // Gathers the quad whose lower texel is base + (i - 1, j - 1).
      vec2 uv = (base + vec2(float(i), float(j))) / size;
      vec4 lit = litAt(light, textureGather(shadowMaps, vec3(uv, float(layer))), receiverMm);
      sum += weightY[j + 1] * (weightX[i] * lit.x + weightX[i + 1] * lit.y) +
             weightY[j] * (weightX[i + 1] * lit.z + weightX[i] * lit.w);
    }
  }
  return sum / 9.0;
}

#endif

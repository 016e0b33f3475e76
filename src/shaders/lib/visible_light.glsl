// The area lights that lines of sight meet. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_VISIBLE_LIGHT
#define OPALINE_LIB_VISIBLE_LIGHT
#include "lib/light.glsl"

const float notMet = -1.0;

float distanceToPlanar(LightData light, vec3 from, vec3 direction) {
  vec3 u = light.axis.xyz;
  vec3 v = light.cone.xyz;
  vec3 normal = cross(u, v);
  float facing = -dot(normal, direction);
  if (facing == 0.0 || facing < 0.0 && light.power.w == 0.0) return notMet;
  float along = dot(normal, from - light.place.xyz) / facing;
  vec3 offset = from + along * direction - light.place.xyz;
  vec2 place = vec2(dot(cross(offset, v), normal), dot(cross(u, offset), normal)) / dot(normal, normal);
  bool inside = light.kind.w == discShape ? dot(place, place) <= 1.0
                                          : max(abs(place.x), abs(place.y)) <= 1.0;
  return inside && along > 0.0 ? along : notMet;
}

// Distance to the near side of a round light, whose middle is nearest to the line at `along` it and
// `aside` of it. `slant` is the part of the way that goes across the light.
float distanceToRound(float along, float aside, float slant, float radius) {
  if (aside >= radius) return notMet;
  float near = along - sqrt(radius * radius - aside * aside) / slant;
  return near > 0.0 ? near : notMet;
}

float distanceToSphere(LightData light, vec3 from, vec3 direction) {
  vec3 towards = light.place.xyz - from;
  float along = dot(towards, direction);
  return distanceToRound(along, length(towards - along * direction), 1.0, light.cone.w);
}

float distanceToTube(LightData light, vec3 from, vec3 direction) {
  float reach = length(light.axis.xyz);
  vec3 axis = light.axis.xyz / reach;
  vec3 across = direction - dot(direction, axis) * axis;
  float slant = length(across);
  if (slant == 0.0) return notMet;
  vec3 offset = light.place.xyz - from;
  vec3 towards = offset - dot(offset, axis) * axis;
  float along = dot(towards, across) / (slant * slant);
  float near = distanceToRound(along, length(towards - along * across), slant, light.cone.w);
  return abs(dot(near * direction - offset, axis)) <= reach ? near : notMet;
}

// Infinity where no light is met; else its radiance is set. Some lights are not seen in the picture itself.
float distanceToLights(vec3 from, vec3 direction, bool inPicture, out vec3 radiance) {
  float nearest = uintBitsToFloat(0x7f800000u);
  radiance = vec3(0.0);
  for (uint i = firstAreaLight(); i < allLightsAt(direction); ++i) {
    LightData light = frame.lights[i];
    if (inPicture && light.depth.x == 0.0) continue;
    float met = light.kind.w == sphereShape ? distanceToSphere(light, from, direction)
              : light.kind.w == tubeShape   ? distanceToTube(light, from, direction)
                                            : distanceToPlanar(light, from, direction);
    if (met <= 0.0 || met >= nearest) continue;
    nearest = met;
    radiance = light.power.rgb;
  }
  return nearest;
}

#endif

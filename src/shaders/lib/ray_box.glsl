// Boxes that rays are sent through (shared/rays.h), in their units.
#ifndef OPALINE_LIB_RAY_BOX
#define OPALINE_LIB_RAY_BOX
#include "shared/rays.h"

// Smaller numbers become this, because a device may make halves below it 0.
const float leastHalf = 1.0 / 16384.0;

// The largest half float that is not above a number, as bits.
uint halfBelow(float number) {
  if (abs(number) < leastHalf) number = -leastHalf;
  uint bits = packHalf2x16(vec2(number, 0.0)) & 0xffffu;
  if (unpackHalf2x16(bits).x <= number) return bits;
  return number < 0.0 ? bits + 1u : bits - 1u;
}

uint halfAbove(float number) {
  return halfBelow(-number) ^ 0x8000u;
}

RayBox packedBox(vec3 low, vec3 high, uint link) {
  uvec4 sides = uvec4(0u, 0u, 0u, link);
  for (int axis = 0; axis < 3; ++axis) sides[axis] = halfBelow(low[axis]) | halfAbove(high[axis]) << 16;
  return RayBox(sides);
}

// Its low and its high side.
mat2x3 sidesOf(RayBox box) {
  vec2 x = unpackHalf2x16(box.sidesLink.x);
  vec2 y = unpackHalf2x16(box.sidesLink.y);
  vec2 z = unpackHalf2x16(box.sidesLink.z);
  return mat2x3(x.x, y.x, z.x, x.y, y.y, z.y);
}

#endif

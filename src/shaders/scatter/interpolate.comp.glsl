// Interpolates light between the knots of a block where it changes evenly from each to the next. Where it does not,
// lists surfaces to sum: for a wide block the knots of its quarters, for a narrow one all.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 2
#define BINDING_SURFACES 3
#define BINDING_NODES 5
#define MESH_BINDING 10
layout(local_size_x = 64) in;
#include "lib/frame.glsl"
#include "lib/darkest.glsl"
#include "lib/seen.glsl"
#include "lib/listing.glsl"
#include "lib/origin.glsl"
#include "lib/tolerance.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Blocks { uint blocks[]; };
layout(std430, set = 0, binding = 7) readonly buffer Entries { uint entryOfPixel[]; };
layout(std430, set = 0, binding = 8) buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 9) buffer Paint { vec4 paint[]; };
layout(std430, set = 0, binding = 14) writeonly buffer BlocksAfter { uint blocksAfter[]; };

layout(std430, set = 0, binding = 15) buffer Origins { vec4 origins[]; };

layout(constant_id = 0) const uint withPaint = 0u;

layout(push_constant) uniform Push {
  uint firstRow;  // of the band
  uint rows;
  float tolerance;
  uint wide;  // 1: wide blocks, 0: narrow ones
  uint keepsOrigins;
};

#include "lib/neighbours.glsl"
#include "lib/blocks.glsl"

// How far a straight line between two knots may be off, in parts of a node's tolerance.
const float partTolerated = 0.1;

int blockWidth() {
  return wide != 0u ? wideBlock : narrowBlock;
}

struct Knots {
  uint entries[9];  // from left to right and downwards
};

Knots knotsOf(ivec2 first) {
  Knots knots;
  for (int i = 0; i < 9; ++i)
    knots.entries[i] = entryOfPixel[indexOf(first + blockWidth() / 2 * ivec2(i % 3, i / 3))];
  return knots;
}

// How far off a straight line is in the middle between two of three knots, by their parabola.
vec3 errorOfLine(vec3 a, vec3 b, vec3 c) {
  return abs(a - 2.0 * b + c) / 8.0;
}

bool changesEvenly(Knots knots, ObjectData body) {
  vec3 light[9];
  vec3 least = vec3(3e38);
  for (int i = 0; i < 9; ++i) {
    light[i] = exitances[knots.entries[i]].rgb;
    least = min(least, light[i]);
  }
  vec3 error = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    error = max(error, errorOfLine(light[3 * i], light[3 * i + 1], light[3 * i + 2]));
    error = max(error, errorOfLine(light[i], light[i + 3], light[i + 6]));
  }
  vec3 about = max(least, darkestOf(body, body.tree.x));
  return all(lessThanEqual(error, toleratedAt(about, partTolerated * tolerance)));
}

// Weights of three knots by their parabola, at `t` of their distances from the first.
vec3 weightsAt(float t) {
  return vec3(0.5 * (t - 1.0) * (t - 2.0), t * (2.0 - t), 0.5 * t * (t - 1.0));
}

void interpolate(ivec2 pixel, vec2 at, Knots knots) {
  vec3 across = weightsAt(at.x);
  vec3 down = weightsAt(at.y);
  vec3 light = vec3(0.0);
  vec4 entered = vec4(0.0);
  vec4 origin = vec4(0.0);
  for (int i = 0; i < 9; ++i) {
    float weight = across[i % 3] * down[i / 3];
    light += weight * exitances[knots.entries[i]].rgb;
    if (keepsOrigins != 0u) origin += weight * origins[knots.entries[i]];
    if (withPaint != 0u) entered += weight * paint[knots.entries[i]];
  }
  uint entry = entryOfPixel[indexOf(pixel)];
  // No profile is evaluated for it, so w is 0.
  exitances[entry] = vec4(max(light, vec3(0.0)), 0.0);
  // All knots of a block belong to one body.
  if (keepsOrigins != 0u)
    origins[entry] = isKnown(origins[knots.entries[0]]) ? max(origin, vec4(0.0)) : unknownOrigin;
  if (withPaint != 0u) paint[entry] = max(entered, vec4(0.0));
}

// Which of the invocation's pixels are summed where light does not change evenly.
bool isListed(ivec2 pixel) {
  return !isKnot(pixel, blockWidth()) && (wide == 0u || isKnot(pixel, narrowBlock));
}

void main() {
  ivec2 first = firstOfInvocation();
  uint block = isInBand(first) ? blocks[blockOf(first)] : 0u;
  bool here = block == (wide != 0u ? isWide : isNarrow);
  bool even = false;
  if (here) {
    ivec2 start = first - (first - ivec2(0, firstRow)) % blockWidth();
    Knots knots = knotsOf(start);
    even = changesEvenly(knots, objects[objectOfTriangle(triangleOf(seenWord(first, 0u)))]);
    for (int i = 0; even && i < pixelsOfBlock; ++i) {
      ivec2 pixel = pixelOfBlock(first, i);
      if (!isKnot(pixel, blockWidth())) interpolate(pixel, vec2(pixel - start) / float(blockWidth() / 2), knots);
    }
    block = even ? isDone : isNarrow;
  }
  if (wide != 0u && isInBand(first)) blocksAfter[blockOf(first)] = block;
  bool lists = here && !even;
  uint count = 0u;
  for (int i = 0; i < pixelsOfBlock; ++i) count += lists && isListed(pixelOfBlock(first, i)) ? 1u : 0u;
  uint place = placesForSurfaces(count);
  for (int i = 0; i < pixelsOfBlock; ++i) {
    ivec2 pixel = pixelOfBlock(first, i);
    if (lists && isListed(pixel)) surfaces[place++] = entryOfPixel[indexOf(pixel)];
  }
}

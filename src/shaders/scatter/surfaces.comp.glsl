// Finds the surfaces that the samples of a pixel see, where these see several triangles. Samples
// that see one surface, all of it smooth, share one sum and one shading. Words of triangles become
// words of surfaces in place.
#version 460
#extension GL_GOOGLE_include_directive : require
#define MESH_BINDING 4
#include "lib/frame.glsl"
#include "lib/linear.glsl"
#include "lib/mesh.glsl"
#include "lib/samples.glsl"
#include "shared/seen.h"

layout(set = 0, binding = 1, r32ui) uniform uimage2DArray words;
layout(std430, set = 0, binding = 2) readonly buffer Mixed { uint mixed[]; };  // pixels
layout(std140, set = 0, binding = 3) uniform MixedCount { SeenCount mixedCount; };

layout(push_constant) uniform Push {
  uint samples;
};

// How far normals of one surface differ, seen head on. Where it is grazed, they differ less, because
// light changes faster there.
const float mostTurned = 0.1;
// Sine of the angle by which the way from one sample to another may leave the planes of their
// triangles. Facets of a smooth surface are not flush; a step to what lies behind is steeper.
const float mostOffPlane = 0.4;

bool isOneSurface(MeshPlace a, MeshPlace b) {
  vec3 between = b.position - a.position;
  vec3 toCamera = normalize(toCameraFrom(a.position));
  float facing = min(dot(a.facet, toCamera), dot(b.facet, toCamera));
  float most = mostOffPlane * facing * length(between);
  return a.object == b.object && a.side == b.side &&
         distance(a.normal, b.normal) <= mostTurned * facing &&
         abs(dot(a.facet, between)) <= most && abs(dot(b.facet, between)) <= most;
}

uint triangleSeen(ivec2 pixel, int sampled) {
  return imageLoad(words, ivec3(pixel, sampled)).r;
}

MeshPlace sampledPlace(ivec2 pixel, uint triangle, int sampled) {
  return placeOn(triangle - 1u, clipAt(pixel, imageSize(words).xy, frame.samples[sampled].xy));
}

// How far inside a triangle a line of sight goes through it; below 0 where it misses it.
float depthInside(uint triangle, vec2 clip) {
  vec3 weights = weightsOn(verticesOf(triangle - 1u), clip);
  return min(min(weights.x, weights.y), weights.z);
}

// The triangle that best stands for the middle of these samples, of those that they see.
uint triangleInMiddle(ivec2 pixel, uint within) {
  vec2 clip = clipAt(pixel, imageSize(words).xy, middleOf(within));
  uint best = triangleSeen(pixel, findLSB(within));
  float deepest = depthInside(best, clip);
  for (uint rest = within & (within - 1u); rest != 0u && deepest < 0.0; rest &= rest - 1u) {
    uint other = triangleSeen(pixel, findLSB(rest));
    if (other == best) continue;
    float depth = depthInside(other, clip);
    if (depth <= deepest) continue;
    best = other;
    deepest = depth;
  }
  return best;
}

// The samples in `pending` that see the same surface as the first of them.
uint samplesWithFirst(ivec2 pixel, uint pending, out bool several) {
  int first = findLSB(pending);
  uint triangle = triangleSeen(pixel, first);
  uint within = 1u << first;
  several = false;
  MeshPlace place = sampledPlace(pixel, triangle, first);
  for (uint rest = pending & (pending - 1u); rest != 0u; rest &= rest - 1u) {
    int other = findLSB(rest);
    uint next = triangleSeen(pixel, other);
    bool same = next == triangle;
    if (!same) {
      same = isOneSurface(place, sampledPlace(pixel, next, other));
      several = several || same;
    }
    if (same) within |= 1u << other;
  }
  return within;
}

// Words go to layers that have been read, because a surface's first sample is never before its own layer.
void writeSurfaces(ivec2 pixel, uint pending) {
  uint all = (1u << samples) - 1u;
  for (int layer = 0; pending != 0u; ++layer) {
    bool several;
    uint within = samplesWithFirst(pixel, pending, several);
    pending &= ~within;
    uint triangle = several ? triangleInMiddle(pixel, within) : triangleSeen(pixel, findLSB(within));
    uint seeing = within == all ? everySample : within;
    imageStore(words, ivec3(pixel, layer), uvec4(triangle | seeing << seenSamplesShift));
  }
}

void main() {
  uint i = linearIndex();
  bool there = i < mixedCount.groupsEntries.w;
  uint index = mixed[there ? i : 0u];
  int width = imageSize(words).x;
  ivec2 pixel = ivec2(int(index) % width, int(index) / width);
  uint pending = 0u;
  for (uint s = 0u; s < samples; ++s)
    if (there && triangleSeen(pixel, int(s)) != 0u) pending |= 1u << s;
  writeSurfaces(pixel, pending);
}

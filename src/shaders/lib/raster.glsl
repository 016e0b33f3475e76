// Triangles drawn by invocations, because some GPUs have little hardware that draws. A work group draws 64 triangles at
// a time, within some rows of the picture. Its invocations share the pixels that these may cover, so that large
// triangles and small ones keep all of them busy.
//
// A sample is in a triangle where it is on the inner side of all edges, in homogeneous coordinates, so that nothing
// needs to be clipped (Olano and Greer 1997). Triangles that share an edge have the same number for it with opposite
// signs, bit by bit. Where that is 0, one of them has the sample, so there are no holes.
//
// Has bindings 1 and 2. Needs, before it, subgroup arithmetic; after it, the places of a pixel's samples, in pixels from
// its centre, and what to do with each sample at which a triangle may be seen:
//   vec2 sampleAt(uint which)
//   void meet(uint triangle, ivec2 pixel, uint which, float depth)
#ifndef OPALINE_LIB_RASTER
#define OPALINE_LIB_RASTER
#include "lib/group_place.glsl"

layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, set = 0, binding = 2) readonly buffer Positions { vec4 positions[]; };

vec2 sampleAt(uint which);
void meet(uint triangle, ivec2 pixel, uint which, float depth);

// Clip space; depth is reversed.
struct Corners {
  vec4 a;
  vec4 b;
  vec4 c;
};

// Pixels from `low` to below `high`.
struct PixelBox {
  ivec2 low;
  ivec2 high;
};

struct Picture {
  ivec2 size;
  uint samples;  // of a pixel
  uint rows;     // of a band
};

vec4 inClipSpace(mat4 toClip, uint vertex) {
  vec3 place = positions[vertex].xyz;
  precise vec4 clip = toClip[0] * place.x + toClip[1] * place.y + toClip[2] * place.z + toClip[3];
  return clip;
}

Corners cornersOf(mat4 toClip, uint triangle) {
  return Corners(inClipSpace(toClip, indices[3u * triangle]), inClipSpace(toClip, indices[3u * triangle + 1u]),
                 inClipSpace(toClip, indices[3u * triangle + 2u]));
}

// Whether a corner lies outside each side of what is seen: left, above, nearer; right, below, further.
bvec3 isBefore(vec4 corner) {
  return bvec3(corner.x < -corner.w, corner.y < -corner.w, corner.z > corner.w);
}

bvec3 isBeyond(vec4 corner) {
  return bvec3(corner.x > corner.w, corner.y > corner.w, corner.z < 0.0);
}

bool isOutside(Corners its) {
  bvec3 before = bvec3(uvec3(isBefore(its.a)) & uvec3(isBefore(its.b)) & uvec3(isBefore(its.c)));
  bvec3 beyond = bvec3(uvec3(isBeyond(its.a)) & uvec3(isBeyond(its.b)) & uvec3(isBeyond(its.c)));
  return any(before) || any(beyond);
}

// Where the triangle may be seen: everywhere if some of it lies behind the camera.
PixelBox boxOf(Corners its, ivec2 size, int firstRow, int endRow) {
  PixelBox box = PixelBox(ivec2(0, firstRow), ivec2(size.x, endRow));
  if (isOutside(its)) return PixelBox(ivec2(0), ivec2(0));
  if (min(min(its.a.w, its.b.w), its.c.w) <= 0.0) return box;
  vec2 a = its.a.xy / its.a.w;
  vec2 b = its.b.xy / its.b.w;
  vec2 c = its.c.xy / its.c.w;
  const float slack = 1.0 / 64.0;  // pixels; more than rounding makes
  vec2 low = (0.5 * clamp(min(min(a, b), c), -1.0, 1.0) + 0.5) * vec2(size) - slack;
  vec2 high = (0.5 * clamp(max(max(a, b), c), -1.0, 1.0) + 0.5) * vec2(size) + slack;
  box.low = max(box.low, ivec2(floor(low)));
  box.high = min(box.high, ivec2(floor(high)) + 1);
  return box;
}

int pixelsIn(PixelBox box) {
  ivec2 size = max(box.high - box.low, 0);
  return size.x * size.y;
}

// Of two triangles that share an edge with a sample on it, the one to the right or below has the sample. `a` and `b`
// are the ends of the edge as seen from the sample, times `w`; `turned` is the sign of the triangle's area.
bool hasEdge(vec2 a, float wOfA, vec2 b, float wOfB, float turned) {
  precise vec2 along = turned * sign(wOfA * wOfB) * (b * wOfA - a * wOfB);
  return along.y < 0.0 || along.y == 0.0 && along.x > 0.0;
}

// The depth at which the line of sight through that place, clip space over w, meets the triangle; 0 where it misses.
float depthAt(Corners its, vec2 place) {
  precise vec2 a = its.a.xy - its.a.w * place;
  precise vec2 b = its.b.xy - its.b.w * place;
  precise vec2 c = its.c.xy - its.c.w * place;
  precise vec3 areas = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
  float least = min(min(areas.x, areas.y), areas.z);
  float most = max(max(areas.x, areas.y), areas.z);
  bool inside = least >= 0.0 && most > 0.0 || most <= 0.0 && least < 0.0;
  if (!inside) return 0.0;
  float turned = most > 0.0 ? 1.0 : -1.0;
  if (areas.x == 0.0 && !hasEdge(b, its.b.w, c, its.c.w, turned) || areas.y == 0.0 && !hasEdge(c, its.c.w, a, its.a.w, turned) ||
      areas.z == 0.0 && !hasEdge(a, its.a.w, b, its.b.w, turned))
    return 0.0;
  precise float z = areas.x * its.a.z + areas.y * its.b.z + areas.z * its.c.z;
  precise float w = areas.x * its.a.w + areas.y * its.b.w + areas.z * its.c.w;
  precise float depth = z / w;
  return turned * w > 0.0 && depth > 0.0 && depth <= 1.0 ? depth : 0.0;
}

// For the triangles that the group has at a time: their corners, where they may be seen, and how many pixels those
// before them may cover.
shared Corners corners[gl_WorkGroupSize.x];
shared PixelBox boxes[gl_WorkGroupSize.x];
shared uint firsts[gl_WorkGroupSize.x];

// The last triangle that begins at or before that one of all pixels.
uint triangleOfPixel(uint pixel) {
  uint found = 0u;
  for (uint step = gl_WorkGroupSize.x / 2u; step > 0u; step /= 2u)
    if (firsts[found + step] <= pixel) found += step;
  return found;
}

void drawPixel(uint triangle, Corners its, ivec2 pixel, Picture picture) {
  for (uint s = 0u; s < picture.samples; ++s) {
    float depth = depthAt(its, 2.0 * (vec2(pixel) + 0.5 + sampleAt(s)) / vec2(picture.size) - 1.0);
    if (depth > 0.0) meet(triangle, pixel, s, depth);
  }
}

void drawTriangles(uint triangleCount, mat4 toClip, Picture picture) {
  int firstRow = int(gl_WorkGroupID.y * picture.rows);
  int endRow = min(firstRow + int(picture.rows), picture.size.y);
  uint all = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  for (uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x; first < triangleCount; first += all) {
    uint i = gl_LocalInvocationIndex;
    uint count = 0u;
    if (first + i < triangleCount) {
      corners[i] = cornersOf(toClip, first + i);
      boxes[i] = boxOf(corners[i], picture.size, firstRow, endRow);
      count = uint(pixelsIn(boxes[i]));
    }
    uint pixels;
    firsts[i] = groupPlaceFor(count, pixels);
    barrier();
    for (uint k = i; k < pixels; k += gl_WorkGroupSize.x) {
      uint triangle = triangleOfPixel(k);
      PixelBox box = boxes[triangle];
      uint width = uint(box.high.x - box.low.x);
      uint within = k - firsts[triangle];
      drawPixel(first + triangle, corners[triangle], box.low + ivec2(within % width, within / width), picture);
    }
    barrier();
  }
}

#endif

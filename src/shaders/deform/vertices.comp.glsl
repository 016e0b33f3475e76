// Where every vertex is in this frame: morphed, then skinned (glTF 2.0, sections 3.7.2.2 and 3.7.3), or
// where the caller puts it; then through the procedural deformers. Finds the box around all but the ground.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bounds.glsl"
#include "lib/deformers.glsl"
#include "lib/linear.glsl"
#include "lib/unit.glsl"

layout(std140, set = 0, binding = 0) uniform Frame { DeformFrame frame; };
layout(std430, set = 0, binding = 1) readonly buffer Rest { RestVertex rest[]; };
layout(std430, set = 0, binding = 2) readonly buffer FirstDelta { uint firstDelta[]; };
layout(std430, set = 0, binding = 3) readonly buffer Deltas { MorphDelta deltas[]; };
layout(std430, set = 0, binding = 4) readonly buffer Weights { float weights[]; };
layout(std430, set = 0, binding = 5) readonly buffer FirstInfluence { uint firstInfluence[]; };
layout(std430, set = 0, binding = 6) readonly buffer Influences { JointInfluence influences[]; };
layout(std430, set = 0, binding = 7) readonly buffer Matrices { vec4 rows[]; };  // three per matrix
layout(std430, set = 0, binding = 8) readonly buffer Motions { ObjectMotion motions[]; };
layout(std430, set = 0, binding = 9) readonly buffer Replaced { float replaced[]; };
layout(std430, set = 0, binding = 10) writeonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 11) writeonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 12) buffer Bounds { uint bounds[6]; };

shared uvec3 low[64];
shared uvec3 high[64];  // inverted

// Near enough to the scene that sums over its bodies stay in the range of floats. False for NaN too.
bool usable(vec3 p) {
  return all(lessThan(abs(p - frame.middle.xyz), vec3(frame.middle.w)));
}

void morph(uint v, inout Posed p) {
  for (uint i = firstDelta[v]; i < firstDelta[v + 1u]; ++i) {
    float weight = weights[deltas[i].weight];
    if (weight == 0.0) continue;
    p.position += weight * vec3(deltas[i].x, deltas[i].y, deltas[i].z);
    p.normal += weight * vec3(deltas[i].normalX, deltas[i].normalY, deltas[i].normalZ);
  }
}

void skin(uint v, inout Posed p) {
  vec4 x = vec4(0.0);
  vec4 y = vec4(0.0);
  vec4 z = vec4(0.0);
  uint end = firstInfluence[v + 1u];
  uint i = firstInfluence[v];
  if (i == end) return;
  for (; i < end; ++i) {
    float weight = influences[i].weight;
    uint row = 3u * influences[i].matrix;
    x += weight * rows[row];
    y += weight * rows[row + 1u];
    z += weight * rows[row + 2u];
  }
  vec4 from = vec4(p.position, 1.0);
  p.position = vec3(dot(x, from), dot(y, from), dot(z, from));
  // Rows of the cofactors: a mirror turns the surface's winding with it.
  vec3 n = p.normal;
  vec3 to = vec3(dot(cross(y.xyz, z.xyz), n), dot(cross(z.xyz, x.xyz), n), dot(cross(x.xyz, y.xyz), n));
  p.normal = dot(x.xyz, cross(y.xyz, z.xyz)) < 0.0 ? -to : to;
}

Posed posed(uint v) {
  RestVertex r = rest[v];
  Posed p = Posed(vec3(r.x, r.y, r.z), vec3(r.normalX, r.normalY, r.normalZ));
  if (motions[r.object].replaced != 0u) {
    vec3 given = vec3(replaced[3u * v], replaced[3u * v + 1u], replaced[3u * v + 2u]);
    if (usable(given)) return Posed(given, p.normal);
  }
  if (frame.counts.z != 0u) morph(v, p);
  if (frame.counts.w != 0u) skin(v, p);
  p.normal = unitOr(p.normal, vec3(0.0, 1.0, 0.0));
  return p;
}

// Smallest and inverted largest of the group's vertices, then of all groups'.
void addToBounds(uint lane) {
  for (uint stride = 32u; stride > 0u; stride >>= 1u) {
    barrier();
    if (lane < stride) {
      low[lane] = min(low[lane], low[lane + stride]);
      high[lane] = min(high[lane], high[lane + stride]);
    }
  }
  if (lane != 0u) return;
  for (int axis = 0; axis < 3; ++axis) {
    atomicMin(bounds[axis], low[0][axis]);
    atomicMin(bounds[axis + 3], high[0][axis]);
  }
}

void main() {
  uint v = linearIndex();
  uint lane = gl_LocalInvocationID.x;
  low[lane] = uvec3(0xffffffffu);
  high[lane] = uvec3(0xffffffffu);
  if (v < frame.counts.x) {
    Posed p = posed(v);
    bool stands = motions[rest[v].object].isGround != 0u;
    for (uint i = 0u; i < (stands ? 0u : frame.counts.y); ++i) p = deformed(p, frame.deformers[i]);
    if (!stands && !usable(p.position)) p.position = frame.middle.xyz;
    positions[v] = vec4(p.position, 1.0);
    normals[v] = vec4(unitOr(p.normal, vec3(0.0, 1.0, 0.0)), motions[rest[v].object].side);
    for (int axis = 0; axis < 3 && !stands; ++axis) {
      low[lane][axis] = ordered(p.position[axis]);
      high[lane][axis] = ~ordered(p.position[axis]);
    }
  }
  addToBounds(lane);
}

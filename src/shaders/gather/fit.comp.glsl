// Fits what the frame looks through to the box around the moved scene: every shadow map and the
// camera's near plane. One invocation per light, and one for the camera.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bounds.glsl"
#include "shared/frame.h"

layout(local_size_x = 32) in;

layout(std430, set = 0, binding = 0) buffer Frame { FrameData frame; };
layout(std430, set = 0, binding = 1) readonly buffer Bounds { uint bounds[6]; };

// Stands in for lengths of 0, mm: shorter than any scene.
const float leastLength = 1e-20;

// Texels that percentage-closer filtering reaches beyond the receiver's own.
const float filterBorder = 3.0;

struct Box {
  vec3 low;
  vec3 high;
};

struct Basis {
  vec3 right;
  vec3 up;
  vec3 forward;
};

Box sceneBox() {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = unordered(bounds[axis]);
    box.high[axis] = unordered(~bounds[axis + 3]);
  }
  return box;
}

float distanceTo(Box box, vec3 point) {
  return distance(point, clamp(point, box.low, box.high));
}

Basis basisAlong(vec3 forward) {
  vec3 helper = abs(forward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  vec3 right = normalize(cross(forward, helper));
  return Basis(right, cross(right, forward), forward);
}

// Lowest and highest value of the box along an axis.
vec2 extent(Box box, vec3 axis) {
  vec3 a = axis * box.low;
  vec3 b = axis * box.high;
  vec3 least = min(a, b);
  vec3 most = max(a, b);
  return vec2(least.x + least.y + least.z, most.x + most.y + most.z);
}

vec2 widened(vec2 interval, float by) {
  return interval + vec2(-by, by);
}

mat4 fromRows(vec4 x, vec4 y, vec4 z, vec4 w) {
  return transpose(mat4(x, y, z, w));
}

// Maps the interval to [-1, 1].
vec4 fittedRow(vec3 axis, vec2 interval) {
  float size = interval.y - interval.x;
  return vec4(axis * (2.0 / size), -(interval.x + interval.y) / size);
}

// An orthographic view; depth is reversed.
void fitDirectional(uint light, Box box) {
  float mapSize = float(frame.counts.y);
  Basis basis = basisAlong(-frame.lights[light].place.xyz);
  vec2 x = extent(box, basis.right);
  vec2 y = extent(box, basis.up);
  vec2 z = extent(box, basis.forward);
  vec3 size = vec3(x.y - x.x, y.y - y.x, z.y - z.x);
  float slack = 1e-3 * max(max(size.x, size.y), max(size.z, leastLength));
  x = widened(x, slack + size.x * filterBorder / mapSize);
  y = widened(y, slack + size.y * filterBorder / mapSize);
  z = widened(z, slack);
  float depth = z.y - z.x;
  frame.shadowViews[frame.lights[light].kind.y] =
      fromRows(fittedRow(basis.right, x), fittedRow(basis.up, y),
               vec4(-basis.forward / depth, z.y / depth), vec4(0.0, 0.0, 0.0, 1.0));
  frame.lights[light].view = vec4(basis.forward, 1.0);
  frame.lights[light].depth = vec4(z.y, -depth, 0.0, 0.0);
  frame.lights[light].texel.x = max(x.y - x.x, y.y - y.x) / mapSize;
}

// From the position, past a place straight ahead, which may be the position itself. Extends to the tangent on either
// side.
mat4 perspectiveView(vec3 position, vec3 ahead, vec3 forward, float tangent, float near) {
  Basis basis = basisAlong(forward);
  return fromRows(vec4(basis.right, -dot(basis.right, ahead)) / tangent,
                  vec4(basis.up, -dot(basis.up, ahead)) / tangent, vec4(0.0, 0.0, 0.0, near),
                  vec4(forward, -dot(forward, position)));
}

// Sees nothing.
mat4 emptyView() {
  return fromRows(vec4(0.0, 0.0, 0.0, 2.0), vec4(0.0), vec4(0.0), vec4(0.0, 0.0, 0.0, 1.0));
}

const float boundless = 3e38;

// The tangent to which a view of the box extends on either side, or `boundless` where part of it is beside or behind.
float tangentOf(Box box, vec3 position, vec3 forward) {
  Basis basis = basisAlong(forward);
  float tangent = 0.0;
  for (uint i = 0u; i < 8u; ++i) {
    vec3 way = mix(box.low, box.high, bvec3(i & 1u, i & 2u, i & 4u)) - position;
    float depth = dot(way, forward);
    if (depth <= 1e-3 * length(way)) return boundless;
    tangent = max(tangent, max(abs(dot(way, basis.right)), abs(dot(way, basis.up))) / depth);
  }
  return max(1.001 * tangent, 1e-6);
}

// One perspective view of the box, if that is narrower than the light's own: six of 90°, or one of a cone. Each is
// wider by as much as filtering reaches beyond its edge.
void fitPoint(uint light, Box box) {
  vec3 position = frame.lights[light].place.xyz;
  uvec4 kind = frame.lights[light].kind;
  float mapSize = float(frame.counts.y);
  float diagonal = distance(box.low, box.high);
  float away = distanceTo(box, position);
  // A face's depth is at least 1/√3 of the distance, and half of it in a cone of 50°.
  float near = max(max(0.5 * away, 1e-3 * diagonal), leastLength);
  bool one = kind.z == 1u;
  float tangent = one ? frame.lights[light].cone.z : 1.0;
  vec3 only = frame.lights[light].axis.xyz;
  vec3 ahead = position;
  vec3 middle = mix(box.low, box.high, 0.5);
  if (away > 0.0) {
    vec3 towards = normalize(middle - position);
    float ofBox = tangentOf(box, position, towards);
    if (ofBox < tangent) {
      one = true;
      tangent = ofBox;
      only = towards;
      ahead = middle;
    }
  }
  tangent *= 1.0 + 2.0 * filterBorder / mapSize;
  for (uint view = 0u; view < kind.z; ++view) {
    vec3 forward = vec3(0.0);
    forward[view / 2u] = (view & 1u) == 0u ? 1.0 : -1.0;
    frame.shadowViews[kind.y + view] =
        one && view > 0u ? emptyView() : perspectiveView(position, ahead, one ? only : forward, tangent, near);
  }
  frame.lights[light].view = vec4(only, one ? 1.0 : 0.0);
  frame.lights[light].depth = vec4(near, 0.0, 0.0, 0.0);
  frame.lights[light].texel.x = 2.0 * tangent / mapSize;
}

// What lies behind an orthographic camera is not seen. Its plane arrives in the place of the row for depth.
void fitParallelCamera(Box box) {
  vec3 axis = frame.cameraAxis.xyz;
  float plane = frame.worldToClip[3][2];
  float slack = max(1e-3 * distance(box.low, box.high), leastLength);
  vec2 scene = widened(extent(box, axis), slack);
  float near = frame.cameraAxis.w != 0.0 ? plane : max(plane, scene.x);
  float depth = max(scene.y - near, slack);
  vec4 row = vec4(-axis, near + depth) / depth;
  for (int column = 0; column < 4; ++column) frame.worldToClip[column][2] = row[column];
}

void fitCamera(Box box) {
  if (frame.cameraPosition.w == 0.0) {
    fitParallelCamera(box);
    return;
  }
  float diagonal = distance(box.low, box.high);
  float away = frame.cameraAxis.w != 0.0 ? 0.0 : distanceTo(box, frame.cameraPosition.xyz);
  // Depth is reversed and a float, so it is as exact however near the plane is.
  float near = max(max(0.5 * away, 1e-6 * diagonal), leastLength);
  frame.worldToClip[3][2] = near;
}

void main() {
  uint i = gl_LocalInvocationID.x;
  Box box = sceneBox();
  if (i == maxLights) {
    fitCamera(box);
  } else if (i < frame.counts.x) {
    if (frame.lights[i].kind.x == directionalLight) {
      fitDirectional(i, box);
    } else {
      fitPoint(i, box);
    }
  }
}

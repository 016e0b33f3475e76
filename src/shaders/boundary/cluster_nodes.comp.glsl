// Inner nodes of the tree of clusters from their children: the shape.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_TREELETS 0
#include "lib/moment.glsl"
#include "lib/treelets.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 4) coherent buffer Nodes { ClusterNode nodes[]; };

layout(push_constant) uniform Push {
  uint firstTreelet;
  uint treeletCount;
};

void fitNode(uint node, uint link) {
  uint end = afterNode(node, link);

  float area = 0.0;
  vec3 byArea = vec3(0.0);
  vec3 vectorArea = vec3(0.0);
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    float itsArea = nodes[child].spread.w;
    area += itsArea;
    byArea += itsArea * nodes[child].centroidLink.xyz;
    vectorArea += nodes[child].vectorArea.xyz;
  }
  vec3 middle = area > 0.0 ? byArea / area : nodes[node + 1u].centroidLink.xyz;
  float radius = 0.0;
  float reach = 0.0;
  float square = 0.0;
  Moment moment = Moment(vec4(0.0), vec2(0.0));
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    vec3 offset = nodes[child].centroidLink.xyz - middle;
    vec4 spread = nodes[child].spread;
    float away = length(offset);
    radius = max(radius, away + spread.x);
    reach = max(reach, away + spread.z);
    square += spread.w * (spread.y + away * away);
    Moment shifted = momentOfArea(nodes[child].vectorArea.xyz, offset);
    moment.first += nodes[child].moment + shifted.first;
    moment.rest += nodes[child].momentRest.xy + shifted.rest;
  }
  if (area > 0.0) square /= area;
  nodes[node] = ClusterNode(vec4(middle, uintBitsToFloat(link)), vec4(radius, square, reach, area),
                            vec4(vectorArea, nodes[node + 1u].vectorArea.w), moment.first,
                            vec4(moment.rest, 0.0, 0.0));
}

void main() {
  fitTreelets(firstTreelet, treeletCount);
}

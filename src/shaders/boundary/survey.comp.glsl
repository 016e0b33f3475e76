// Rays from every cluster that ask for nothing but the shape: inwards, how thick the body is, and
// outwards, what of the scene it sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_PIECE_CORNERS 2
#define BINDING_RAYS 3
#include "lib/boundary.glsl"
#include "lib/fresnel.glsl"
#include "lib/linear.glsl"
#include "lib/rays.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Meetings { Meeting meetings[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
  uint raysOutwards;  // of each cluster
  uint nodeCount;     // of all surfels' trees
};

// Part of the light that is followed to its second collision: where little of it scatters again,
// diffusion from the first is too rough. Not where clusters are larger than some mean free paths:
// light that leaves after one collision does so within a cluster's size there.
vec3 shareOfSecond(BoundaryMedium medium, float edge) {
  return (1.0 - whitenessOf(medium)) * (1.0 - smoothstep(1.5, 3.0, edge * medium.extinction.rgb));
}

float transmittedInto(float eta, float cosine) {
  return 1.0 - fresnelReflectance(eta, cosine);
}

// The k-th of many directions about a normal, as dense as their cosine; `along` turns them.
vec3 cosineDirection(uint k, uint count, float turn, vec3 normal, vec3 along) {
  const float golden = 2.39996322972865;
  float squared = (float(k) + 0.5) / float(count);
  float angle = golden * float(k) + turn;
  vec3 across = cross(normal, along);
  return sqrt(squared) * (cos(angle) * along + sin(angle) * across) + sqrt(1.0 - squared) * normal;
}

// Any number in [0, 2π), another one for each cluster.
float turnOf(uint cluster) {
  return 2.0 * pi * fract(0.618033988749895 * float(cluster % 4096u));
}

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

struct PieceFrame {
  vec3 middle;
  vec3 normal;
  vec3 along;
};

PieceFrame frameOf(uint piece, float side) {
  vec3 a = texelFetch(pieceCorners, 3 * int(piece)).xyz;
  vec3 b = texelFetch(pieceCorners, 3 * int(piece) + 1).xyz;
  vec3 c = texelFetch(pieceCorners, 3 * int(piece) + 2).xyz;
  return PieceFrame((a + b + c) / 3.0, side * unitOr(cross(b - a, c - a), vec3(0.0)),
                    unitOr(b - a, vec3(0.0)));
}

void lookAround(uint i, inout Cluster cluster, ClusterRange range) {
  ObjectData own = objects[range.object];
  uint first = range.firstSurfel * piecesPerSurfel;
  uint count = range.endSurfel * piecesPerSurfel - first;
  float least = rayStartOf(cluster);
  float side = cluster.along.w;
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  float sky = 0.0;
  float all = 0.0;
  for (uint k = 0u; k < raysOutwards; ++k) {
    // From all over the cluster.
    PieceFrame place = frameOf(first + (2u * k + 1u) * count / (2u * raysOutwards), side);
    if (place.normal == vec3(0.0)) place = PieceFrame(cluster.start.xyz, cluster.facet.xyz, cluster.along.xyz);
    // Turned in steps that do not go along with those over the cluster.
    vec3 direction = cosineDirection((k * 7u) % raysOutwards, raysOutwards, turnOf(i), place.normal, place.along);
    float eta = mediumAt(own, place.middle).boundary.x;
    float entering = transmittedInto(eta, dot(direction, place.normal));
    RayHit hit = nearestHit(place.middle, direction, least, 3e38, scene);
    all += entering;
    Meeting meeting = Meeting(noCluster, 0.0, 0.0);
    if (hit.piece == noPiece) {
      sky += entering;
    } else {
      vec3 met = place.middle + hit.distance * direction;
      MediumData other = mediumAt(objects[objectOfPiece(hit.piece)], met);
      uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
      float cosine = -clusters[cluster].along.w * dot(facetNormal(hit.piece), direction);
      if (cosine > 0.0)
        meeting = Meeting(cluster, entering / (other.inside.extinction.w * float(raysOutwards)),
                          transmittedInto(other.boundary.x, cosine));
    }
    meetings[i * raysOutwards + k] = meeting;
  }
  cluster.facet.w = all > 0.0 ? sky / all : 1.0;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  Cluster cluster = clusters[i];
  ClusterRange range = ranges[i];
  ObjectData body = objects[range.object];
  RayHit through = nearestExit(cluster.start.xyz, -cluster.facet.xyz, cluster.along.w,
                               rayStartOf(cluster), 3e38,
                               RayTarget(body.tree.x, body.tree.y, range.object));
  float thickness = through.piece == noPiece ? 1e18 : through.distance;
  if (raysOutwards > 0u) lookAround(i, cluster, range);
  clusters[i].start.w = thickness;
  clusters[i].facet.w = cluster.facet.w;
  clusters[i].second = vec4(
      shareOfSecond(insideOf(body), sqrt(cluster.centroidArea.w)),
      range.hasInside != 0u ? 1.0 : 0.0);
}

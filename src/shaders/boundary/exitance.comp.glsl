// What leaves through every cluster with an inside, M = M₁ + x / 2A + sE, added to that of light which entered before.
// sE is what has entered at the surface. x is the rest of the fluence times α': the combination of the solver's basis
// that leaves the smallest residual.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_PAINTS 10
#define BINDING_PEAKS 15
#include "lib/boundary.glsl"
#include "lib/linear.glsl"
#include "lib/over_or_0.glsl"
#include "lib/painted_cluster.glsl"
#include "lib/peaks.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 4) readonly buffer States { SolverState states[]; };
layout(std430, set = 0, binding = 5) buffer Latest { vec4 latest[]; };  // M₁, then M of this light
layout(std430, set = 0, binding = 6) buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 7) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 8) readonly buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 9) writeonly buffer EnteredBefore { vec4 enteredBefore[]; };
layout(std430, set = 0, binding = 11) buffer BareLights { BareLight bareLights[]; };
layout(std430, set = 0, binding = 12) readonly buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 13) writeonly buffer Nearby { vec4 nearby[]; };

layout(std430, set = 0, binding = 14) buffer EnteredInAll { vec4 enteredInAll[]; };  // of light with that before

layout(push_constant) uniform Push {
  uint clusterCount;
  uint solution;
  uint adds;       // 1: adds to what entered before
  uint isDiffuse;  // 1: diffuse light has entered
  uint atSurface;  // 1: some of it at the surface
  uint scattersOnce;  // 1: some light leaves after its first collision
  uint lights;        // that have entered as well
};

// A cluster that holds both sides of a sheet does not tell on which of them light was mirrored.
float oneSided(Cluster cluster) {
  return smoothstep(0.3, 0.7, length(cluster.vectorArea.xyz) / max(cluster.centroidArea.w, 1e-30));
}

vec3 fluenceOf(uint cluster) {
  vec3 weights[maxSolverSteps];
  vec3 sum = vec3(0.0);
  for (uint k = states[solution].steps; k-- > 0u;) {
    vec3 rest = states[solution].rotated[k].rgb;
    for (uint j = k + 1u; j < states[solution].steps; ++j)
      rest -= states[solution].hessenberg[j * (maxSolverSteps + 1u) + k].rgb * weights[j];
    weights[k] = overOr0(rest, states[solution].hessenberg[k * (maxSolverSteps + 1u) + k].rgb);
    sum += weights[k] * basis[k * clusterCount + cluster].rgb;
  }
  return sum;
}

// From M₁ + x / 2A and sE: the light below the paint, and then what gets through it.
vec3 leavesPaint(uint i, vec3 leaves, vec3 enters, BoundaryMedium medium) {
  ClusterPaint paint = clusterPaints[i];
  vec3 ofEntered = paint.atSurface.rgb / (2.0 * medium.diffusion.w);
  vec3 bare = leaves + ofEntered * enters;
  BareLight before = bareLights[i];
  if (adds == 0u) before = BareLight(vec4(0.0), vec4(0.0));
  bareLights[i] = BareLight(before.exitance + vec4(bare, 0.0), before.entered + vec4(enters, 0.0));
  return leavesLayer(bare, enters, paint.leaving.rgb, paint.deep.rgb, paint.takenOff.rgb, ofEntered);
}

// The irradiance that has entered with this light.
vec3 enteredNow(uint i) {
  vec3 all = isDiffuse != 0u ? entered[i].rgb : vec3(0.0);
  for (uint light = 0u; light < lights; ++light) all += entries[light * clusterCount + i].irradiance.rgb;
  return all;
}

// What would leave a half-space.
vec3 leavesNearby(uint i, vec3 irradiance, BoundaryMedium medium) {
  if (isPaintedCluster(i)) irradiance *= clusterPaints[i].entering.rgb;
  return medium.reflected.rgb * irradiance;
}

// Curved surfaces may gather a lamp's light inside.
const float gathers = 4.0;

// What may leave anywhere at most: what enters where most does. Where a surface that was bent too far lies in itself,
// light would grow without end.
vec3 mostThatLeaves() {
  if (adds != 0u) return mostEntered(peakOfAll);
  vec3 most = isDiffuse != 0u ? mostEntered(peakOfEverywhere) : vec3(0.0);
  for (uint light = 0u; light < lights; ++light) most += gathers * mostEntered(peakOfFirstLight + light);
  return most;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount || ranges[i].kind == opaqueBody) return;
  if (ranges[i].kind == lining) {  // nothing leaves there
    latest[i] = vec4(0.0);
    enteredBefore[i] = vec4(0.0);
    exitances[i] = vec4(0.0);
    enteredInAll[i] = vec4(0.0);
    return;
  }
  BoundaryMedium medium = insideOf(objects[ranges[i].object]);
  vec3 leaves = clusters[i].escape.rgb * fluenceOf(i) / (2.0 * medium.diffusion.w);
  if (scattersOnce != 0u) leaves += latest[i].rgb;
  vec3 enters = vec3(0.0);
  if (atSurface != 0u && ranges[i].kind == bodyWithInside)
    enters = shareAtSurface(clusters[i].start.w, medium) * entered[i].rgb;
  if (isPaintedCluster(i))
    leaves = leavesPaint(i, leaves, enters, medium);
  else
    leaves += enters;
  leaves = max(leaves, vec3(0.0));
  vec3 before = adds != 0u ? exitances[i].rgb : vec3(0.0);
  leaves = min(leaves, max(mostThatLeaves() - before, vec3(0.0)));
  latest[i] = vec4(leaves, 0.0);
  vec3 all = enteredNow(i) + (adds != 0u ? enteredInAll[i].rgb : vec3(0.0));
  enteredInAll[i] = vec4(all, 0.0);
  nearby[i] = vec4(leavesNearby(i, all, medium), 1.0 / max(clusters[i].start.w, 1e-6));
  enteredBefore[i] = isDiffuse != 0u ? oneSided(clusters[i]) * entered[i] : vec4(0.0);
  exitances[i] = vec4(before + leaves, 0.0);
}

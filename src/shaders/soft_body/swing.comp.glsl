// A soft body's cage in time: XPBD with small steps of one iteration (Macklin et al. 2019). It goes
// cell after cell, those of one colour at once. One group does all substeps.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/soft_cell.glsl"
#include "shared/soft_body.h"

layout(local_size_x = softGroupSize) in;

layout(std430, set = 0, binding = 0) readonly buffer Cells { uint corners[]; };  // eight per cell
layout(std430, set = 0, binding = 1) readonly buffer Nodes { SoftNode nodes[]; };
layout(std430, set = 0, binding = 2) buffer Motions { SoftMotion motions[]; };
layout(std430, set = 0, binding = 3) buffer Turns { vec4 turns[]; };  // quaternions
layout(std430, set = 0, binding = 4) buffer Grips { vec4 grips[]; };  // shift when taken; how firmly
layout(std430, set = 0, binding = 5) buffer Reports { SoftReport report; };

layout(push_constant) uniform Push { SoftStep now; };

shared float places[3u * maxSoftNodes];  // shifts, on their way through a substep
shared uint largestStep2;
shared uint largestShift2;

vec3 placeOf(uint n) {
  return vec3(places[3u * n], places[3u * n + 1u], places[3u * n + 2u]);
}

void setPlace(uint n, vec3 place) {
  places[3u * n] = place.x;
  places[3u * n + 1u] = place.y;
  places[3u * n + 2u] = place.z;
}

vec3 shiftOf(uint n) {
  return vec3(motions[n].shiftX, motions[n].shiftY, motions[n].shiftZ);
}

void setShift(uint n, vec3 shift) {
  motions[n].shiftX = shift.x;
  motions[n].shiftY = shift.y;
  motions[n].shiftZ = shift.z;
}

// Takes hold of a node near the place, more firmly the nearer it is.
void takeHold(uint n) {
  SoftNode node = nodes[n];
  vec3 shift = shiftOf(n);
  vec3 away = (vec3(node.x, node.y, node.z) + shift - now.grab.xyz) * now.grab.w;
  float near = node.held != 0u ? 0.0 : max(1.0 - dot(away, away), 0.0);
  grips[n] = vec4(shift, near * near);
}

// Where a held node is asked to be, never farther from its rest than the reach.
vec3 wanted(vec4 grip, vec3 hold) {
  vec3 shift = grip.xyz + hold;
  return shift / sqrt(1.0 + dot(shift, shift) / (now.reach * now.reach));
}

void relax(uint c) {
  vec3 x[8];
  float lightness[8];
  for (uint i = 0u; i < 8u; ++i) {
    uint corner = corners[8u * c + i];
    uint mass = corner >> softMassShift;
    lightness[i] = mass == 0u ? 0.0 : 1.0 / float(mass);
    x[i] = placeOf(corner & ((1u << softMassShift) - 1u));
  }
  vec4 turn = turns[c];
  relaxCell(x, lightness, turn, now.shear, now.compliance);
  turns[c] = turn;
  for (uint i = 0u; i < 8u; ++i) setPlace(corners[8u * c + i] & ((1u << softMassShift) - 1u), x[i]);
}

// The end of a substep, and the way to the next without forces.
void advance(uint n, vec3 hold, float anchor) {
  vec3 place = placeOf(n);
  vec3 shift = place - anchor * place;
  float kept = now.damping;
  if (now.holds != 0u) {
    vec4 grip = grips[n];
    if (grip.w > 0.0) shift += now.grip * grip.w * (wanted(grip, hold) - place);
    kept *= 1.0 - min(2.0 * sqrt(now.grip), 1.0) * grip.w;  // a hold does not swing by itself
  }
  setPlace(n, shift + kept * (shift - shiftOf(n)));
  setShift(n, shift);
}

// Ends the swing where nobody would see it go on, so that it ends at all. Also notices when the body
// has come to stand in another shape than its own, as one that was pushed through itself may.
void settle(uint lane, vec3 hold, float strayed) {
  for (uint n = lane; n < now.nodeCount; n += softGroupSize) {
    vec3 shift = shiftOf(n);
    vec3 went = placeOf(n) - shift;
    atomicMax(largestStep2, floatBitsToUint(dot(went, went)));  // not negative: ordered like floats
    atomicMax(largestShift2, floatBitsToUint(dot(shift, shift)));
  }
  // Below, other invocations than those that turned cells put them back.
  memoryBarrierBuffer();
  barrier();
  bool slow = uintBitsToFloat(largestStep2) < now.stillStep * now.stillStep;
  bool stray = slow && uintBitsToFloat(largestShift2) > now.strayShift * now.strayShift;
  if (stray || strayed > now.strayFrom) strayed += float(now.substeps);
  bool still = slow;
  if (now.holds != 0u) {
    still = still && distance(hold, now.goal.xyz) < now.stillShift;
  } else {
    still = still && uintBitsToFloat(largestShift2) < now.stillShift * now.stillShift;
    if (still) {
      for (uint n = lane; n < now.nodeCount; n += softGroupSize) {
        setPlace(n, vec3(0.0));
        setShift(n, vec3(0.0));
      }
      for (uint c = lane; c < now.firstOfColour[softColours]; c += softGroupSize)
        turns[c] = vec4(0.0, 0.0, 0.0, 1.0);
    }
  }
  if (now.holds != 0u || still) strayed = 0.0;
  if (lane == 0u)
    report = SoftReport(hold.x, hold.y, hold.z, still ? 1u : 0u, strayed, float[3](0.0, 0.0, 0.0));
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  vec3 hold = vec3(report.holdX, report.holdY, report.holdZ);
  float strayed = now.holds != 0u ? 0.0 : report.strayed;
  float anchor = now.anchor + now.homeMost * clamp((strayed - now.strayFrom) * now.homePerSubstep, 0.0, 1.0);
  largestStep2 = 0u;
  largestShift2 = 0u;
  for (uint n = lane; n < now.nodeCount; n += softGroupSize)
    setPlace(n, vec3(motions[n].aheadX, motions[n].aheadY, motions[n].aheadZ));
  if (now.grab.w > 0.0) {
    hold = vec3(0.0);
    for (uint n = lane; n < now.nodeCount; n += softGroupSize) takeHold(n);
  }
  barrier();
  // Loops test at their end, because a software device runs the rest of a loop that has been left
  // once more, to no effect.
  uint substep = 0u;
  do {
    uint colour = 0u;
    do {
      uint first = now.firstOfColour[colour];
      uint end = now.firstOfColour[colour + 1u];
      do {
        if (first + lane < end) relax(first + lane);
        first += softGroupSize;
      } while (first < end);
      barrier();
    } while (++colour < softColours);
    hold += now.goal.w * (now.goal.xyz - hold);
    uint node = lane;
    do {
      if (node < now.nodeCount) advance(node, hold, anchor);
      node += softGroupSize;
    } while (node - lane < now.nodeCount);
    barrier();
  } while (++substep < now.substeps);
  settle(lane, hold, strayed);
  for (uint n = lane; n < now.nodeCount; n += softGroupSize) {
    vec3 ahead = placeOf(n);
    motions[n].aheadX = ahead.x;
    motions[n].aheadY = ahead.y;
    motions[n].aheadZ = ahead.z;
  }
}

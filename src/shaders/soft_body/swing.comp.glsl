// A soft body's cage in time: XPBD with small steps of one iteration (Macklin et al. 2019). All cells
// are solved at once, each with its own share of its corners' masses, and a corner goes where its
// shares go on the mean (Tonge et al. 2012). One group does all substeps.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/soft_cell.glsl"
#include "shared/soft_body.h"

layout(local_size_x = softGroupSize) in;

layout(std430, set = 0, binding = 0) readonly buffer Cells { uint corners[]; };  // eight a cell
layout(std430, set = 0, binding = 1) readonly buffer Nodes { SoftNode nodes[]; };
layout(std430, set = 0, binding = 2) buffer Motions { SoftMotion motions[]; };
layout(std430, set = 0, binding = 3) buffer Turns { vec4 turns[]; };  // quaternions
layout(std430, set = 0, binding = 4) buffer Grips { vec4 grips[]; };  // shift when taken; share
layout(std430, set = 0, binding = 5) coherent buffer Moves { float moves[]; };  // by slot
layout(std430, set = 0, binding = 6) buffer Reports { SoftReport report; };

layout(push_constant) uniform Push { SoftStep step_; };

shared float shifts[3u * maxSoftNodes];
shared uint largestStep2;
shared uint largestShift2;

vec3 shiftOf(uint n) {
  return vec3(shifts[3u * n], shifts[3u * n + 1u], shifts[3u * n + 2u]);
}

void setShift(uint n, vec3 shift) {
  shifts[3u * n] = shift.x;
  shifts[3u * n + 1u] = shift.y;
  shifts[3u * n + 2u] = shift.z;
}

vec3 lastStep(uint n) {
  return vec3(motions[n].stepX, motions[n].stepY, motions[n].stepZ);
}

void setLastStep(uint n, vec3 went) {
  motions[n].stepX = went.x;
  motions[n].stepY = went.y;
  motions[n].stepZ = went.z;
}

// What lies near the place, more the nearer it is.
void takeHold(uint n) {
  vec3 shift = shiftOf(n);
  vec3 away = (vec3(nodes[n].x, nodes[n].y, nodes[n].z) + shift - step_.grab.xyz) * step_.grab.w;
  float near = max(1.0 - dot(away, away), 0.0);
  grips[n] = vec4(shift, near * near);
}

// Where a held node is asked to be; never farther than the reach.
vec3 wanted(vec4 grip, vec3 hold) {
  vec3 shift = grip.xyz + hold;
  return shift / sqrt(1.0 + dot(shift, shift) / (step_.reach * step_.reach));
}

void relax(uint c) {
  vec3 x[8];
  for (uint i = 0u; i < 8u; ++i) x[i] = shiftOf(corners[8u * c + i]);
  vec4 turn = turns[c];
  relaxCell(x, turn, step_.shear, step_.compliance);
  turns[c] = turn;
  for (uint i = 0u; i < 8u; ++i) {
    uint slot = 3u * (8u * c + i);
    moves[slot] = x[i].x;
    moves[slot + 1u] = x[i].y;
    moves[slot + 2u] = x[i].z;
  }
}

void move(uint n, vec3 hold) {
  float share = nodes[n].share;
  if (share == 0.0) return;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < 8u; ++i) {
    uint slot = nodes[n].slots[i];
    if (slot == noSoftSlot) break;
    sum += vec3(moves[3u * slot], moves[3u * slot + 1u], moves[3u * slot + 2u]);
  }
  vec3 shift = shiftOf(n);
  vec3 moved = share * sum - step_.anchor * shift;
  if (step_.holds != 0u) {
    vec4 grip = grips[n];
    if (grip.w > 0.0) moved += step_.grip * grip.w * (wanted(grip, hold) - shift);
  }
  setLastStep(n, step_.damping * lastStep(n) + moved);
  setShift(n, shift + moved);
}

// Ends the swing where nobody would see it go on, so that it ends at all.
void settle(uint lane, vec3 hold) {
  for (uint n = lane; n < step_.nodeCount; n += softGroupSize) {
    vec3 went = lastStep(n);
    vec3 shift = shiftOf(n);
    atomicMax(largestStep2, floatBitsToUint(dot(went, went)));  // not negative: ordered like floats
    atomicMax(largestShift2, floatBitsToUint(dot(shift, shift)));
  }
  barrier();
  bool still = uintBitsToFloat(largestStep2) < step_.stillStep * step_.stillStep;
  if (step_.holds != 0u) {
    still = still && distance(hold, step_.goal.xyz) < step_.stillShift;
  } else {
    still = still && uintBitsToFloat(largestShift2) < step_.stillShift * step_.stillShift;
    if (still) {
      for (uint n = lane; n < step_.nodeCount; n += softGroupSize) {
        setShift(n, vec3(0.0));
        setLastStep(n, vec3(0.0));
      }
      for (uint c = lane; c < step_.cellCount; c += softGroupSize) turns[c] = vec4(0.0, 0.0, 0.0, 1.0);
    }
  }
  if (lane == 0u) report = SoftReport(hold.x, hold.y, hold.z, still ? 1u : 0u);
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  vec3 hold = vec3(report.holdX, report.holdY, report.holdZ);
  largestStep2 = 0u;
  largestShift2 = 0u;
  for (uint n = lane; n < step_.nodeCount; n += softGroupSize)
    setShift(n, vec3(motions[n].shiftX, motions[n].shiftY, motions[n].shiftZ));
  if (step_.grab.w > 0.0) {
    hold = vec3(0.0);
    for (uint n = lane; n < step_.nodeCount; n += softGroupSize) takeHold(n);
  }
  for (uint substep = 0u; substep < step_.substeps; ++substep) {
    for (uint n = lane; n < step_.nodeCount; n += softGroupSize)
      setShift(n, shiftOf(n) + step_.damping * lastStep(n));
    barrier();
    for (uint c = lane; c < step_.cellCount; c += softGroupSize) relax(c);
    groupMemoryBarrier();
    barrier();
    hold += step_.goal.w * (step_.goal.xyz - hold);
    for (uint n = lane; n < step_.nodeCount; n += softGroupSize) move(n, hold);
  }
  barrier();
  settle(lane, hold);
  for (uint n = lane; n < step_.nodeCount; n += softGroupSize) {
    vec3 shift = shiftOf(n);
    motions[n].shiftX = shift.x;
    motions[n].shiftY = shift.y;
    motions[n].shiftZ = shift.z;
  }
}

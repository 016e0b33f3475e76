// What the shaders of boundary transport share. Needs, before it, BINDING_OBJECTS and BINDING_MEDIA.
#ifndef OPALINE_LIB_BOUNDARY
#define OPALINE_LIB_BOUNDARY
#include "lib/lesser.glsl"
#include "lib/material.glsl"
#include "lib/pi.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"

// Whether a node may stand for what is below it: from further than its radius over the opening
// angle. Where light falls off within the node, the radius is felt to be larger. Twice is enough,
// because no light comes from further away.
bool isFar(float squaredMm2, float radius, float sigmaPerMm, float openingAngle) {
  float felt = radius * clamp(sigmaPerMm * radius, 1.0, 2.0);
  return squaredMm2 * (openingAngle * openingAngle) > felt * felt;
}

// Places nearer to each other than this are one, so that the inverse cube of their distance is not too large a number.
const float leastSquaredMm2 = 1e-18;

// A cluster taken as a disc fills less of the solid angle than its area over the squared distance.
// This is the factor between the two, on the disc's axis.
float coverageOfDisc(float squaredMm2, float areaMm2) {
  float x2 = min(squaredMm2 * pi / max(areaMm2, 1e-30), 1e12);
  // 2x² (1 - x/√(1+x²)) without its cancellation.
  float root = sqrt(1.0 + x2);
  return 2.0 * x2 / (root * (root + sqrt(x2)));
}

// What is added to the squared distance between two clusters to make 1 over the distance a mean
// over both, mm². That mean is 2/ρ in the middle of a disc, and 16/3πρ over a disc that lies on
// another of its size.
float smoothingOf(float areaMm2, float areaOfOtherMm2) {
  return (0.25 * max(areaMm2, areaOfOtherMm2) + 0.097 * min(areaMm2, areaOfOtherMm2)) / pi;
}

// Distance from a cluster's surface at which rays start, mm.
float rayStartOf(Cluster cluster) {
  return 1e-4 * cluster.normal.w;
}

// Weight of the single layer in the equation, 1 / 2AD.
vec3 singleLayerWeight(BoundaryMedium medium) {
  return 1.0 / (2.0 * medium.diffusion.w * medium.diffusion.rgb);
}

// For each channel of a medium: 0 where all light is followed to its second collision, 1 where
// diffusion takes over from the first.
vec3 whitenessOf(BoundaryMedium medium) {
  return smoothstep(albedoFollowed, albedoNotFollowed, medium.albedo.rgb);
}

// Two clusters as discs that light goes between.
struct Discs {
  float smoothing;     // added to their squared distance, mm²
  float spread;        // a quarter of the mean square by which places on them are aside, mm²
  vec3 whereAbsorbed;  // for each channel, how much of the mean over discs is wanted
  float narrowness;    // how much of that; less where they are wide for their part of the body
  vec3 whereWide;      // what takes its place there, as a factor
};

Discs discsBetween(float areaMm2, float areaOfOtherMm2, BoundaryMedium medium) {
  return Discs(smoothingOf(areaMm2, areaOfOtherMm2), (areaMm2 + areaOfOtherMm2) / (8.0 * pi), 1.0 - whitenessOf(medium),
               1.0, vec3(1.0));
}

// What all clusters of that area on a plane at that depth, mm, lack together because distances are smoothed, as a factor.
vec3 lackOfPlane(float areaMm2, float depth, vec3 sigma, BoundaryMedium medium) {
  float smoothing = smoothingOf(areaMm2, areaMm2);
  float shorter = smoothing / max(sqrt(depth * depth + smoothing) + depth, 1e-30);
  return exp((1.0 - whitenessOf(medium)) * sigma * shorter);
}

// e^{-σr}/r as a mean over both discs, to second order in how far places on them are aside: K + q(∇² - ∂²/∂z²)K with
// the spread q, made up for the smoothing. `depth` is how far apart they are along the normal. Instead of σ²qK it has
// more near by, because what a cluster has falls off across it. All clusters of a plane together then get 2πe^{-σz}/σ
// within 5 % if their edge is 1/σ, and within 11 % if it is 1.5/σ; by smoothed distances alone they lack up to 27 and
// 39 %.
vec3 kernelBetween(Discs discs, vec3 sigma, vec3 squared, vec3 depth) {
  squared += discs.smoothing;
  vec3 over = inversesqrt(squared);
  vec3 over2 = over * over;
  vec3 x = sigma * (squared * over);
  vec3 across = (0.5 * discs.smoothing + discs.spread) * (1.0 + 1.6 * x);
  vec3 along = discs.spread * (depth * depth + 0.565 * discs.smoothing) * over2 * (3.0 + x * (3.0 + x));
  vec3 mean = max(1.0 + discs.whereAbsorbed * (across - along) * over2, 0.2);
  return exp(-x) * over * mix(discs.whereWide, mean, discs.narrowness);
}

// Of diffuse light that enters through a cluster, the share that enters the diffusion at the surface itself: all
// of it where the body is white and thicker than some mean free paths. The rest is followed to its collisions.
vec3 shareAtSurface(float thicknessMm, BoundaryMedium medium) {
  return smoothstep(2.0, 5.0, thicknessMm * medium.extinction.rgb) * whitenessOf(medium);
}

// The fluence there at which as much leaves as has entered: 2Aκ times the irradiance that entered, and
// 2Aκ is 4 / (1 - 2C₁) with 1 - 2C₁ = F̄_t/η².
vec3 fluenceAtSurface(vec3 entered, float thicknessMm, BoundaryMedium medium) {
  float overIrradiance = 4.0 / (medium.extinction.w * (1.0 - medium.albedo.w * medium.albedo.w));
  return overIrradiance * shareAtSurface(thicknessMm, medium) * entered;
}

// Of the light that entered through a cluster, the share that becomes sources of fluence at its first collisions.
vec3 shareOfFirst(Cluster cluster) {
  return 1.0 - cluster.second.rgb;
}

// (1 - e^{-σ l}) / σ, also for σ = 0.
vec3 absorbedLength(vec3 sigma, vec3 lengthMm) {
  vec3 x = sigma * lengthMm;
  vec3 series = lengthMm * (1.0 - x * (0.5 - x / 6.0));
  return mix((1.0 - exp(-x)) / max(sigma, vec3(1e-20)), series, lessThan(x, vec3(0.02)));
}

#endif

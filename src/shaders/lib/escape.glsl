// How much more easily light leaves a body in some place than A of a plane says. A is divided by this there.
#ifndef OPALINE_LIB_ESCAPE
#define OPALINE_LIB_ESCAPE
#include "lib/boundary.glsl"

// Near the surface of what absorbs, diffusion has too much light, whether it begins with the first or the second
// collision. How much is known from what leaves a half-space: within 1 % the same for light from 0 and from 60°, for
// albedos down to 0.65 and η up to 1.5. It is more where light scatters forwards: half-spaces of skin1 are then within
// 1 % for g = 0.5 and 4 % for 0.9.
vec3 excessOfDiffusion(BoundaryMedium medium) {
  vec3 dark = 1.0 - medium.albedo.rgb;
  float a = medium.diffusion.w;
  return (1.0 - 0.47 / (a * a)) * dark / (1.0 + 3.6 * dark) + 2.7 * max(medium.collision.w, 0.0) * dark * dark;
}

// For each channel: 0 where clusters are small enough for light to be followed to second collisions, 1 where diffusion
// starts at the first. Light that leaves after one collision does so within such a cluster.
vec3 coarsenessOf(BoundaryMedium medium, float edgeMm) {
  return smoothstep(1.5, 3.0, edgeMm * medium.extinction.rgb);
}

// On a plane, the part 1 / (1 + 2ADσ) of what comes to the surface leaves, from whatever depth it comes. This factor
// of 1/A lessens that part by the excess.
vec3 escapeOfPlane(BoundaryMedium medium) {
  vec3 inwards = 2.0 * medium.diffusion.w * medium.diffusion.rgb * medium.sigma.rgb;
  vec3 withExcess = inwards + excessOfDiffusion(medium) * (1.0 + inwards);
  return mix(inwards / max(withExcess, vec3(1e-20)), vec3(1.0), whitenessOf(medium));
}

// Where the surface is convex, light on its way out spreads and goes more nearly along the normal, and less of it
// is mirrored back. Monte Carlo in balls and around hollows gives between nothing and twice this, for light that
// starts near the surface and for light from everywhere.
vec3 escapeByCurvature(BoundaryMedium medium, float curvature) {
  vec3 bend = 2.0 * medium.diffusion.rgb * curvature / medium.diffusion.w;
  return 1.0 + 0.5 * bend / (1.0 + 3.0 * abs(bend));
}

// In thin parts much light goes along the part, mirrored back and forth, as far as both sides are parallel. In slabs
// as thin as a sixth of a free path, what leaves on either side is then within 5 % of Monte Carlo, for albedos down
// to 0.65.
vec3 escapeByThickness(BoundaryMedium medium, float thicknessMm, float parallel) {
  const float thinnest = 0.2;  // free paths
  return 1.0 - parallel * exp(-1.3 * max(thicknessMm * medium.extinction.rgb, thinnest));
}

// `ofThickness` is the last factor, over the cluster.
vec3 escapeOf(BoundaryMedium medium, float curvature, vec3 ofThickness) {
  return escapeOfPlane(medium) * escapeByCurvature(medium, curvature) * ofThickness;
}

#endif

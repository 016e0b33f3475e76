// The procedural deformers of opaline/motion.h. Normals go through the cofactors of the Jacobian.
#ifndef OPALINE_LIB_DEFORMERS
#define OPALINE_LIB_DEFORMERS
#include "shared/deform.h"

const float twoPi = 6.28318530717958647692;

struct Posed {
  vec3 position;
  vec3 normal;  // of any length
};

// Columns of the Jacobian.
struct Jacobian {
  vec3 x;
  vec3 y;
  vec3 z;
};

vec3 throughCofactors(Jacobian j, vec3 n) {
  return n.x * cross(j.y, j.z) + n.y * cross(j.z, j.x) + n.z * cross(j.x, j.y);
}

float sinc(float x) {
  return abs(x) < 1e-2 ? 1.0 - x * x * (1.0 / 6.0) : sin(x) / x;
}

Posed twist(Posed p, DeformerData d) {
  float rate = d.amount.x / d.box.w;
  float angle = rate * (p.position.y - d.box.y) - 0.5 * d.amount.x;
  float c = cos(angle);
  float s = sin(angle);
  vec2 from = p.position.xz - d.box.xz;
  vec2 to = vec2(c * from.x + s * from.y, c * from.y - s * from.x);
  Jacobian j = Jacobian(vec3(c, 0.0, -s), vec3(rate * to.y, 1.0, -rate * to.x), vec3(s, 0.0, c));
  return Posed(vec3(d.box.x + to.x, p.position.y, d.box.z + to.y), throughCofactors(j, p.normal));
}

Posed bend(Posed p, DeformerData d) {
  float curvature = d.amount.x / d.box.w;
  float along = p.position.y - d.box.y;
  float angle = curvature * along;
  float halved = sinc(0.5 * angle);
  float c = cos(angle);
  float s = sin(angle);
  float from = p.position.x - d.box.x;
  vec3 to = vec3(d.box.x + along * (0.5 * angle * halved * halved) + from * c,
                 d.box.y + along * sinc(angle) - from * s, p.position.z);
  float stretch = 1.0 - curvature * from;
  Jacobian j = Jacobian(vec3(c, -s, 0.0), stretch * vec3(s, c, 0.0), vec3(0.0, 0.0, 1.0));
  return Posed(to, throughCofactors(j, p.normal));
}

Posed squash(Posed p, DeformerData d) {
  float tall = max(1.0 - d.amount.x, 0.1);
  float wide = inversesqrt(tall);
  vec3 fixedPoint = d.box.xyz;
  vec3 scale = vec3(wide, tall, wide);
  // Exactly the place at rest where nothing is squashed.
  return Posed(p.position + (scale - 1.0) * (p.position - fixedPoint), p.normal / scale);
}

Posed wobble(Posed p, DeformerData d) {
  float size = d.amount.x * d.amount.z;
  float h = (p.position.y - d.box.y) / d.box.w;
  float inside = clamp(h, 0.0, 1.0);
  float strength = inside * inside * (3.0 - 2.0 * inside);
  float slope = 6.0 * inside * (1.0 - inside) / d.box.w;
  float phase = twoPi * (h - d.amount.y);
  float turn = twoPi / d.box.w;
  float c = cos(phase);
  float s = sin(phase);
  vec3 to = p.position + size * strength * vec3(s, 0.0, 0.5 * c);
  Jacobian j = Jacobian(vec3(1.0, 0.0, 0.0),
                        vec3(size * (slope * s + strength * turn * c), 1.0,
                             0.5 * size * (slope * c - strength * turn * s)),
                        vec3(0.0, 0.0, 1.0));
  return Posed(to, throughCofactors(j, p.normal));
}

Posed deformed(Posed p, DeformerData d) {
  switch (d.kind.x) {
    case 0u:
      return twist(p, d);
    case 1u:
      return bend(p, d);
    case 2u:
      return squash(p, d);
    default:
      return wobble(p, d);
  }
}

#endif

// One cell of a soft body's cage: a cube whose inside follows its corners trilinearly,
//   x(ξ, η, ζ) = Σ_m c_m ξ^m₀ η^m₁ ζ^m₂, ξ, η, ζ in [-1, 1], m's bits the exponents.
// The coefficients c_m are sums and differences of corners. Lengths are in cells, masses in eighths of
// a cell's.
#ifndef OPALINE_LIB_SOFT_CELL
#define OPALINE_LIB_SOFT_CELL

// Mean and half of the difference.
void split(inout vec3 low, inout vec3 high) {
  vec3 mean = 0.5 * (low + high);
  high = 0.5 * (high - low);
  low = mean;
}

void join(inout vec3 mean, inout vec3 halfWay) {
  vec3 high = mean + halfWay;
  mean -= halfWay;
  halfWay = high;
}

// Corners to coefficients, axis by axis. Written out, because not every compiler unrolls a loop over
// bits, and arrays that are indexed by a variable are slow.
void toModes(inout vec3 x[8]) {
  split(x[0], x[1]);
  split(x[2], x[3]);
  split(x[4], x[5]);
  split(x[6], x[7]);
  split(x[0], x[2]);
  split(x[1], x[3]);
  split(x[4], x[6]);
  split(x[5], x[7]);
  split(x[0], x[4]);
  split(x[1], x[5]);
  split(x[2], x[6]);
  split(x[3], x[7]);
}

void toCorners(inout vec3 x[8]) {
  join(x[0], x[1]);
  join(x[2], x[3]);
  join(x[4], x[5]);
  join(x[6], x[7]);
  join(x[0], x[2]);
  join(x[1], x[3]);
  join(x[4], x[6]);
  join(x[5], x[7]);
  join(x[0], x[4]);
  join(x[1], x[5]);
  join(x[2], x[6]);
  join(x[3], x[7]);
}

// The columns of the rotation of a unit quaternion, less those of the identity.
mat3 turnLessIdentity(vec4 q) {
  vec3 d = q.xyz * q.xyz;
  return 2.0 * mat3(vec3(-d.y - d.z, q.x * q.y + q.w * q.z, q.x * q.z - q.w * q.y),
                    vec3(q.x * q.y - q.w * q.z, -d.x - d.z, q.y * q.z + q.w * q.x),
                    vec3(q.x * q.z + q.w * q.y, q.y * q.z - q.w * q.x, -d.x - d.y));
}

// A rotation nearer to that in F = 1 + f, from one that is near: a Newton step for the largest tr RᵀF or,
// where that does not lead there, the shorter step of Müller et al. 2016, Eq. 7. It is never a reflection,
// so that a cell that was turned inside out recovers. A rotation that lags behind would brake every turn.
vec4 nearerTurn(vec4 q, mat3 f) {
  mat3 r = turnLessIdentity(q);
  mat3 turn = r + mat3(1.0);
  mat3 map = f + mat3(1.0);
  vec3 axis = cross(turn[0], map[0]) + cross(turn[1], map[1]) + cross(turn[2], map[2]);
  float size = dot(turn[0], map[0]) + dot(turn[1], map[1]) + dot(turn[2], map[2]);
  mat3 stretch = transpose(turn) * map;
  mat3 slope = mat3(size) - 0.5 * (stretch + transpose(stretch));
  float volume = determinant(slope);
  bool upwards = size > 0.0 && volume > 0.02 * size * size * size;
  vec3 way = upwards ? turn * (inverse(slope) * (axis * turn)) : axis / (abs(size) + 1e-6);
  vec3 h = 0.5 * way;
  return normalize(vec4(q.xyz + q.w * h + cross(h, q.xyz), q.w - dot(h, q.xyz)));
}

float triple(vec3 a, vec3 b, vec3 c) {
  return dot(a, cross(b, c));
}

// How the volume, C = V / V₀ - 1, changes with the coefficients; returns C. V is the integral of det F
// over the cell.
float volumeAndGradient(vec3 c[8], out vec3 gradient[8]) {
  vec3 x = c[1] + vec3(0.5, 0.0, 0.0);
  vec3 y = c[2] + vec3(0.0, 0.5, 0.0);
  vec3 z = c[4] + vec3(0.0, 0.0, 0.5);
  const float third = 1.0 / 3.0;
  gradient[0] = vec3(0.0);
  gradient[1] = 8.0 * (cross(y, z) + third * cross(c[3], c[5]));
  gradient[2] = 8.0 * (cross(z, x) + third * cross(c[6], c[3]));
  gradient[3] = 8.0 * third * (cross(y, c[6]) + cross(c[5], x));
  gradient[4] = 8.0 * (cross(x, y) + third * cross(c[5], c[6]));
  gradient[5] = 8.0 * third * (cross(c[6], z) + cross(x, c[3]));
  gradient[6] = 8.0 * third * (cross(c[3], y) + cross(z, c[5]));
  gradient[7] = vec3(0.0);
  return 8.0 * (triple(x, y, z) +
                third * (triple(c[3], y, c[6]) + triple(c[5], c[6], z) + triple(x, c[3], c[5]))) -
         1.0;
}

// How a cell's shear moves its coefficients. Its energy is μ ∫ |F - R|² dV with R the rotation of the
// mean of F: 4 μ a · |c_m - rest|² · (1, 2/3, 1/3) for one, two and three exponents.
void shearBack(vec3 c[8], vec4 turn, float shear, out vec3 moved[8]) {
  mat3 rest = 0.5 * turnLessIdentity(turn);
  moved[0] = vec3(0.0);
  moved[1] = -shear * (c[1] - rest[0]);
  moved[2] = -shear * (c[2] - rest[1]);
  moved[3] = -shear * (2.0 / 3.0) * c[3];
  moved[4] = -shear * (c[4] - rest[2]);
  moved[5] = -shear * (2.0 / 3.0) * c[5];
  moved[6] = -shear * (2.0 / 3.0) * c[6];
  moved[7] = -shear * (1.0 / 3.0) * c[7];
}

// How a cell's corners, shifted by `x` from rest, are moved by its shear and its volume; follows its
// rotation. `lightness` is a corner's inverse mass. This is the step of one constraint whose multiplier
// starts at 0: Macklin et al. 2016, Eq. 18.
void relaxCell(inout vec3 x[8], float lightness[8], inout vec4 turn, float shear, float compliance) {
  vec3 c[8] = x;
  toModes(c);
  mat3 f = 2.0 * mat3(c[1], c[2], c[4]);
  turn = nearerTurn(nearerTurn(turn, f), f);
  vec3 moved[8];
  shearBack(c, turn, shear, moved);
  toCorners(moved);
  vec3 gradient[8];
  float excess = volumeAndGradient(c, gradient);
  toCorners(gradient);
  float square = 0.0;
  for (uint i = 0u; i < 8u; ++i) square += 0.125 * lightness[i] * dot(gradient[i], gradient[i]);
  float multiplier = excess / (square + compliance);
  for (uint i = 0u; i < 8u; ++i) x[i] += lightness[i] * (moved[i] - multiplier * gradient[i]);
}

#endif

// One cell of a soft body's cage: a cube whose inside follows its corners trilinearly,
//   x(ξ, η, ζ) = Σ_m c_m ξ^m₀ η^m₁ ζ^m₂, ξ, η, ζ in [-1, 1], m's bits the exponents.
// The coefficients c_m are sums and differences of corners, and with a mass at each corner alike they
// move apart from each other: every one of them is a constraint that is solved by itself.
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

// Nearer to the rotation in F = 1 + f, from one that is near (Müller et al. 2016, Eq. 7); never a
// reflection, so that a cell that was turned inside out finds back.
vec4 nearerTurn(vec4 q, mat3 f) {
  mat3 r = turnLessIdentity(q);
  mat3 turn = r + mat3(1.0);
  mat3 map = f + mat3(1.0);
  vec3 axis = cross(turn[0], map[0]) + cross(turn[1], map[1]) + cross(turn[2], map[2]);
  float size = dot(turn[0], map[0]) + dot(turn[1], map[1]) + dot(turn[2], map[2]);
  vec3 h = axis * (0.5 / (abs(size) + 1e-6));
  return normalize(vec4(q.xyz + q.w * h + cross(h, q.xyz), q.w - dot(h, q.xyz)));
}

float triple(vec3 a, vec3 b, vec3 c) {
  return dot(a, cross(b, c));
}

// Adds the correction of the volume, C = V / V₀ - 1, to `moved`. V is the integral of det F over the
// cell. XPBD's step of one constraint: Macklin et al. 2016, Eq. 18, with the multiplier from 0.
void keepVolume(vec3 c[8], float compliance, inout vec3 moved[8]) {
  vec3 x = c[1] + vec3(0.5, 0.0, 0.0);
  vec3 y = c[2] + vec3(0.0, 0.5, 0.0);
  vec3 z = c[4] + vec3(0.0, 0.0, 0.5);
  float third = 1.0 / 3.0;
  float volume =
      8.0 * (triple(x, y, z) + third * (triple(c[3], y, c[6]) + triple(c[5], c[6], z) + triple(x, c[3], c[5])));
  vec3 gradientX = 8.0 * (cross(y, z) + third * cross(c[3], c[5]));
  vec3 gradientY = 8.0 * (cross(z, x) + third * cross(c[6], c[3]));
  vec3 gradientZ = 8.0 * (cross(x, y) + third * cross(c[5], c[6]));
  vec3 gradientXy = 8.0 * third * (cross(y, c[6]) + cross(c[5], x));
  vec3 gradientYz = 8.0 * third * (cross(c[3], y) + cross(z, c[5]));
  vec3 gradientZx = 8.0 * third * (cross(c[6], z) + cross(x, c[3]));
  float square = dot(gradientX, gradientX) + dot(gradientY, gradientY) + dot(gradientZ, gradientZ) +
                 dot(gradientXy, gradientXy) + dot(gradientYz, gradientYz) + dot(gradientZx, gradientZx);
  float multiplier = (1.0 - volume) / (square + compliance);
  moved[1] += multiplier * gradientX;
  moved[2] += multiplier * gradientY;
  moved[4] += multiplier * gradientZ;
  moved[3] += multiplier * gradientXy;
  moved[6] += multiplier * gradientYz;
  moved[5] += multiplier * gradientZx;
}

// How a cell's corners, shifted by `x` from rest, are moved by its shear and volume; follows its
// rotation. The energy of shear is μ ∫ |F - R|² dV with R the rotation of the mean of F, which over
// the coefficients is 4 μ a · |c_m - rest|² · (1, 2/3, 1/3) for one, two and three exponents.
void relaxCell(inout vec3 x[8], inout vec4 turn, float shear, float compliance) {
  toModes(x);
  mat3 f = 2.0 * mat3(x[1], x[2], x[4]);
  turn = nearerTurn(nearerTurn(turn, f), f);
  mat3 rest = 0.5 * turnLessIdentity(turn);
  vec3 moved[8];
  moved[0] = vec3(0.0);
  moved[1] = -shear * (x[1] - rest[0]);
  moved[2] = -shear * (x[2] - rest[1]);
  moved[4] = -shear * (x[4] - rest[2]);
  moved[3] = -shear * (2.0 / 3.0) * x[3];
  moved[5] = -shear * (2.0 / 3.0) * x[5];
  moved[6] = -shear * (2.0 / 3.0) * x[6];
  moved[7] = -shear * (1.0 / 3.0) * x[7];
  keepVolume(x, compliance, moved);
  toCorners(moved);
  x = moved;
}

#endif

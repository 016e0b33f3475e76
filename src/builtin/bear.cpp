#include <algorithm>
#include <array>
#include <cmath>

#include "builtin/builtin.h"
#include "builtin/surface_net.h"

namespace opaline::builtin {
namespace {

// A bear about two units tall: x to its left, y up, z to the front.

constexpr double gridSpacing = 0.0207;

/// A number with its gradient in space: sums, products and roots carry the gradient along, so that
/// normals are exact.
struct Dual {
  double value = 0;
  double x = 0, y = 0, z = 0;

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.x * b.value + b.x * a.value, a.y * b.value + b.y * a.value,
            a.z * b.value + b.z * a.value};
  }
  friend Dual operator*(double s, const Dual& a) {
    return {s * a.value, s * a.x, s * a.y, s * a.z};
  }
  friend Dual operator+(const Dual& a, double s) { return {a.value + s, a.x, a.y, a.z}; }
  friend Dual operator-(const Dual& a, double s) { return a + -s; }
};

Dual reciprocal(const Dual& a) {
  const double r = 1 / a.value;
  return {r, -r * r * a.x, -r * r * a.y, -r * r * a.z};
}

Dual root(const Dual& a) {
  const double r = std::sqrt(std::fmax(a.value, 1e-18));
  const double slope = 0.5 / r;
  return {r, slope * a.x, slope * a.y, slope * a.z};
}

double valueOf(const Dual& a) {
  return a.value;
}
double reciprocal(double a) {
  return 1 / a;
}
double root(double a) {
  return std::sqrt(a);
}
double valueOf(double a) {
  return a;
}

using Point = std::array<double, 3>;

/// A place in space in plain numbers or duals.
template <typename T>
struct Place {
  T x, y, z;
};

template <typename T>
Place<T> moved(const Place<T>& p, const Point& origin) {
  return {p.x - origin[0], p.y - origin[1], p.z - origin[2]};
}

template <typename T>
T squaredLength(const Place<T>& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

/// Smooth minimum with a cubic blend of width k, twice differentiable (Quílez 2013).
template <typename T>
T unite(const T& a, const T& b, double k) {
  const double gap = std::fabs(valueOf(a) - valueOf(b));
  const T& least = valueOf(a) < valueOf(b) ? a : b;
  if (gap >= k) return least;
  const T& most = valueOf(a) < valueOf(b) ? b : a;
  const T h = (1 / k) * ((least - most) + k);
  return least - (k / 6) * (h * h * h);
}

template <typename T>
T intersect(const T& a, const T& b, double k) {
  return -1.0 * unite<T>(-1.0 * a, -1.0 * b, k);
}

template <typename T>
T subtract(const T& a, const T& b, double k) {
  return intersect<T>(a, -1.0 * b, k);
}

/// First-order distance to an ellipsoid, tilted about the x axis.
template <typename T>
T ellipsoid(const Place<T>& p, const Point& centre, const Point& radii, double tilt = 0) {
  const Place<T> q = moved(p, centre);
  const double c = std::cos(tilt);
  const double s = std::sin(tilt);
  const T y = c * q.y + s * q.z;
  const T z = c * q.z - s * q.y;
  const Place<T> unit = {(1 / radii[0]) * q.x, (1 / radii[1]) * y, (1 / radii[2]) * z};
  const Place<T> slope = {(1 / radii[0]) * unit.x, (1 / radii[1]) * unit.y,
                          (1 / radii[2]) * unit.z};
  const T k = root(squaredLength(unit));
  if (valueOf(k) < 1e-3) {  // both lengths vanish at the centre
    return T{-std::fmin(radii[0], std::fmin(radii[1], radii[2]))};
  }
  return k * (k - 1.0) * reciprocal(root(squaredLength(slope)));
}

template <typename T>
T clampToUnit(const T& a) {
  return valueOf(a) <= 0 ? T{0} : valueOf(a) >= 1 ? T{1} : a;
}

/// The places within a radius of the segment from a to b.
template <typename T>
T stick(const Place<T>& p, const Point& a, const Point& b, double radius) {
  const Place<T> q = moved(p, a);
  const Point d = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const T t = clampToUnit<T>((1 / squared) * (d[0] * q.x + d[1] * q.y + d[2] * q.z));
  const Place<T> r = {q.x - d[0] * t, q.y - d[1] * t, q.z - d[2] * t};
  return root(squaredLength(r)) - radius;
}

template <typename T>
T ear(const Place<T>& p, double side) {
  const T shell = ellipsoid<T>(p, {side * .345, 1.86, .01}, {.19, .195, .085}, -.15);
  const T hollow = ellipsoid<T>(p, {side * .35, 1.86, .125}, {.12, .125, .085}, -.15);
  return subtract(shell, hollow, .05);
}

template <typename T>
T arm(const Place<T>& p, double side) {
  const T shoulder = ellipsoid<T>(p, {side * .39, .99, .13}, {.18, .20, .20});
  const T fore = ellipsoid<T>(p, {side * .365, .90, .30}, {.165, .165, .20}, -.35);
  const T paw = ellipsoid<T>(p, {side * .30, .88, .435}, {.15, .14, .13});
  return unite(unite(shoulder, fore, .15), paw, .1);
}

template <typename T>
T leg(const Place<T>& p, double side) {
  const T thigh = ellipsoid<T>(p, {side * .30, .27, .20}, {.235, .25, .34});
  const T foot = ellipsoid<T>(p, {side * .315, .245, .50}, {.20, .235, .135}, .12);
  const T sole = ellipsoid<T>(p, {side * .32, .22, .70}, {.11, .12, .09});
  return subtract(unite(thigh, foot, .12), sole, .06);
}

template <typename T>
T head(const Place<T>& p) {
  T d = ellipsoid<T>(p, {0, 1.54, .03}, {.455, .385, .385});
  d = unite(d, ellipsoid<T>(p, {0, 1.44, .11}, {.43, .26, .30}), .15);
  for (const double side : {-1.0, 1.0}) d = unite(d, ear(p, side), .09);
  d = unite(d, ellipsoid<T>(p, {0, 1.42, .385}, {.205, .155, .165}), .08);
  d = unite(d, ellipsoid<T>(p, {0, 1.495, .53}, {.08, .055, .05}), .02);
  for (const double side : {-1.0, 1.0}) {
    const T smile = stick(p, {side * .005, 1.375, .57}, {side * .085, 1.405, .52}, .017);
    d = subtract(d, smile, .06);
  }
  for (const double side : {-1.0, 1.0}) {
    d = unite(d, ellipsoid<T>(p, {side * .175, 1.635, .37}, {.055, .063, .045}), .02);
  }
  return d;
}

template <typename T>
T bear(const Place<T>& p) {
  T body = ellipsoid<T>(p, {0, .74, -.03}, {.47, .60, .40});
  body = unite(body, ellipsoid<T>(p, {0, .56, .07}, {.47, .43, .42}), .2);
  T d = unite(body, head(p), .14);
  for (const double side : {-1.0, 1.0}) {
    d = unite(d, arm(p, side), .11);
    d = unite(d, leg(p, side), .12);
  }
  d = unite(d, ellipsoid<T>(p, {0, .24, -.37}, {.115, .115, .11}), .1);
  return intersect<T>(d, -1.0 * p.y, .08);
}

double bearDistance(const Point& p) {
  return bear<double>({p[0], p[1], p[2]});
}

FieldSample bearSample(const Point& p) {
  const Dual d = bear<Dual>({{p[0], 1, 0, 0}, {p[1], 0, 1, 0}, {p[2], 0, 0, 1}});
  return {d.value, {d.x, d.y, d.z}};
}

}  // namespace

Mesh bearMesh() {
  Mesh mesh =
      polygonise({bearDistance, bearSample}, {{-.85, -.1, -.75}, {.85, 2.25, .95}, gridSpacing});
  float lowest = mesh.positionsMm.front()[1];
  for (const Vec3& p : mesh.positionsMm) lowest = std::min(lowest, p[1]);
  for (Vec3& p : mesh.positionsMm) p[1] -= lowest;
  scaleToDiagonal(mesh, 50);
  return mesh;
}

}  // namespace opaline::builtin

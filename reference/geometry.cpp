#include "reference/geometry.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "opaline/error.h"
#include "reference/opaque_surface.h"

namespace opaline::reference {

namespace {

constexpr std::uint32_t none = RTC_INVALID_GEOMETRY_ID;

#if RTC_VERSION_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

/// What a ray ignores. Embree passes the context on to the filter.
struct Query {
  QueryContext context;  // first member: the filter gets its address
  const Scene* scene = nullptr;
  std::uint32_t body = none;
  std::uint32_t triangle = none;
};

bool hasHoles(const Body& body) {
  return body.opaque && body.opaque->alphaCutoff > 0;
}

// Ignores holes and the triangle on which a ray starts.
void leaveOut(const RTCFilterFunctionNArguments* arguments) {
  const auto* query = reinterpret_cast<const Query*>(arguments->context);
  const std::uint32_t index = RTCHitN_geomID(arguments->hit, arguments->N, 0);
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const Body& body = query->scene->bodies[index];
  const double u{RTCHitN_u(arguments->hit, arguments->N, 0)};
  const double v{RTCHitN_v(arguments->hit, arguments->N, 0)};
  if ((index == query->body && triangle == query->triangle) ||
      (hasHoles(body) && isCutOut(body, triangle, {1 - u - v, u, v})))
    arguments->valid[0] = 0;
}

// Embree 4 gets the filter with each ray, Embree 3 with the context.
#if RTC_VERSION_MAJOR >= 4
constexpr RTCSceneFlags filtered = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

void begin(QueryContext& context) {
  rtcInitRayQueryContext(&context);
}

template <typename Arguments>
void setFilter(Arguments& arguments, QueryContext& context) {
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  arguments.context = &context;
  arguments.filter = leaveOut;
}

void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  setFilter(arguments, context);
  rtcIntersect1(scene, &ray, &arguments);
}

void occlude(RTCScene scene, QueryContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  setFilter(arguments, context);
  rtcOccluded1(scene, &ray, &arguments);
}
#else
constexpr RTCSceneFlags filtered = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

void begin(QueryContext& context) {
  rtcInitIntersectContext(&context);
  context.filter = leaveOut;
}

void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
  rtcIntersect1(scene, &context, &ray);
}

void occlude(RTCScene scene, QueryContext& context, RTCRay& ray) {
  rtcOccluded1(scene, &context, &ray);
}
#endif

Query queryFrom(const Scene& scene, std::uint32_t body, std::uint32_t triangle) {
  Query query{};
  begin(query.context);
  query.scene = &scene;
  query.body = body;
  query.triangle = triangle;
  return query;
}

RTCRay rayOf(const Vector& origin, const Vector& direction, double distanceMm) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin[0]);
  ray.org_y = static_cast<float>(origin[1]);
  ray.org_z = static_cast<float>(origin[2]);
  ray.dir_x = static_cast<float>(direction[0]);
  ray.dir_y = static_cast<float>(direction[1]);
  ray.dir_z = static_cast<float>(direction[2]);
  ray.tnear = 0;
  ray.tfar = static_cast<float>(distanceMm);
  ray.mask = ~0U;
  return ray;
}

void requireNoError(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw Error(error == RTC_ERROR_OUT_OF_MEMORY
                  ? std::string("not enough memory for the rays' tree of the surface")
                  : fmt::format("Embree fails with error {}", static_cast<int>(error)));
}

}  // namespace

struct Geometry::Device {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::vector<Vec3>> places;  ///< relative to the box's centre, with a spare entry

  ~Device() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void add(const Body& body, std::uint32_t index, const Vector& centre) {
    if (body.triangles.empty()) return;
    std::vector<Vec3>& own = places.emplace_back();
    own.reserve(body.positionsMm.size() + 1);
    for (const Vector& p : body.positionsMm) {
      const Vector relative = p - centre;
      own.push_back({static_cast<float>(relative[0]), static_cast<float>(relative[1]),
                     static_cast<float>(relative[2])});
    }
    own.push_back({});  // Embree reads 16 bytes at the last vertex
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, own.data(),
                               0, sizeof(Vec3), own.size() - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               body.triangles.data(), 0, sizeof(Triangle), body.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, index);
    rtcReleaseGeometry(geometry);
    requireNoError(device);
  }
};

Geometry::Geometry(const Scene& scene)
    : scene_(scene), box_(boxOf(scene)), device_(std::make_unique<Device>()) {
  requireSound(scene);
  // 2⁻²² of half the box: four units in the last place of its largest coordinates. That is twice
  // what rounding moves the start of a ray and a corner.
  offsetMm_ = std::ldexp(std::max(box_.diagonalMm(), 1e-30), -22);
  device_->device = rtcNewDevice(nullptr);
  if (device_->device == nullptr) throw Error("Embree, which casts the rays, does not start");
  device_->scene = rtcNewScene(device_->device);
  rtcSetSceneFlags(device_->scene, RTC_SCENE_FLAG_ROBUST | filtered);
  rtcSetSceneBuildQuality(device_->scene, RTC_BUILD_QUALITY_HIGH);
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    device_->add(scene.bodies[i], i, box_.centre());
  }
  rtcCommitScene(device_->scene);
  requireNoError(device_->device);
}

Geometry::~Geometry() = default;

SurfacePoint Geometry::pointOn(std::uint32_t body, std::uint32_t triangle,
                               const std::array<double, 3>& weights) const {
  const Body& of = scene_.bodies[body];
  const Triangle& corners = of.triangles[triangle];
  const Vector& a = of.positionsMm[corners[0]];
  const Vector& b = of.positionsMm[corners[1]];
  const Vector& c = of.positionsMm[corners[2]];
  SurfacePoint point;
  point.position = weights[0] * a + weights[1] * b + weights[2] * c;
  const Vector normal = weights[0] * of.normals[corners[0]] + weights[1] * of.normals[corners[1]] +
                        weights[2] * of.normals[corners[2]];
  point.facetNormal = unitOr(cross(b - a, c - a), unitOr(normal, {0, 0, 1}));
  point.shadingNormal = unitOr(normal, point.facetNormal);
  point.body = body;
  point.triangle = triangle;
  point.weights = weights;
  return point;
}

Vector Geometry::startOf(const SurfacePoint& from, const Vector& direction) const {
  const double side = dot(from.facetNormal, direction) < 0 ? -offsetMm_ : offsetMm_;
  return from.position + side * from.facetNormal;
}

namespace {

/// Möller and Trumbore 1997. The weights are clamped to the triangle that single precision hit.
Geometry::Hit refined(const Geometry& geometry, std::uint32_t body, std::uint32_t triangle,
                      const Vector& origin, const Vector& direction) {
  const Body& of = geometry.scene().bodies[body];
  const Triangle& corners = of.triangles[triangle];
  const Vector& a = of.positionsMm[corners[0]];
  const Vector ab = of.positionsMm[corners[1]] - a;
  const Vector ac = of.positionsMm[corners[2]] - a;
  const Vector p = cross(direction, ac);
  const double determinant = dot(ab, p);
  std::array<double, 3> weights{1, 0, 0};
  if (determinant != 0) {
    const Vector s = origin - a;
    const double u = dot(s, p) / determinant;
    const double v = dot(direction, cross(s, ab)) / determinant;
    weights = {1 - u - v, u, v};
    double sum = 0;
    for (double& weight : weights) {
      weight = std::isfinite(weight) ? std::clamp(weight, 0.0, 1.0) : 1.0;
      sum += weight;
    }
    for (double& weight : weights) weight /= sum;
  }
  Geometry::Hit hit{geometry.pointOn(body, triangle, weights), 0};
  hit.distanceMm = dot(hit.point.position - origin, direction);
  return hit;
}

}  // namespace

std::optional<Geometry::Hit> Geometry::closestBut(std::uint32_t body, std::uint32_t triangle,
                                                  const Vector& origin,
                                                  const Vector& direction) const {
  Query query = queryFrom(scene_, body, triangle);
  RTCRayHit ray{};
  ray.ray = rayOf(origin - box_.centre(), direction, std::numeric_limits<double>::infinity());
  ray.hit.geomID = none;
  intersect(device_->scene, query.context, ray);
  if (ray.hit.geomID == none) return std::nullopt;
  return refined(*this, ray.hit.geomID, ray.hit.primID, origin, direction);
}

std::optional<Geometry::Hit> Geometry::closestHit(const Vector& origin,
                                                  const Vector& direction) const {
  return closestBut(none, none, origin, direction);
}

std::optional<Geometry::Hit> Geometry::closestHit(const SurfacePoint& from,
                                                  const Vector& direction) const {
  return closestBut(from.body, from.triangle, startOf(from, direction), direction);
}

namespace {

/// The point of a triangle that is nearest to a place (Ericson 2005, 5.1.5).
Vector nearestOn(const Vector& a, const Vector& b, const Vector& c, const Vector& place) {
  const Vector ab = b - a;
  const Vector ac = c - a;
  const double d1 = dot(ab, place - a);
  const double d2 = dot(ac, place - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = dot(ab, place - b);
  const double d4 = dot(ac, place - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double d5 = dot(ab, place - c);
  const double d6 = dot(ac, place - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double ofC = d1 * d4 - d3 * d2;
  if (ofC <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const double ofB = d5 * d2 - d1 * d6;
  if (ofB <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const double ofA = d3 * d6 - d5 * d4;
  if (ofA <= 0 && d4 >= d3 && d5 >= d6) return b + ((d4 - d3) / (d4 - d3 + d5 - d6)) * (c - b);
  const double sum = ofA + ofB + ofC;
  return sum > 0 ? a + (ofB / sum) * ab + (ofC / sum) * ac : a;
}

/// What Embree's query for the nearest triangle passes on.
struct Nearest {
  const Scene& scene;
  std::uint32_t whole;
  Vector place;
  double squaredMm2 = std::numeric_limits<double>::infinity();
  std::uint32_t body;
};

bool takeIfNearer(RTCPointQueryFunctionArguments* arguments) {
  Nearest& nearest = *static_cast<Nearest*>(arguments->userPtr);
  if (wholeOf(nearest.scene, arguments->geomID) != nearest.whole) return false;
  const Body& body = nearest.scene.bodies[arguments->geomID];
  const Triangle& t = body.triangles[arguments->primID];
  const Vector offset = nearestOn(body.positionsMm[t[0]], body.positionsMm[t[1]],
                                  body.positionsMm[t[2]], nearest.place) -
                        nearest.place;
  const double squared = dot(offset, offset);
  if (squared >= nearest.squaredMm2) return false;
  nearest.squaredMm2 = squared;
  nearest.body = arguments->geomID;
  arguments->query->radius = static_cast<float>(std::sqrt(squared));
  return true;
}

}  // namespace

std::uint32_t Geometry::nearestPart(std::uint32_t body, const Vector& place) const {
  Nearest nearest{.scene = scene_, .whole = wholeOf(scene_, body), .place = place, .body = body};
  const Vector relative = place - box_.centre();
  RTCPointQuery query{};
  query.x = static_cast<float>(relative[0]);
  query.y = static_cast<float>(relative[1]);
  query.z = static_cast<float>(relative[2]);
  query.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(device_->scene, &query, &context, takeIfNearer, &nearest);
  return nearest.body;
}

bool Geometry::occluded(const SurfacePoint& from, const Vector& direction,
                        double distanceMm) const {
  Query query = queryFrom(scene_, from.body, from.triangle);
  RTCRay ray = rayOf(startOf(from, direction) - box_.centre(), direction, distanceMm);
  occlude(device_->scene, query.context, ray);
  return ray.tfar < 0;
}

}  // namespace opaline::reference

#include "boundary/light_points.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace opaline::test::boundary {

using namespace reference;

namespace {

struct Node {
  double place;
  double weight;
};

// Gauss-Legendre nodes on [0, 1].
constexpr std::array<Node, 3> three{
    {{0.112701665379258, 5.0 / 18}, {0.5, 8.0 / 18}, {0.887298334620742, 5.0 / 18}}};
constexpr std::array<Node, 2> ofOthers{{{0.211324865405187, 0.5}, {0.788675134594813, 0.5}}};
constexpr double least = 0.005;
constexpr int mostReflections = 4;

struct Collision {
  double alongMm;
  double share;
};

// Points within a length, representing all collisions. They are as dense as for light in a medium
// three times as thin: little light gets far, but it is all there is on the other side.
std::vector<Collision> firstWithin(double lengthMm, double perMm) {
  constexpr int panels = 3;
  const double thinner = perMm / 3;
  const double within = -std::expm1(-thinner * lengthMm);
  std::vector<Collision> collisions;
  for (int panel = 0; panel < panels; ++panel)
    for (const Node& node : three) {
      const double along = -std::log1p(-(panel + node.place) / panels * within) / thinner;
      collisions.push_back({along, node.weight / panels * within * perMm / thinner *
                                       std::exp((thinner - perMm) * along)});
    }
  return collisions;
}

std::vector<Collision> othersWithin(double lengthMm, double perMm) {
  const double taken = -std::expm1(-perMm * lengthMm);
  std::vector<Collision> collisions;
  for (const Node& node : ofOthers)
    collisions.push_back({-std::log1p(-node.place * taken) / perMm, node.weight * taken});
  return collisions;
}

// Follows a ray from a cluster through the body, mirrored at its walls. Light with a mean slant to
// the ray, of cosine below 1, travels correspondingly longer.
void follow(const Geometry& geometry, const Cluster& cluster, std::uint32_t index, Vector direction,
            double slantCosine, const Diffusion& medium, std::vector<LightPoint>& points) {
  const double perMm = medium.extinctionPerMm / slantCosine;
  const Vector shift = cluster.centroidMm - cluster.start.position;
  SurfacePoint from = cluster.start;
  double weight = 1;
  for (int segment = 0; segment <= mostReflections; ++segment) {
    const auto hit = geometry.closestHit(from, direction);
    const double lengthMm = hit ? hit->distanceMm : 0;
    const double taken = -std::expm1(-perMm * lengthMm);
    for (const auto& [along, share] :
         segment == 0 ? firstWithin(lengthMm, perMm) : othersWithin(lengthMm, perMm)) {
      LightPoint point;
      point.placeMm = from.position + along * direction + shift;
      point.weight = weight * share;
      point.depthMm = -along * dot(direction, cluster.normal);
      point.cluster = index;
      point.direct = segment == 0;
      if (point.weight > 0) points.push_back(point);
    }
    if (!hit) return;
    const double cosine = std::abs(dot(direction, hit->point.facetNormal));
    weight *= (1 - taken) * reflectanceInside(medium.eta, std::min(1.0, slantCosine * cosine));
    if (weight < least) return;
    direction = unitOr(
        direction - 2 * dot(direction, hit->point.facetNormal) * hit->point.facetNormal, direction);
    from = hit->point;
  }
}

std::vector<LightPoint> joined(const std::vector<std::vector<LightPoint>>& parts) {
  std::vector<LightPoint> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<LightPoint> firstCollisions(const Geometry& geometry, const TriangleClusters& clusters,
                                        const Diffusion& medium, const Vector& directionToLight) {
  std::vector<std::vector<LightPoint>> parts(clusters.count());
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    const Cluster& cluster = clusters.list[i];
    const double cosine = std::max(dot(cluster.normal, directionToLight), 0.02);
    const double inner = std::sqrt(1 - (1 - cosine * cosine) / (medium.eta * medium.eta));
    const Vector across = dot(cluster.normal, directionToLight) * cluster.normal - directionToLight;
    const Vector direction =
        unitOr((1 / medium.eta) * across - inner * cluster.normal, -cluster.normal);
    follow(geometry, cluster, static_cast<std::uint32_t>(i), direction, 1, medium, parts[i]);
  });
  return joined(parts);
}

std::vector<LightPoint> firstCollisionsOfDiffuse(const Geometry& geometry,
                                                 const TriangleClusters& clusters,
                                                 const Diffusion& medium) {
  std::vector<std::vector<LightPoint>> parts(clusters.count());
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    follow(geometry, clusters.list[i], static_cast<std::uint32_t>(i), -clusters.list[i].normal,
           medium.slantCosine, medium, parts[i]);
  });
  return joined(parts);
}

std::vector<LightPoint> secondCollisions(const Geometry& geometry,
                                         const std::vector<LightPoint>& first,
                                         const TriangleClusters& clusters, const Diffusion& medium,
                                         int directions) {
  std::vector<std::vector<LightPoint>> parts(first.size());
  tbb::parallel_for(std::size_t{0}, first.size(), [&](std::size_t p) {
    std::mt19937_64 random(p);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LightPoint& at = first[p];
    const Cluster& cluster = clusters.list[at.cluster];
    const Vector shift = cluster.centroidMm - cluster.start.position;
    const double turn = uniform(random);
    std::vector<int> order(static_cast<std::size_t>(directions));
    for (int k = 0; k < directions; ++k) order[static_cast<std::size_t>(k)] = k;
    std::shuffle(order.begin(), order.end(), random);
    for (int k = 0; k < directions; ++k) {
      // Strata in the cosine; golden angles about the axis.
      const double cosine = 1 - 2 * (k + uniform(random)) / directions;
      const double angle = 2 * std::numbers::pi * (turn + k * 0.6180339887498949);
      const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
      Vector direction{sine * std::cos(angle), sine * std::sin(angle), cosine};
      double left = -std::log((order[static_cast<std::size_t>(k)] + uniform(random)) / directions) /
                    medium.extinctionPerMm;
      double weight = at.weight / directions;
      Vector from = at.placeMm - shift;
      auto hit = geometry.closestHit(from, direction);
      for (int wall = 0; hit && hit->distanceMm < left && wall < 12; ++wall) {
        const Vector& normal = hit->point.facetNormal;
        weight *= reflectanceInside(medium.eta, std::min(1.0, std::abs(dot(direction, normal))));
        direction = unitOr(direction - 2 * dot(direction, normal) * normal, direction);
        left -= hit->distanceMm;
        from = hit->point.position;
        hit = geometry.closestHit(hit->point, direction);
      }
      if (!hit || hit->distanceMm < left || weight < 1e-4 * at.weight) continue;
      LightPoint point = at;
      point.placeMm = from + left * direction + shift;
      point.weight = weight;
      point.direct = false;
      parts[p].push_back(point);
    }
  });
  return joined(parts);
}

std::vector<SingleExit> singleExits(const Geometry& geometry, const std::vector<LightPoint>& first,
                                    const TriangleClusters& clusters, const Diffusion& medium,
                                    int directions) {
  std::vector<std::vector<SingleExit>> parts(first.size());
  tbb::parallel_for(std::size_t{0}, first.size(), [&](std::size_t p) {
    std::mt19937_64 random(p);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LightPoint& at = first[p];
    const Cluster& cluster = clusters.list[at.cluster];
    const Vector start = at.placeMm - (cluster.centroidMm - cluster.start.position);
    const double turn = uniform(random);
    for (int k = 0; k < directions; ++k) {
      const double cosine = 1 - 2 * (k + uniform(random)) / directions;
      const double angle = 2 * std::numbers::pi * (turn + k * 0.6180339887498949);
      const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
      Vector direction{sine * std::cos(angle), sine * std::sin(angle), cosine};
      double weight = at.weight / directions;
      auto hit = geometry.closestHit(start, direction);
      for (int wall = 0; hit && wall < 12; ++wall) {
        const Vector& normal = hit->point.facetNormal;
        const double inside =
            reflectanceInside(medium.eta, std::min(1.0, std::abs(dot(direction, normal))));
        weight *= std::exp(-medium.extinctionPerMm * hit->distanceMm);
        if (weight < 1e-4 * at.weight) break;
        if (inside < 1)
          parts[p].push_back(
              {at.cluster, clusters.ofTriangle[hit->point.triangle], weight * (1 - inside)});
        weight *= inside;
        direction = unitOr(direction - 2 * dot(direction, normal) * normal, direction);
        hit = geometry.closestHit(hit->point, direction);
      }
    }
  });
  std::vector<SingleExit> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace opaline::test::boundary

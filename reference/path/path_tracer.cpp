#include "reference/path/path_tracer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "opaline/error.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;

// For light that leaves evenly through a smooth boundary, the share within a cone about the unit
// vector `axis`. Computed over rings of equal solid angle.
double evenShareOf(const Vector& axis, double degrees, const Vector& normal, double eta) {
  constexpr int rings = 8;
  constexpr int places = 16;
  const double cap = 1 - std::cos(degrees * pi / 180);
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double along = 1 - cap * (ring + 0.5) / rings;
    for (int i = 0; i < places; ++i) {
      const double cosine = dot(normal, around(axis, along, 2 * pi * (i + 0.5) / places));
      if (cosine > 0) sum += cosine * (1 - bssrdf::fresnelReflectance(eta, std::min(cosine, 1.0)));
    }
  }
  return 2 * cap * sum / (rings * places) / bssrdf::meanTransmittance(eta);
}

std::vector<double> seenAreas(const Cells& cells, const Scene& scene, double coneDegrees) {
  std::vector<double> areas(cells.count());
  cells.forEachPart(scene, [&](const Cells::Part& part) {
    const double share =
        coneDegrees > 0
            ? evenShareOf(unitOr(toVector(scene.camera.positionMm) - part.middleMm, part.normal),
                          coneDegrees, part.normal, scene.bodies[part.body].medium.eta)
            : 1;
    areas[part.cell] += share * part.areaMm2;
  });
  return areas;
}

// As fine as the shadows of media need, and no more than there is room for.
double opaqueCellEdgeMm(const Scene& scene) {
  constexpr double ofScene = 1.0 / 400;
  constexpr double ofMedia = 1.0 / 100;
  constexpr double mostCells = 16e6;
  double squares = 0;
  for (const Body& body : scene.bodies) {
    if (!body.opaque || body.isGround) continue;
    for (const Triangle& t : body.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector edge = body.positionsMm[t[i]] - body.positionsMm[t[(i + 1) % 3]];
        squares += dot(edge, edge);
      }
  }
  return std::max({ofScene * boxOf(scene).diagonalMm(), ofMedia * boxOfMedia(scene).diagonalMm(),
                   2 * std::sqrt(squares / mostCells)});
}

// Nothing arrives straight through a medium where there is none.
Cells opaqueCells(const Scene& scene) {
  const Scene nothing;
  return {hasMedia(scene) ? scene : nothing, opaqueCellEdgeMm(scene), Cells::Of::Opaque};
}

}  // namespace

double cellEdgeMm(const Scene& scene) {
  double shortest = 1e300;
  for (const Body& body : scene.bodies)
    for (std::size_t c = 0; c < 3 && !body.opaque; ++c) {
      const double s = body.medium.sigmaSPrimePerMm[c];
      const double a = body.medium.sigmaAPerMm[c];
      shortest = std::min(shortest, 1 / std::sqrt(std::max(3 * a * (a + s), 1e-300)));
    }
  const double diagonal = boxOf(scene).diagonalMm();
  return std::clamp(shortest / 4, diagonal / 400, diagonal / 60);
}

PathTracer::PathTracer(const Geometry& geometry, const PathOptions& options)
    : geometry_(geometry),
      options_(options),
      bound_(geometry.scene()),
      cells_(geometry.scene(), options.cellMm > 0 ? options.cellMm : cellEdgeMm(geometry.scene()),
             Cells::Of::Media),
      opaqueCells_(opaqueCells(geometry.scene())),
      emitters_{Emitter(geometry, 0), Emitter(geometry, 1), Emitter(geometry, 2)},
      seenMm2_(seenAreas(cells_, geometry.scene(), options.coneDegrees)),
      interiors_{interiorsOf(geometry.scene(), 0), interiorsOf(geometry.scene(), 1),
                 interiorsOf(geometry.scene(), 2)},
      counts_(3 * (orders * cells_.count() + sides * opaqueCells_.count())) {
  if (options.bounces < 0) throw UsageError("the number of bounces must be at least 0");
}

void PathTracer::follow(std::size_t channel, std::uint64_t particle) {
  Random random(options_.seed * 3 + channel, particle);
  const Walk walk(geometry_, bound_, interiors_[channel], options_.bounces, channel);
  const Flight flight = emitters_[channel].emit(random);
  const auto count = [&](std::size_t slot) {
    counts_[slot].fetch_add(1, std::memory_order_relaxed);
  };
  const auto leave = [&](const Leaving& leaving) {
    if (isCounted(leaving)) count(slot(channel, leaving.order, cells_.at(leaving.point)));
  };
  const auto arrive = [&](const Arriving& arriving) {
    count(slotOfArrival(channel, arriving.point, -arriving.direction));
  };
  const End end = walk.follow(flight, random, leave, arrive);
  if (end == End::Lost) lost_[channel].fetch_add(1, std::memory_order_relaxed);
}

bool PathTracer::isCounted(const Leaving& leaving) const {
  if (options_.coneDegrees <= 0) return true;
  const Vector toCamera = unitOr(
      toVector(geometry_.scene().camera.positionMm) - leaving.point.position, leaving.direction);
  return dot(toCamera, leaving.direction) > std::cos(options_.coneDegrees * pi / 180);
}

void PathTracer::run(std::uint64_t particles) {
  constexpr std::uint64_t grain = 256;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!(emitters_[channel].flux() > 0)) continue;
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(particles_, particles_ + particles, grain),
                      [&](const tbb::blocked_range<std::uint64_t>& range) {
                        for (std::uint64_t i = range.begin(); i < range.end(); ++i)
                          follow(channel, i);
                      });
  }
  particles_ += particles;
}

double PathTracer::fluxOfParticle(std::size_t channel) const {
  return particles_ == 0 ? 0 : emitters_[channel].flux() / static_cast<double>(particles_);
}

// Particles are independent, so counts are nearly Poisson distributed.
Exitance PathTracer::exitanceOfCell(std::size_t cell) const {
  Exitance exitance;
  const double area = std::max(seenMm2_[cell], 1e-300);
  for (std::size_t c = 0; c < 3; ++c) {
    double count = 0;
    if (options_.shown != Scattered::Multiple) count += counts_[slot(c, Order::Single, cell)];
    if (options_.shown != Scattered::Single) count += counts_[slot(c, Order::Multiple, cell)];
    exitance.value[c] = count * fluxOfParticle(c) / area;
    exitance.error[c] = std::sqrt(count) * fluxOfParticle(c) / area;
  }
  return exitance;
}

std::size_t PathTracer::slotOfArrival(std::size_t channel, const SurfacePoint& point,
                                      const Vector& outside) const {
  const std::size_t side = dot(point.facetNormal, outside) < 0 ? 1 : 0;
  return 3 * orders * cells_.count() + (channel * sides + side) * opaqueCells_.count() +
         opaqueCells_.at(point);
}

Colour PathTracer::straightThrough(const SurfacePoint& point, const Vector& outside) const {
  Colour irradiance{};
  if (opaqueCells_.count() == 0) return irradiance;
  const double area = std::max(opaqueCells_.areaMm2(opaqueCells_.at(point)), 1e-300);
  for (std::size_t c = 0; c < 3; ++c)
    irradiance[c] = counts_[slotOfArrival(c, point, outside)] * fluxOfParticle(c) / area;
  return irradiance;
}

double PathTracer::leftFlux(int channel, Order order) const {
  const auto c = static_cast<std::size_t>(channel);
  std::uint64_t count = 0;
  for (std::size_t cell = 0; cell < cells_.count(); ++cell) count += counts_[slot(c, order, cell)];
  return static_cast<double>(count) * fluxOfParticle(c);
}

double PathTracer::lostShare(int channel) const {
  return particles_ == 0 ? 0
                         : static_cast<double>(lost_[static_cast<std::size_t>(channel)].load()) /
                               static_cast<double>(particles_);
}

}  // namespace opaline::reference

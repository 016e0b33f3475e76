#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/exitance.h"
#include "reference/geometry.h"
#include "reference/path/cells.h"
#include "reference/path/distance_bound.h"
#include "reference/path/emitter.h"
#include "reference/path/walk.h"

namespace opaline::reference {

/// Selects leaving light by how often it scattered since it entered.
enum class Scattered { Single, Multiple, Both };

struct PathOptions {
  int bounces = 1000;  ///< how often light that left a body may hit one again, ≥ 0
  std::uint64_t seed = 1;
  double cellMm = 0;                  ///< edge of the cells for counting; 0: see cellEdgeMm()
  Scattered shown = Scattered::Both;  ///< which of the counted light is in the exitance
  double coneDegrees =
      0;  ///< counts only what leaves so near to the direction of the camera, and takes the
          ///< exitance for that of a surface where as much does evenly; 0: counts all
};

/// A quarter of the shortest diffusion length of the scene's media, limited to between 1/400 and
/// 1/60 of its diagonal.
double cellEdgeMm(const Scene& scene);

/// Volumetric light transport by particles from the lights. Each is followed through bodies, and
/// from one to another, until it is absorbed or leaves the scene. It is counted wherever it leaves
/// a body that it had entered, and wherever it arrives at an opaque body straight through a medium.
/// Counts are whole numbers of particles of equal flux, so the result depends on the seed and the
/// number of particles, not on threads. The only bias is due to the size of the cells.
class PathTracer {
 public:
  /// The geometry's scene must outlive it.
  PathTracer(const Geometry& geometry, const PathOptions& options);

  /// Traces that many more particles of each channel that has light.
  void run(std::uint64_t particles);

  /// Whether there is light and a medium that it could enter. Otherwise there is nothing to trace.
  bool shines() const {
    return hasMedia(geometry_.scene()) &&
           std::any_of(emitters_.begin(), emitters_.end(),
                       [](const Emitter& emitter) { return emitter.flux() > 0; });
  }

  /// The selected light that left through a cell, or through the cell of a point. `error` is one
  /// standard error.
  Exitance exitanceOfCell(std::size_t cell) const;
  Exitance exitance(const SurfacePoint& point) const { return exitanceOfCell(cells_.at(point)); }

  /// The irradiance of light that arrives at an opaque body, straight through a medium, on the side
  /// that `outside` points to.
  Colour straightThrough(const SurfacePoint& point, const Vector& outside) const;

  /// All counts, to continue at another time. restore() throws Error unless they are from the same
  /// scene and options.
  std::vector<std::byte> save() const;
  void restore(std::span<const std::byte> saved);

  /// Flux of all lights together, the light that left all bodies by order, and its standard error.
  double emittedFlux(int channel) const {
    return emitters_[static_cast<std::size_t>(channel)].flux();
  }
  double leftFlux(int channel, Order order) const;
  /// The share of the particles that slipped through gaps of the surface.
  double lostShare(int channel) const;
  std::uint64_t particles() const { return particles_; }

  const Cells& cells() const { return cells_; }
  const InteriorsByChannel& interiors() const { return interiors_; }
  const PathOptions& options() const { return options_; }

 private:
  static constexpr std::size_t orders = 3;
  static constexpr std::size_t sides = 2;  // of a surface

  std::uint64_t fingerprint() const;
  std::size_t slot(std::size_t channel, Order order, std::size_t cell) const {
    return (channel * orders + static_cast<std::size_t>(order)) * cells_.count() + cell;
  }
  double fluxOfParticle(std::size_t channel) const;
  void follow(std::size_t channel, std::uint64_t particle);
  bool isCounted(const Leaving& leaving) const;
  /// The place of a count of arrivals.
  std::size_t slotOfArrival(std::size_t channel, const SurfacePoint& point,
                            const Vector& outside) const;

  const Geometry& geometry_;
  PathOptions options_;
  DistanceBound bound_;
  Cells cells_;
  Cells opaqueCells_;
  std::array<Emitter, 3> emitters_;
  std::vector<double>
      seenMm2_;  ///< per cell: its area times the share of even light that is counted
  InteriorsByChannel interiors_;
  std::uint64_t particles_ = 0;
  std::vector<std::atomic<std::uint32_t>> counts_;  ///< of cells, then of opaque ones
  std::array<std::atomic<std::uint64_t>, 3> lost_{};
};

}  // namespace opaline::reference

#pragma once

#include <span>
#include <vector>

#include "boundary/channel.h"
#include "boundary/clusters.h"
#include "boundary/gmres.h"
#include "boundary/light_points.h"

namespace opaline::test::boundary {

/// Solves the diffusion equation on a body's boundary in one channel, for every pair of clusters.
/// Independent of the renderer.
class DenseBoundary {
 public:
  DenseBoundary(const TriangleClusters& clusters, const Channel& channel,
                std::vector<double> inside);

  const Diffusion& medium() const { return medium_; }

  struct Solution {
    std::vector<double> source;
    std::vector<double> fluence;
    std::vector<double> exitance;  ///< M
    std::vector<double> residuals;
  };

  /// The solution for light that enters with these irradiances (one per cluster) and first scatters
  /// at these points: M = α'φ/(2A).
  Solution solve(const std::vector<LightPoint>& first, std::span<const double> entering,
                 const GmresOptions& options = {}, std::span<const double> start = {}) const;

  /// The same with the source at the second collisions; light of the first ones is added
  /// separately.
  Solution solveFromSecond(const std::vector<LightPoint>& first,
                           const std::vector<LightPoint>& second, std::span<const double> entering,
                           const GmresOptions& options = {}) const;

  /// The same, with light of the first collisions from its rays.
  Solution solveFromSecond(const std::vector<SingleExit>& exits,
                           const std::vector<LightPoint>& second, std::span<const double> entering,
                           const GmresOptions& options = {}) const;

  /// The system's left side.
  void product(std::span<const double> from, std::span<double> to) const;

 private:
  const TriangleClusters& clusters_;
  Diffusion medium_;
  std::vector<double> matrix_;  ///< row by row

  Solution fromSecond(const std::vector<LightPoint>& second, std::span<const double> entering,
                      const GmresOptions& options, std::vector<double> single) const;
  void invert(Solution& solution, const GmresOptions& options, std::span<const double> start) const;
};

}  // namespace opaline::test::boundary

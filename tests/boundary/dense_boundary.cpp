#include "boundary/dense_boundary.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "boundary/pair_sums.h"

namespace opaline::test::boundary {

using namespace reference;

DenseBoundary::DenseBoundary(const TriangleClusters& clusters, const Channel& channel,
                             std::vector<double> inside)
    : clusters_(clusters), medium_(channel), matrix_(clusters.count() * clusters.count()) {
  const std::size_t n = clusters.count();
  const double sigma = medium_.attenuationPerMm;
  const double single = 1 / (2 * medium_.boundary * medium_.diffusionMm);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    double* row = &matrix_[i * n];
    const Cluster& at = clusters.list[i];
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const Cluster& of = clusters.list[j];
      const Vector offset = of.centroidMm - at.centroidMm;
      const double r = length(offset);
      row[j] = std::exp(-sigma * r) * (single * of.areaMm2 / (4 * std::numbers::pi * r) -
                                       (1 + sigma * r) * coverage(of, offset));
    }
    const double radius = at.discRadiusMm;
    const double own =
        sigma * radius < 1e-6 ? radius / 2 : -std::expm1(-sigma * radius) / (2 * sigma);
    row[i] = inside[i] + single * own;
  });
}

void DenseBoundary::product(std::span<const double> from, std::span<double> to) const {
  const std::size_t n = clusters_.count();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    const double* row = &matrix_[i * n];
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += row[j] * from[j];
    to[i] = sum;
  });
}

void DenseBoundary::invert(Solution& solution, const GmresOptions& options,
                           std::span<const double> start) const {
  const std::vector<double> zero(clusters_.count(), 0);
  GmresResult result =
      gmres([this](std::span<const double> from, std::span<double> to) { product(from, to); },
            solution.source, start.empty() ? std::span<const double>(zero) : start, options);
  solution.fluence = std::move(result.solution);
  solution.residuals = std::move(result.residuals);
}

DenseBoundary::Solution DenseBoundary::solve(const std::vector<LightPoint>& first,
                                             std::span<const double> entering,
                                             const GmresOptions& options,
                                             std::span<const double> start) const {
  Solution solution;
  solution.source.assign(clusters_.count(), 0);
  addFluence(fluxOf(first, entering, clusters_), clusters_, medium_, solution.source);
  correctOwnFluence(first, entering, clusters_, medium_, solution.source);
  invert(solution, options, start);
  for (const double fluence : solution.fluence)
    solution.exitance.push_back(medium_.albedo * fluence / (2 * medium_.boundary));
  return solution;
}

DenseBoundary::Solution DenseBoundary::fromSecond(const std::vector<LightPoint>& second,
                                                  std::span<const double> entering,
                                                  const GmresOptions& options,
                                                  std::vector<double> single) const {
  Solution solution;
  solution.source.assign(clusters_.count(), 0);
  addFluence(fluxOf(second, entering, clusters_), clusters_, medium_, solution.source);
  invert(solution, options, {});
  solution.exitance = std::move(single);
  for (std::size_t i = 0; i < clusters_.count(); ++i) {
    solution.exitance[i] =
        medium_.albedo *
        (solution.exitance[i] + medium_.albedo * solution.fluence[i] / (2 * medium_.boundary));
  }
  return solution;
}

DenseBoundary::Solution DenseBoundary::solveFromSecond(const std::vector<LightPoint>& first,
                                                       const std::vector<LightPoint>& second,
                                                       std::span<const double> entering,
                                                       const GmresOptions& options) const {
  std::vector<double> single(clusters_.count(), 0);
  addUnscattered(fluxOf(first, entering, clusters_), clusters_, medium_, single);
  correctOwnUnscattered(first, entering, clusters_, medium_, single);
  return fromSecond(second, entering, options, std::move(single));
}

DenseBoundary::Solution DenseBoundary::solveFromSecond(const std::vector<SingleExit>& exits,
                                                       const std::vector<LightPoint>& second,
                                                       std::span<const double> entering,
                                                       const GmresOptions& options) const {
  std::vector<double> single(clusters_.count(), 0);
  for (const SingleExit& exit : exits) {
    single[exit.at] += entering[exit.from] * exit.share * clusters_.list[exit.from].areaMm2 /
                       clusters_.list[exit.at].areaMm2;
  }
  return fromSecond(second, entering, options, std::move(single));
}

}  // namespace opaline::test::boundary

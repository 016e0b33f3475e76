#pragma once

#include <functional>
#include <span>
#include <vector>

namespace opaline::test::boundary {

struct GmresOptions {
  double tolerance = 1e-8;  ///< of the residual, relative to the right-hand side
  int mostSteps = 200;
};

struct GmresResult {
  std::vector<double> solution;
  std::vector<double> residuals;  ///< relative, after each step
};

/// Saad and Schultz 1986, without restarts.
GmresResult gmres(
    const std::function<void(std::span<const double> from, std::span<double> to)>& product,
    std::span<const double> rightSide, std::span<const double> start,
    const GmresOptions& options = {});

}  // namespace opaline::test::boundary

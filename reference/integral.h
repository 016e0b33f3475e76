#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "opaline/renderer.h"
#include "reference/exitance.h"
#include "reference/geometry.h"
#include "reference/irradiance.h"
#include "reference/run_control.h"
#include "reference/source_tree.h"

namespace opaline::reference {

struct IntegralOptions {
  Transport transport = Transport::Dipole;
  double tolerance = 1e-3;  ///< of B, relative, in [1e-7, 0.5]
  std::stop_token stop;     ///< ends lengthy work while an Integral is made
};

/// The exact surface integral B(x_o) = ∫ E(x_i) R_d(|x_i - x_o|) dA over the body that x_o is on
/// (Jensen et al. 2001, Eq. 4; d'Eon 2012).
class Integral {
 public:
  /// Finds E all over the surface. Throws UsageError for options out of range, and Stopped.
  Integral(const Geometry& geometry, const Irradiance& irradiance, const IntegralOptions& options);

  /// B at a point of a medium's surface. Thread-safe. The error is a bound on what the summation
  /// leaves out, plus an estimate of the errors from interpolating E and from the borders of
  /// shadows.
  Exitance at(const SurfacePoint& point) const;

  /// The total over all bodies.
  std::size_t patchCount() const;

 private:
  struct BodySources {
    std::array<Kernel, 3> kernels;
    double depthMm;
    Colour negligible;  ///< of B
    SourceTree tree;
  };

  std::vector<std::optional<BodySources>> bodies_;  ///< none for opaque bodies
  double tolerance_;
};

}  // namespace opaline::reference

#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/coefficients.comp.h"
#include "shaders/boundary/densities.comp.h"
#include "shaders/boundary/exitance.comp.h"
#include "shaders/boundary/further_bounces.comp.h"
#include "shaders/boundary/product.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Solves the boundary's equation for the fluence at clusters by generalised minimal residuals
/// (Saad and Schultz 1986), entirely on the device, where it stops once the residual is small
/// enough. Then it turns the fluence into exitance.
class SolverPass {
 public:
  explicit SolverPass(gpu::Device& device);

  /// For set-up, not for frames.
  static Solver makeSolver(gpu::Device& device, const Clusters& clusters, std::uint32_t solutions);

  /// Makes room for the operator's coefficients. For set-up too.
  static void makeCoefficients(gpu::Device& device, const Clusters& clusters, Solver& solver);

  struct Order {
    std::uint32_t solution = 0;      ///< the solver's state that records how it went
    std::uint32_t steps = 8;         ///< at most, up to shared::maxSolverSteps
    float openingAngle;              ///< of nodes: taken from further than their radius over this
    float tolerance = 0.01F;         ///< of the residual, relative to the sources
    bool adds = false;               ///< adds to the exitance of light that entered before
    bool isDiffuse = false;          ///< some of the light is in clusters.entered
    bool keepsCoefficients = false;  ///< recordCoefficients() was called for this shape
  };
  /// Records the operator's coefficients, which hold for all solutions until the shape changes.
  /// After ClusterPass::recordShape().
  void recordCoefficients(gpu::CommandList& commands, float openingAngle, SceneTables& tables,
                          Clusters& clusters, Solver& solver) const;

  /// Solves from clusters.sources to clusters.latest and clusters.exitances.
  void record(gpu::CommandList& commands, const Order& order, SceneTables& tables,
              Clusters& clusters, Solver& solver) const;

  /// Adds the light of further bounces, extrapolated from the last two. Has to be called after the
  /// solution of the last but one and after that of the last.
  enum class Bounce : std::uint8_t { LastButOne, Last };
  void recordFurtherBounces(gpu::CommandList& commands, Bounce bounce, SceneTables& tables,
                            Clusters& clusters) const;

 private:
  enum class Of : std::uint8_t { Basis, Entered };
  void findDensities(gpu::CommandList& commands, const Order& order, Of of, SceneTables& tables,
                     Clusters& clusters, Solver& solver) const;
  void multiply(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                SceneTables& tables, Clusters& clusters, Solver& solver) const;

  /// Variants without code for paint, or for linings, if the scene has none.
  struct Pipelines {
    Variants<shaders::BoundaryDensities> densities;
    Variants<shaders::BoundaryProduct> product;
    gpu::Compute<shaders::BoundaryProduct> productOfSeveralMedia;  ///< with linings or without
    gpu::Compute<shaders::BoundaryExitance> exitance;
  };
  static Pipelines makePipelines(gpu::Device& device, bool withPaint);
  const Pipelines& pipelines(const SceneTables& tables) const {
    return tables.paint.any ? painted_ : plain_;
  }

  Variants<shaders::BoundaryCoefficients> coefficients_;  ///< indexed by bodies of several media
  Pipelines plain_;
  Pipelines painted_;
  gpu::Compute<shaders::BoundaryFurtherBounces> powerOfLastButOne_;
  Variants<shaders::BoundaryFurtherBounces> furtherBounces_;
};

}  // namespace opaline::passes

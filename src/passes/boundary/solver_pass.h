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
/// (Saad and Schultz 1986), on the device alone: it stops by itself once the residual is small
/// enough. Then turns the fluence into what leaves.
class SolverPass {
 public:
  explicit SolverPass(gpu::Device& device);

  /// For set-up, not for frames.
  static Solver makeSolver(gpu::Device& device, const Clusters& clusters, std::uint32_t solutions);

  /// Room for the operator's coefficients. For set-up too.
  static void makeCoefficients(gpu::Device& device, const Clusters& clusters, Solver& solver);

  struct Order {
    std::uint32_t solution = 0;      ///< which of the solver's states tells how it went
    std::uint32_t steps = 8;         ///< at most, up to shared::maxSolverSteps
    float openingAngle;              ///< of nodes: taken from further than their radius over this
    float tolerance = 0.01F;         ///< of the residual, relative to the sources
    bool adds = false;               ///< to the exitance of light that entered before
    bool isDiffuse = false;          ///< some of the light is what clusters.entered tells
    bool keepsCoefficients = false;  ///< recordCoefficients() has been there for this shape
  };
  /// The operator's coefficients, for all solutions until the shape changes. After
  /// ClusterPass::recordShape().
  void recordCoefficients(gpu::CommandList& commands, float openingAngle, SceneTables& tables,
                          Clusters& clusters, Solver& solver) const;

  /// From clusters.sources to clusters.latest and clusters.exitances.
  void record(gpu::CommandList& commands, const Order& order, SceneTables& tables,
              Clusters& clusters, Solver& solver) const;

  /// Adds what further bounces would, as far as the last two tell. Of the last but one, then of the
  /// last, each after its solution.
  enum class Bounce : std::uint8_t { LastButOne, Last };
  void recordFurtherBounces(gpu::CommandList& commands, Bounce bounce, SceneTables& tables,
                            Clusters& clusters) const;

 private:
  enum class Of : std::uint8_t { Basis, Entered };
  void findDensities(gpu::CommandList& commands, const Order& order, Of of, SceneTables& tables,
                     Clusters& clusters, Solver& solver) const;
  void multiply(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                SceneTables& tables, Clusters& clusters, Solver& solver) const;

  /// Where nothing is painted, or no body has a lining, the shaders have no code for it.
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

  Variants<shaders::BoundaryCoefficients> coefficients_;  ///< of one medium, or several
  Pipelines plain_;
  Pipelines painted_;
  gpu::Compute<shaders::BoundaryFurtherBounces> powerOfLastButOne_;
  Variants<shaders::BoundaryFurtherBounces> furtherBounces_;
};

}  // namespace opaline::passes

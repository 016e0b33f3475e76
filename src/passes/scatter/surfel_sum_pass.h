#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/scatter/all.comp.h"
#include "shaders/scatter/all_vertices.comp.h"
#include "shaders/scatter/tree.comp.h"
#include "shaders/scatter/tree_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Scattering in object space: exitance of visible fragments or of vertices from the surfels, by
/// their tree or one by one.
class SurfelSumPass {
 public:
  explicit SurfelSumPass(gpu::Device& device);

  struct Order {
    ScatterTransport transport = ScatterTransport::Dipole;
    ScatterSite site = ScatterSite::PerObject;
    float tolerance = 0.01F;  ///< for the tree: error of a node relative to the sum
    /// Whether the tolerance needs an estimate of the sum. Without it a node is taken wherever its
    /// series converges, with an rms error of 0.6 % (marble bunny).
    bool estimate = true;
  };
  struct OverPlaces {
    SceneTables& tables;
    Surfels& surfels;
    Places places;
  };
  struct Fragments {
    SceneTables& tables;
    Surfels& surfels;
    SeenSurfaces seen;
    Exitance& exitance;
    Asked asked = Asked::Knots;
  };

  /// Makes a rough sum at all places, then one to the tolerance at places whose site this is.
  void treeOverPlaces(gpu::CommandList& commands, const Order& order, const OverPlaces& over) const;
  /// After treeOverPlaces at the vertices.
  void treeOverFragments(gpu::CommandList& commands, const Order& order,
                         const Fragments& over) const;
  void allOverPlaces(gpu::CommandList& commands, const Order& order, const OverPlaces& over) const;
  void allOverFragments(gpu::CommandList& commands, const Order& order,
                        const Fragments& over) const;

 private:
  /// Pipelines of a walk through the tree. Coarse surfels always need the estimate.
  template <typename Shader>
  struct WhereEstimated {
    gpu::Compute<Shader> without;
    Variants<Shader> with;  ///< without and with coarse surfels

    const gpu::Compute<Shader>& of(bool estimate, bool coarse) const {
      return estimate ? with.of(coarse) : without;
    }
  };
  struct Pipelines {
    gpu::Compute<shaders::ScatterTreeVertices> roughVertices;
    WhereEstimated<shaders::ScatterTreeVertices> treeVertices;
    WhereEstimated<shaders::ScatterTree> treeFragments;
    gpu::Compute<shaders::ScatterAllVertices> allVertices;
    gpu::Compute<shaders::ScatterAll> allFragments;
  };
  static Pipelines makePipelines(gpu::Device& device, ScatterTransport transport);
  const Pipelines& pipelines(ScatterTransport transport) const {
    return transport == ScatterTransport::Dipole ? dipole_ : betterDipole_;
  }

  gpu::Sampler nearest_;
  Pipelines dipole_;
  Pipelines betterDipole_;
};

}  // namespace opaline::passes

#pragma once

#include "gpu/pipeline.h"
#include "passes/products.h"

namespace opaline::passes {

/// Pipelines of a shader without code for paint, and with it where something is painted.
template <typename Shader>
struct PaintVariants {
  gpu::Compute<Shader> plain;
  gpu::Compute<Shader> painted;

  const gpu::Compute<Shader>& of(const SceneTables& tables) const {
    return tables.paint.any ? painted : plain;
  }
};

}  // namespace opaline::passes

#pragma once

#include "gpu/pipeline.h"

namespace opaline::passes {

/// Pipelines of a shader without code for something that most scenes do not have, and with it.
template <typename Shader>
struct Variants {
  gpu::Compute<Shader> without;
  gpu::Compute<Shader> with;

  const gpu::Compute<Shader>& of(bool has) const { return has ? with : without; }
};

}  // namespace opaline::passes

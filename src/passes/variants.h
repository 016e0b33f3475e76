#pragma once

#include "gpu/pipeline.h"

namespace opaline::passes {

/// Pipelines of a shader without and with code for something that most scenes do not have.
template <typename Shader>
struct Variants {
  gpu::Compute<Shader> without;
  gpu::Compute<Shader> with;

  const gpu::Compute<Shader>& of(bool has) const { return has ? with : without; }
};

/// The same for two such things.
template <typename Shader>
struct VariantsOfTwo {
  Variants<Shader> without;
  Variants<Shader> with;

  const gpu::Compute<Shader>& of(bool hasFirst, bool hasSecond) const {
    return (hasFirst ? with : without).of(hasSecond);
  }
};

/// For three.
template <typename Shader>
struct VariantsOfThree {
  VariantsOfTwo<Shader> without;
  VariantsOfTwo<Shader> with;

  const gpu::Compute<Shader>& of(bool hasFirst, bool hasSecond, bool hasThird) const {
    return (hasFirst ? with : without).of(hasSecond, hasThird);
  }
};

}  // namespace opaline::passes

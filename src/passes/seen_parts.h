#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

/// Dispatches a shader that takes long (lib/seen_list.glsl) for one part of the list of surfaces
/// after the other, whose beginning it sets in the push constants.
template <typename S>
void dispatchParts(gpu::CommandList& commands, VisibleSurfaces& surfaces,
                   const gpu::Compute<S>& pipeline, const typename S::Bindings& bindings,
                   typename S::Push push) {
  commands.use(surfaces.counts, gpu::Access::Indirect);
  commands.bind(pipeline, bindings, push);
  for (std::uint32_t part = 0; part < surfaces.parts; ++part) {
    push.first = part * shared::seenOfPart;
    commands.push(pipeline, push);
    commands.dispatchIndirect(surfaces.counts, (1 + part) * sizeof(shared::SeenCount));
  }
}

}  // namespace opaline::passes

#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

/// Dispatches a shader over a whole list of surfaces (lib/seen_list.glsl) by its counts.
template <typename S>
void dispatchWhole(gpu::CommandList& commands, gpu::Buffer& counts, const gpu::Compute<S>& pipeline,
                   const typename S::Bindings& bindings, const typename S::Push& push = {}) {
  commands.use(counts, gpu::Access::Indirect);
  commands.bind(pipeline, bindings, push);
  commands.dispatchIndirect(counts, 0);
}

/// Dispatches a slow shader for each part of such a list; the push constants contain the part's
/// beginning.
template <typename S>
void dispatchParts(gpu::CommandList& commands, gpu::Buffer& counts, std::uint32_t parts,
                   const gpu::Compute<S>& pipeline, const typename S::Bindings& bindings,
                   typename S::Push push) {
  commands.use(counts, gpu::Access::Indirect);
  commands.bind(pipeline, bindings, push);
  for (std::uint32_t part = 0; part < parts; ++part) {
    push.first = part * shared::seenOfPart;
    commands.push(pipeline, push);
    commands.dispatchIndirect(counts, (1 + part) * sizeof(shared::SeenCount));
  }
}

/// The same for all surfaces.
template <typename S>
void dispatchParts(gpu::CommandList& commands, VisibleSurfaces& surfaces,
                   const gpu::Compute<S>& pipeline, const typename S::Bindings& bindings,
                   const typename S::Push& push) {
  dispatchParts(commands, surfaces.counts, surfaces.parts, pipeline, bindings, push);
}

/// The same for some of them.
template <typename S>
void dispatchAsked(gpu::CommandList& commands, VisibleSurfaces& surfaces, Asked asked,
                   const gpu::Compute<S>& pipeline, const typename S::Bindings& bindings,
                   const typename S::Push& push) {
  dispatchParts(commands, surfaces.countsOf(asked), surfaces.parts, pipeline, bindings, push);
}

}  // namespace opaline::passes

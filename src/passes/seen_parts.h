#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "passes/products.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

/// Calls `bind(first)` for one part of the list of surfaces after the other, each followed by its
/// dispatch, for shaders that take long (lib/seen_list.glsl).
template <typename Bind>
void forEachPart(gpu::CommandList& commands, VisibleSurfaces& surfaces, const Bind& bind) {
  commands.use(surfaces.counts, gpu::Access::Indirect);
  for (std::uint32_t part = 0; part < surfaces.parts; ++part) {
    bind(part * shared::seenOfPart);
    commands.dispatchIndirect(surfaces.counts, (1 + part) * sizeof(shared::SeenCount));
  }
}

}  // namespace opaline::passes

#include "passes/scatter/interpolation_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

namespace {

// Each work group processes a square of blocks.
void dispatchBlocks(gpu::CommandList& commands, std::uint32_t rows,
                    const VisibleSurfaces& surfaces) {
  constexpr std::uint32_t width = shared::widthOfBlock * shared::blocksOfGroup;
  const auto groups = [](std::uint32_t pixels) { return (pixels + width - 1) / width; };
  commands.dispatch(groups(surfaces.words.extent().width), groups(rows));
}

}  // namespace

InterpolationPass::InterpolationPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      knots_{{device, "surfaces to sum at first", {.withPaint = 0}},
             {device, "surfaces to sum at first", {.withPaint = 1}}},
      interpolate_{{device, "light between sums", {.withPaint = 0}},
                   {device, "light between sums", {.withPaint = 1}}} {}

void InterpolationPass::listKnots(gpu::CommandList& commands, const Inputs& inputs,
                                  std::uint32_t samples, bool interpolates,
                                  const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const std::uint32_t rows = surfaces.rowsFrom(inputs.firstRow);
  commands.beginPass("interpolate");
  commands.bind(knots_.of(inputs.tables.paint.any),
                {.seenPlaces = seenPlaces(seen, nearest_),
                 .meshExitances = inputs.exitance.vertices,
                 .objects = inputs.tables.objects,
                 .surfaces = surfaces.asked,
                 .surfaceCounts = surfaces.countsOf(Asked::Knots),
                 .blocks = surfaces.blocks[0],
                 .exitances = surfaces.light,
                 .paint = surfaces.paint,
                 .media = inputs.tables.media,
                 .entryOfPixel = surfaces.entryOfPixel,
                 .meshOrigins = inputs.exitance.origins,
                 .origins = surfaces.origins},
                {.firstRow = inputs.firstRow,
                 .rows = rows,
                 .site = inputs.site,
                 .interpolates = interpolates,
                 .samples = samples,
                 .keepsOrigins = surfaces.kept.origins});
  dispatchBlocks(commands, rows, surfaces);
  commands.endPass();
}

void InterpolationPass::interpolate(gpu::CommandList& commands, const Inputs& inputs, Blocks blocks,
                                    const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("interpolate");
  const bool wide = blocks == Blocks::Wide;
  const std::uint32_t rows = surfaces.rowsFrom(inputs.firstRow);
  commands.bind(
      interpolate_.of(inputs.tables.paint.any),
      {.seenPlaces = seenPlaces(seen, nearest_),
       .objects = inputs.tables.objects,
       .surfaces = surfaces.asked,
       .surfaceCounts = surfaces.countsOf(wide ? Asked::InWideBlocks : Asked::InNarrowBlocks),
       .nodes = inputs.surfels.nodes,
       .blocks = surfaces.blocks[wide ? 0 : 1],
       .entryOfPixel = surfaces.entryOfPixel,
       .exitances = surfaces.light,
       .paint = surfaces.paint,
       .blocksAfter = surfaces.blocks[wide ? 1 : 0],
       .origins = surfaces.origins},
      {.firstRow = inputs.firstRow,
       .rows = rows,
       .tolerance = inputs.tolerance,
       .wide = wide,
       .keepsOrigins = surfaces.kept.origins});
  dispatchBlocks(commands, rows, surfaces);
  commands.endPass();
}

}  // namespace opaline::passes

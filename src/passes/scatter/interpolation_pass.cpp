#include "passes/scatter/interpolation_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

namespace {

std::uint32_t rowsFrom(std::uint32_t firstRow, const VisibleSurfaces& surfaces) {
  return std::min(surfaces.rowsOfBand, surfaces.words.extent().height - firstRow);
}

std::uint32_t wideBlocksAcross(std::uint32_t pixels) {
  constexpr std::uint32_t width = 2 * shared::widthOfBlock;
  return (pixels + width - 1) / width;
}

}  // namespace

InterpolationPass::InterpolationPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      blocks_(device, "blocks of one surface"),
      knots_{{device, "surfaces to sum at first", {.withPaint = 0}},
             {device, "surfaces to sum at first", {.withPaint = 1}}},
      interpolate_{{device, "light between sums", {.withPaint = 0}},
                   {device, "light between sums", {.withPaint = 1}}} {}

void InterpolationPass::listKnots(gpu::CommandList& commands, const Inputs& inputs,
                                  bool interpolates, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const std::uint32_t rows = rowsFrom(inputs.firstRow, surfaces);
  commands.beginPass("interpolate");
  if (interpolates) {
    commands.bind(blocks_,
                  {.listedPlaces = listedPlaces(seen, nearest_),
                   .objects = inputs.tables.objects,
                   .media = inputs.tables.media,
                   .blocks = surfaces.blocks[0]},
                  {.firstRow = inputs.firstRow, .rows = rows, .site = inputs.site});
    commands.dispatchLinear(wideBlocksAcross(surfaces.words.extent().width) *
                            wideBlocksAcross(rows));
  }
  dispatchWhole(commands, surfaces.counts, knots_.of(inputs.tables.paint.any),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .meshExitances = inputs.exitance.vertices,
                 .objects = inputs.tables.objects,
                 .surfaces = surfaces.asked,
                 .surfaceCounts = surfaces.countsOf(Asked::Knots),
                 .blocks = surfaces.blocks[0],
                 .exitances = surfaces.light,
                 .paint = surfaces.paint},
                {.firstRow = inputs.firstRow,
                 .rows = rows,
                 .site = inputs.site,
                 .interpolates = interpolates});
  commands.endPass();
}

void InterpolationPass::interpolate(gpu::CommandList& commands, const Inputs& inputs, Blocks blocks,
                                    const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("interpolate");
  const bool wide = blocks == Blocks::Wide;
  dispatchWhole(
      commands, surfaces.counts, interpolate_.of(inputs.tables.paint.any),
      {.listedPlaces = listedPlaces(seen, nearest_),
       .objects = inputs.tables.objects,
       .surfaces = surfaces.asked,
       .surfaceCounts = surfaces.countsOf(wide ? Asked::InWideBlocks : Asked::InNarrowBlocks),
       .nodes = inputs.surfels.nodes,
       .blocks = surfaces.blocks[wide ? 0 : 1],
       .entryOfPixel = surfaces.entryOfPixel,
       .exitances = surfaces.light,
       .paint = surfaces.paint,
       .blocksAfter = surfaces.blocks[wide ? 1 : 0]},
      {.firstRow = inputs.firstRow,
       .rows = rowsFrom(inputs.firstRow, surfaces),
       .tolerance = inputs.tolerance,
       .wide = wide});
  commands.endPass();
}

}  // namespace opaline::passes

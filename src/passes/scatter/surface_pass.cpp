#include "passes/scatter/surface_pass.h"

#include <algorithm>
#include <bit>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/raster.h"
#include "shaders/shared/opaque.h"
#include "shaders/shared/seen.h"

namespace opaline::passes {

namespace {

// Room of a band's list in surfaces, unless a single row of tiles needs more. Most pixels see one
// surface or none, so lists are rarely that long. Entries of opaque surfaces are larger.
constexpr std::uint32_t surfacesOfBand = 1U << 22U;
constexpr std::uint32_t surfacesOfOpaqueBand = 1U << 20U;
constexpr std::uint32_t tile = 8;

// The largest number of samples in a picture for which every sample has its own depth, so that none
// waits for another.
constexpr std::uint64_t mostWithDepths = std::uint64_t{1} << 24U;

std::uint32_t depthsOf(VkExtent2D extent, std::uint32_t samples) {
  return std::uint64_t{extent.width} * extent.height * samples <= mostWithDepths ? samples : 1;
}

std::uint32_t tilesFor(std::uint32_t pixels) {
  return (pixels + tile - 1) / tile;
}

std::uint32_t rowsOfBand(VkExtent2D extent, std::uint32_t samples, bool opaque) {
  const std::uint32_t surfaces = opaque ? surfacesOfOpaqueBand : surfacesOfBand;
  const std::uint32_t tiles = surfaces / (extent.width * samples * tile);
  return tile * std::clamp(tiles, 1U, tilesFor(extent.height));
}

constexpr VkFormat formatOfWords = VK_FORMAT_R32_UINT;
constexpr VkFormat formatOfDepth = VK_FORMAT_D32_SFLOAT;
constexpr VkImageUsageFlags usageOfDrawn =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
constexpr VkImageUsageFlags usageOfDepth = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

gpu::GraphicsOptions ofWords(std::uint32_t samples = 1) {
  return {.colorFormats = {formatOfWords},
          .depthFormat = formatOfDepth,
          .depth = gpu::DepthMode::Write,
          .samples = static_cast<VkSampleCountFlagBits>(samples)};
}

// Index of the pipeline that draws several samples at once.
std::size_t pipelineFor(std::uint32_t samples) {
  return static_cast<std::size_t>(std::countr_zero(samples)) - 1;
}

// Whether the device can draw that many samples of a pixel at once, at the places of
// samplePattern().
bool drawsAtOnce(const gpu::Device& device, std::uint32_t samples) {
  const VkSampleCountFlags able = gpu::sampleCountsOf(device, formatOfWords, usageOfDrawn) &
                                  gpu::sampleCountsOf(device, formatOfDepth, usageOfDepth);
  return samples > 1 && device.limits().standardSampleLocations == VK_TRUE && (able & samples) != 0;
}

}  // namespace

SurfacePass::SurfacePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      triangles_(device, "triangles", ofWords()),
      atOnce_{{{device, "triangles of two samples", ofWords(2)},
               {device, "triangles of four samples", ofWords(4)},
               {device, "triangles of eight samples", ofWords(8)}}},
      cutOut_(device, "triangles with holes", ofWords()),
      lights_(device, "visible lights", ofWords()),
      seen_(device, "seen pixels"),
      seenAtOnce_(device, "seen pixels"),
      nearestTriangles_(device, "nearest triangles"),
      seenNearest_(device, "seen pixels"),
      surfaces_(device, "seen surfaces"),
      listed_(device, "list of seen surfaces") {}

VisibleSurfaces SurfacePass::makeSurfaces(gpu::Device& device, VkExtent2D extent,
                                          std::uint32_t samples, KeptOfSeen kept) {
  constexpr VkBufferUsageFlags counted = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                         VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                         VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  VisibleSurfaces made;
  const bool canDraw = kept.drawn && depthsOf(extent, samples) == samples;
  const bool byInvocations = canDraw && device.workGroups().drawTriangles;
  const bool atOnce = canDraw && !byInvocations && drawsAtOnce(device, samples);
  made.words = {device,
                {.name = "seen surfaces",
                 .width = extent.width,
                 .height = extent.height,
                 .layers = samples,
                 .format = formatOfWords,
                 .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                          VK_IMAGE_USAGE_SAMPLED_BIT,
                 .kind = gpu::ImageKind::Array}};
  made.depth = {device,
                {.name = "depth",
                 .width = extent.width,
                 .height = extent.height,
                 .layers = atOnce || byInvocations ? 1 : depthsOf(extent, samples),
                 .format = formatOfDepth,
                 .usage = usageOfDepth,
                 .kind = gpu::ImageKind::Array}};
  if (atOnce) {
    const auto ofSamples = [&](const char* name, VkFormat format, VkImageUsageFlags usage) {
      return gpu::GpuImage(device, {.name = name,
                                    .width = extent.width,
                                    .height = extent.height,
                                    .format = format,
                                    .usage = usage,
                                    .samples = static_cast<VkSampleCountFlagBits>(samples)});
    };
    made.drawn = ofSamples("triangles of samples", formatOfWords, usageOfDrawn);
    made.drawnDepth = ofSamples("depth of samples", formatOfDepth, usageOfDepth);
  }
  if (byInvocations) {
    const auto ofSamples = [&](const char* name) {
      return gpu::Buffer(
          device,
          {.name = name,
           .bytes = std::size_t{extent.width} * extent.height * samples * sizeof(std::uint32_t),
           .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
    };
    made.nearest = ofSamples("nearest triangles of samples");
    made.nearestDepth = ofSamples("depth of samples");
  }
  made.rowsOfBand = rowsOfBand(extent, samples, kept.materials);
  const std::uint32_t pixels = extent.width * made.rowsOfBand;
  // Whole tiles, because a work group fills up its last subgroup.
  const std::uint32_t room = tile * tilesFor(extent.width) * made.rowsOfBand * samples;
  made.parts = (room + shared::seenOfPart - 1) / shared::seenOfPart;
  made.mixed = makeRoom<std::uint32_t>(device, "pixels of several triangles", pixels);
  made.mixedCount = {device,
                     {.name = "number of pixels of several triangles",
                      .bytes = sizeof(shared::SeenCount),
                      .usage = counted}};
  made.list = makeRoom<std::uint32_t>(device, "list of seen surfaces", room);
  const auto countsOfParts = [&](const char* name) {
    return gpu::Buffer(
        device,
        {.name = name, .bytes = (1 + made.parts) * sizeof(shared::SeenCount), .usage = counted});
  };
  made.counts = countsOfParts("number of seen surfaces");
  made.light = makeRoom<shared::vec4>(device, "light of seen surfaces", room);
  made.skyShares = makeRoom<float>(device, "shares of reflected sky", room);
  made.materials = makeRoom<shared::SeenMaterial>(device, "materials of seen surfaces",
                                                  kept.materials ? room : 0);
  made.paint = makeRoom<shared::vec4>(device, "paint of seen surfaces", kept.paint ? room : 0);
  made.origins =
      makeRoom<shared::vec4>(device, "origins of light of seen surfaces", kept.origins ? room : 0);
  for (gpu::Buffer& found : made.ofPixels)
    found = makeRoom<shared::vec4>(device, "what pixels have found", kept.ofPixels ? pixels : 0);
  made.kept = kept;
  made.skyBlocks = {device,
                    {.name = "blocks of reflected sky",
                     .width = (extent.width + 1) / 2,
                     .height = (extent.height + 1) / 2,
                     .format = VK_FORMAT_R32_SFLOAT,
                     .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}};
  made.entryOfPixel = makeRoom<std::uint32_t>(device, "first surfaces of pixels", pixels);
  constexpr std::uint32_t across = shared::widthOfBlock;
  for (gpu::Buffer& blocks : made.blocks)
    blocks = makeRoom<std::uint32_t>(device, "blocks of one surface",
                                     std::size_t{(extent.width + across - 1) / across} *
                                         ((made.rowsOfBand + across - 1) / across));
  made.asked = makeRoom<std::uint32_t>(device, "list of surfaces asked", room);
  for (gpu::Buffer& counts : made.askedCounts) counts = countsOfParts("number of surfaces asked");
  return made;
}

void SurfacePass::bindCutOut(gpu::CommandList& commands, const SeenSurfaces& seen,
                             const CutOuts& cutOuts, shared::vec2 jitter) const {
  commands.bind(cutOut_,
                {.frame = seen.frame.data,
                 .indices = seen.mesh.indices,
                 .positions = seen.mesh.positions,
                 .vertexAttributes = cutOuts.opaque.attributes,
                 .objectOf = seen.mesh.objectOf},
                {.surfaceMaterials = surfaceMaterials(cutOuts.opaque),
                 .objects = cutOuts.tables.objects,
                 .media = cutOuts.tables.media},
                {.jitter = jitter});
}

void SurfacePass::drawSample(gpu::CommandList& commands, const SeenSurfaces& seen,
                             const CutOuts& cutOuts, std::uint32_t sample, shared::vec2 place,
                             bool visibleLights) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const VkExtent2D extent = surfaces.words.extent();
  const shared::vec2 pixel(2 / static_cast<float>(extent.width),
                           2 / static_cast<float>(extent.height));
  const gpu::DepthTarget depth{.image = &surfaces.depth,
                               .layer = sample % surfaces.depth.options().layers};
  const shared::vec2 jitter = -place * pixel;
  // What it reads is ordered before the drawing begins.
  if (!seen.mesh.cutOut.empty()) bindCutOut(commands, seen, cutOuts, jitter);
  commands.bind(
      triangles_,
      {.frame = seen.frame.data, .indices = seen.mesh.indices, .positions = seen.mesh.positions},
      {}, {.jitter = jitter});
  commands.beginRendering({{.image = &surfaces.words, .layer = sample}}, &depth);
  for (const IndexRange& range : seen.mesh.whole) commands.draw(range.count, range.first);
  if (!seen.mesh.cutOut.empty()) bindCutOut(commands, seen, cutOuts, jitter);
  for (const IndexRange& range : seen.mesh.cutOut) commands.draw(range.count, range.first);
  if (visibleLights) {
    commands.bind(lights_, {}, {.frame = seen.frame.data},
                  {.size = shared::vec2(extent.width, extent.height), .offset = place});
    commands.draw(3);
  }
  commands.endRendering();
}

void SurfacePass::drawAtOnce(gpu::CommandList& commands, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const gpu::DepthTarget depth{.image = &surfaces.drawnDepth};
  commands.bind(
      atOnce_[pipelineFor(surfaces.drawn.options().samples)],
      {.frame = seen.frame.data, .indices = seen.mesh.indices, .positions = seen.mesh.positions},
      {}, {.jitter = shared::vec2(0, 0)});
  commands.beginRendering({{.image = &surfaces.drawn}}, &depth);
  for (const IndexRange& range : seen.mesh.whole) commands.draw(range.count, range.first);
  commands.endRendering();
}

void SurfacePass::drawByInvocations(gpu::CommandList& commands, const SeenSurfaces& seen,
                                    std::uint32_t samples) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const VkExtent2D extent = surfaces.words.extent();
  const std::uint32_t triangles = seen.mesh.indexCount / 3;
  const RasterBands bands = rasterBands(triangles, extent.height);
  commands.fill({surfaces.nearest, surfaces.nearestDepth}, 0);
  for (const std::uint32_t findsTriangles : {0U, 1U}) {
    commands.bind(nearestTriangles_,
                  {.frame = seen.frame.data,
                   .indices = seen.mesh.indices,
                   .positions = seen.mesh.positions,
                   .depths = surfaces.nearestDepth,
                   .triangles = surfaces.nearest},
                  {.width = extent.width,
                   .height = extent.height,
                   .samples = samples,
                   .triangleCount = triangles,
                   .rowsOfBand = bands.rows,
                   .findsTriangles = findsTriangles});
    commands.dispatch(bands.groups, bands.count);
  }
}

void SurfacePass::draw(gpu::CommandList& commands, const SeenSurfaces& seen, const CutOuts& cutOuts,
                       std::span<const shared::vec2> samples, Beside beside) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  // Holes, lights and a backdrop have to be tested for every sample.
  const auto count = static_cast<std::uint32_t>(samples.size());
  surfaces.drawnAtOnce =
      (surfaces.nearest || (surfaces.drawn && surfaces.drawn.options().samples == count)) &&
      !beside.backdrop && seen.mesh.cutOut.empty();
  commands.beginPass("surface");
  if (surfaces.drawnAtOnce && surfaces.nearest) {
    drawByInvocations(commands, seen, count);
  } else if (surfaces.drawnAtOnce) {
    drawAtOnce(commands, seen);
  } else {
    for (std::uint32_t sample = 0; sample < samples.size(); ++sample)
      drawSample(commands, seen, cutOuts, sample, samples[sample], beside.lights);
  }
  commands.endPass();
}

// Binds the shader that lists pixels of several triangles.
void SurfacePass::bindSeen(gpu::CommandList& commands, const SeenSurfaces& seen,
                           std::uint32_t firstRow, std::uint32_t samples) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  if (surfaces.drawnAtOnce && surfaces.nearest)
    commands.bind(seenNearest_,
                  {.words = surfaces.words,
                   .mixed = surfaces.mixed,
                   .mixedCount = surfaces.mixedCount,
                   .triangles = surfaces.nearest},
                  {.samples = samples, .firstRow = firstRow});
  else if (surfaces.drawnAtOnce)
    commands.bind(seenAtOnce_,
                  {.words = surfaces.words,
                   .mixed = surfaces.mixed,
                   .mixedCount = surfaces.mixedCount,
                   .drawn = {surfaces.drawn, nearest_}},
                  {.samples = samples, .firstRow = firstRow});
  else
    commands.bind(
        seen_,
        {.words = surfaces.words, .mixed = surfaces.mixed, .mixedCount = surfaces.mixedCount},
        {.samples = samples, .firstRow = firstRow});
}

void SurfacePass::list(gpu::CommandList& commands, const SeenSurfaces& seen, std::uint32_t firstRow,
                       std::uint32_t samples) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const VkExtent2D extent = surfaces.words.extent();
  const std::uint32_t rows = surfaces.rowsFrom(firstRow);
  commands.beginPass("surface");
  commands.fill({surfaces.counts, surfaces.mixedCount, surfaces.countsOf(Asked::Knots),
                 surfaces.countsOf(Asked::InWideBlocks), surfaces.countsOf(Asked::InNarrowBlocks),
                 surfaces.countsOf(Asked::OfSky)},
                0);
  const auto dispatchTiles = [&] { commands.dispatch(tilesFor(extent.width), tilesFor(rows)); };
  bindSeen(commands, seen, firstRow, samples);
  dispatchTiles();
  if (samples > 1) {
    commands.use(surfaces.mixedCount, gpu::Access::Indirect);
    commands.bind(surfaces_,
                  {.frame = seen.frame.data,
                   .words = surfaces.words,
                   .mixed = surfaces.mixed,
                   .mixedCount = surfaces.mixedCount,
                   .meshIndices = seen.mesh.indices,
                   .positions = seen.mesh.positions,
                   .normals = seen.mesh.normals,
                   .meshObjects = seen.mesh.objectOf},
                  {.samples = samples});
    commands.dispatchIndirect(surfaces.mixedCount, 0);
  }
  commands.bind(listed_,
                {.words = {surfaces.words, nearest_},
                 .surfaces = surfaces.list,
                 .surfaceCounts = surfaces.counts,
                 .entryOfPixel = surfaces.entryOfPixel},
                {.samples = samples, .firstRow = firstRow});
  dispatchTiles();
  commands.endPass();
}

void SurfacePass::askAnew(gpu::CommandList& commands, VisibleSurfaces& surfaces) {
  commands.beginPass("surface");
  commands.fill({surfaces.countsOf(Asked::Knots), surfaces.countsOf(Asked::InWideBlocks),
                 surfaces.countsOf(Asked::InNarrowBlocks)},
                0);
  commands.endPass();
}

}  // namespace opaline::passes

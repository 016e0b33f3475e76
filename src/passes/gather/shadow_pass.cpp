#include "passes/gather/shadow_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/raster.h"

namespace opaline::passes {

namespace {

std::size_t bytesOfMap(std::uint32_t size) {
  return std::size_t{size} * size * sizeof(float);
}

gpu::GraphicsOptions ofDepth() {
  return {.depthFormat = VK_FORMAT_D32_SFLOAT, .depth = gpu::DepthMode::Write};
}

// The most memory for maps that invocations draw before they are copied.
constexpr std::size_t mostDrawnBytes = std::size_t{64} << 20U;

}  // namespace

ShadowPass::ShadowPass(gpu::Device& device)
    : pipeline_(device, "shadow", ofDepth()),
      cutOut_(device, "shadow with holes", ofDepth()),
      depths_(device, "depths of shadow maps") {}

ShadowMaps ShadowPass::makeMaps(gpu::Device& device, std::uint32_t size, std::uint32_t views,
                                bool cutOut) {
  ShadowMaps made;
  made.cutOut = cutOut;
  const std::size_t bytes = bytesOfMap(size);
  const std::size_t most =
      std::min(mostDrawnBytes, std::size_t{device.limits().maxStorageBufferRange});
  const bool drawn = device.workGroups().drawTriangles && views > 0 && !cutOut && bytes <= most;
  VkImageUsageFlags usage =
      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  if (drawn) usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  made.depth = {device,
                {.name = "shadow maps",
                 .width = size,
                 .height = size,
                 .layers = std::max(views, 1U),
                 .format = VK_FORMAT_D32_SFLOAT,
                 .usage = usage,
                 .kind = gpu::ImageKind::Array}};
  if (!drawn) return made;
  made.roomForViews = static_cast<std::uint32_t>(std::min<std::size_t>(most / bytes, views));
  made.drawn = {device,
                {.name = "depths of shadow maps",
                 .bytes = made.roomForViews * bytes,
                 .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                          VK_BUFFER_USAGE_TRANSFER_DST_BIT}};
  return made;
}

// Draws several views at once, as many as there is room for.
void ShadowPass::recordByInvocations(gpu::CommandList& commands, FrameView& frame,
                                     DeformedMesh& mesh, const ShadowViews& wanted,
                                     ShadowMaps& maps) const {
  const std::uint32_t size = maps.depth.extent().width;
  const std::uint32_t triangles = mesh.castingIndexCount / 3;
  const RasterBands bands = rasterBands(triangles, size);
  for (std::uint32_t first = 0; first < wanted.size();) {
    std::uint32_t views = 0;
    while (views < maps.roomForViews && first + views < wanted.size() && wanted[first + views])
      ++views;
    if (views == 0) {
      ++first;
      continue;
    }
    commands.fill({maps.drawn}, 0);
    commands.bind(depths_,
                  {.frame = frame.data,
                   .indices = mesh.indices,
                   .positions = mesh.positions,
                   .depths = maps.drawn},
                  {.triangleCount = triangles, .firstView = first, .rowsOfBand = bands.rows});
    commands.dispatch(bands.groups, bands.count, views);
    for (std::uint32_t view = 0; view < views; ++view)
      commands.copyToImage(maps.drawn, maps.depth, first + view, 0, view * bytesOfMap(size));
    first += views;
  }
}

void ShadowPass::bindCutOut(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                            const CutOuts& cutOuts, std::uint32_t view) const {
  commands.bind(cutOut_,
                {.frame = frame.data,
                 .positions = mesh.positions,
                 .vertexAttributes = cutOuts.opaque.attributes,
                 .objectOf = mesh.objectOf},
                {.surfaceMaterials = surfaceMaterials(cutOuts.opaque),
                 .objects = cutOuts.tables.objects,
                 .media = cutOuts.tables.media},
                {.view = view});
}

void ShadowPass::record(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                        const CutOuts& cutOuts, const ShadowViews& views, ShadowMaps& maps) const {
  if (views.none()) return;
  commands.beginPass("shadow");
  if (maps.drawn)
    recordByInvocations(commands, frame, mesh, views, maps);
  else
    draw(commands, frame, mesh, cutOuts, views, maps);
  commands.endPass();
}

void ShadowPass::draw(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                      const CutOuts& cutOuts, const ShadowViews& views, ShadowMaps& maps) const {
  commands.use(mesh.indices, gpu::Access::Index);
  for (std::uint32_t view = 0; view < views.size(); ++view) {
    if (!views[view]) continue;
    // Bound before drawing begins, because barriers cannot stand inside.
    if (!mesh.cutOut.empty()) bindCutOut(commands, frame, mesh, cutOuts, view);
    commands.bind(pipeline_, {.frame = frame.data, .positions = mesh.positions}, {},
                  {.view = view});
    const gpu::DepthTarget depth{.image = &maps.depth, .layer = view};
    commands.beginRendering({}, &depth);
    for (const IndexRange& range : mesh.whole) {
      if (range.first >= mesh.castingIndexCount) continue;
      commands.drawIndexed(
          mesh.indices, std::min(range.count, mesh.castingIndexCount - range.first), range.first);
    }
    if (!mesh.cutOut.empty()) bindCutOut(commands, frame, mesh, cutOuts, view);
    for (const IndexRange& range : mesh.cutOut)
      commands.drawIndexed(mesh.indices, range.count, range.first);
    commands.endRendering();
  }
}

}  // namespace opaline::passes

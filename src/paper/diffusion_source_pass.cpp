#include "paper/diffusion_source_pass.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "paper/nearest_texel.h"
#include "shaders/shared/frame.h"

namespace opaline::paper {

namespace {

gpu::GpuImage makeMap(gpu::Device& device, const char* name, std::uint32_t size, VkFormat format) {
  return {device,
          {.name = name,
           .width = size,
           .height = size,
           .format = format,
           .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

gpu::GpuImage makeCoverage(gpu::Device& device, std::uint32_t size) {
  return {device,
          {.name = "dsm coverage",
           .width = size,
           .height = size,
           .format = VK_FORMAT_R32_UINT,
           .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

// A texel is drawn all or not at all, by its centre. Drawn texels at a border also stand for the
// surface in those around it that are not drawn: area and its centroid (offset in texels) are
// exact, wherever charts end.
std::vector<shared::vec4> surfaceOfTexels(std::span<const atlas::TexelArea> areas,
                                          std::span<const std::uint32_t> coverage,
                                          std::span<const std::uint32_t> nearestCovered,
                                          std::uint32_t size) {
  std::vector<shared::vec4> surface(areas.size(), shared::vec4(0));
  for (std::uint32_t i = 0; i < areas.size(); ++i) {
    const std::uint32_t to = nearestCovered[i];
    if (!(areas[i].area > 0) || coverage[to] == 0) continue;
    const float dx = static_cast<float>(i % size) - static_cast<float>(to % size);
    const std::uint32_t row = i / size;
    const std::uint32_t toRow = to / size;
    const float dy = static_cast<float>(row) - static_cast<float>(toRow);
    surface[to] += shared::vec4(areas[i].moment[0] + areas[i].area * dx,
                                areas[i].moment[1] + areas[i].area * dy, areas[i].area, 0);
  }
  for (shared::vec4& texel : surface)
    if (texel.z > 0) {
      texel.x /= texel.z;
      texel.y /= texel.z;
    }
  return surface;
}

// The highest bit of an origin; the others hold x and y, 15 bits each.
constexpr std::uint32_t surfaceBit = 1U << 31U;

std::uint32_t packOrigin(std::uint32_t index, std::uint32_t size) {
  return index % size | ((index / size) << 15U);
}

// For every texel of the neighbourhoods, the texel of the map that holds its data. The
// neighbourhoods may be coarser than the map: their atlas has an edge of `atlasSize` texels. What
// lies beyond the surface takes the position of the nearest texel and no area.
std::vector<std::uint32_t> listOrigins(const atlas::Neighbourhoods& neighbourhoods,
                                       std::uint32_t atlasSize,
                                       std::span<const std::uint32_t> nearestCovered,
                                       std::uint32_t mapSize) {
  std::vector<std::uint32_t> present(neighbourhoods.source.size());
  std::transform(
      neighbourhoods.source.begin(), neighbourhoods.source.end(), present.begin(),
      [](std::uint32_t texel) { return texel == atlas::Neighbourhoods::nothing ? 0U : 1U; });
  const std::vector<std::uint32_t> nearest =
      nearestCoveredTexel(present, static_cast<std::uint32_t>(neighbourhoods.size));
  // The middle of a coarse texel.
  const auto fine = [&](std::uint32_t coarse) {
    return (2 * coarse + 1) * mapSize / (2 * atlasSize);
  };
  std::vector<std::uint32_t> origins(present.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const std::uint32_t texel = neighbourhoods.source[nearest[i]];
    if (texel == atlas::Neighbourhoods::nothing) continue;
    const std::size_t inMap =
        std::size_t{fine(texel / atlasSize)} * mapSize + fine(texel % atlasSize);
    origins[i] = packOrigin(nearestCovered[inMap], mapSize) | (present[i] != 0 ? surfaceBit : 0U);
  }
  return origins;
}

std::vector<shared::ChartPlace> chartPlaces(const atlas::Neighbourhoods& neighbourhoods,
                                            std::uint32_t mapSize) {
  const auto size = static_cast<float>(neighbourhoods.size);
  std::vector<shared::ChartPlace> places;
  for (const std::array<int, 2>& shift : neighbourhoods.shiftOfChart)
    places.push_back({.shiftU = static_cast<float>(shift[0]) / size,
                      .shiftV = static_cast<float>(shift[1]) / size,
                      .scale = static_cast<float>(mapSize) / size});
  return places;
}

}  // namespace

DiffusionSourcePass::DiffusionSourcePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      coverage_(device, "dsm coverage", {.colorFormats = {VK_FORMAT_R32_UINT}}),
      map_(device, "dsm",
           {.colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                             VK_FORMAT_R32G32B32A32_SFLOAT}}),
      occlude_(device, "ambient occlusion of the map"),
      neighbours_(device, "neighbourhoods"),
      cells_(device, "cells") {}

DiffusionSources DiffusionSourcePass::prepare(gpu::Device& device, passes::DeformedMesh& mesh,
                                              FlatScene& flat, const AtlasMaps& maps) const {
  const auto mapSize = static_cast<std::uint32_t>(flat.mapSize);
  DiffusionSources sources;
  sources.positionArea =
      makeMap(device, "dsm position and area", mapSize, VK_FORMAT_R32G32B32A32_SFLOAT);
  sources.normal = makeMap(device, "dsm normal", mapSize, VK_FORMAT_R16G16B16A16_SFLOAT);
  sources.irradianceObject =
      makeMap(device, "dsm irradiance", mapSize, VK_FORMAT_R32G32B32A32_SFLOAT);
  sources.coverage = makeCoverage(device, mapSize);

  gpu::CommandList commands(device, "dsm coverage");
  commands.begin();
  commands.use(flat.indices, gpu::Access::Index);
  commands.bind(coverage_,
                {.positions = mesh.positions, .normals = mesh.normals, .corners = flat.corners},
                {});
  commands.beginRendering({{.image = &sources.coverage}});
  commands.drawIndexed(flat.indices, flat.indexCount);
  commands.endRendering();
  commands.submit();

  const std::vector<std::byte> bytes =
      gpu::readImage(device, sources.coverage, sizeof(std::uint32_t));
  std::vector<std::uint32_t> coverage(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(coverage.data(), bytes.data(), bytes.size());

  sources.sourceCount = static_cast<std::uint32_t>(
      coverage.size() - static_cast<std::size_t>(std::count(coverage.begin(), coverage.end(), 0U)));
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  sources.charts = gpu::makeBuffer(device, "charts", chartPlaces(maps.nearby, mapSize), storage);
  const std::vector<std::uint32_t> covered = nearestCoveredTexel(coverage, mapSize);
  const std::vector<shared::vec4> surface =
      surfaceOfTexels(maps.texelAreas, coverage, covered, mapSize);
  sources.texelSurface = gpu::GpuImage(
      device, {.name = "dsm surface of texels",
               .width = mapSize,
               .height = mapSize,
               .format = VK_FORMAT_R32G32B32A32_SFLOAT,
               .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  gpu::uploadImage(device, sources.texelSurface,
                   std::as_bytes(std::span<const shared::vec4>(surface)));
  sources.nearOrigins =
      gpu::makeBuffer(device, "origins of near texels",
                      listOrigins(maps.nearby, mapSize, covered, mapSize), storage);
  sources.farOrigins =
      gpu::makeBuffer(device, "origins of far texels",
                      listOrigins(maps.distant, maps.distantMapSize, covered, mapSize), storage);
  const auto nearSize = static_cast<std::uint32_t>(maps.nearby.size);
  const std::uint32_t cells = static_cast<std::uint32_t>(maps.distant.size) / maps.cellEdge;
  sources.cellEdge = maps.cellEdge;
  constexpr VkFormat floats = VK_FORMAT_R32G32B32A32_SFLOAT;
  sources.nearPosition = makeMap(device, "neighbourhoods' position", nearSize, floats);
  sources.nearFlux = makeMap(device, "neighbourhoods' flux", nearSize, floats);
  sources.farPosition = makeMap(device, "cells' position", cells, floats);
  sources.farFlux = makeMap(device, "cells' flux", cells, floats);
  sources.farPlaces = gpu::makeBuffer(device, "far places", maps.farPlaces, storage);
  return sources;
}

void DiffusionSourcePass::record(gpu::CommandList& commands, const Inputs& inputs,
                                 DiffusionSources& sources) const {
  commands.beginPass("gather");
  recordMap(commands, inputs, sources);
  if (inputs.occlusion != nullptr) occlude(commands, inputs, sources);
  commands.endPass();
  commands.beginPass("neighbours");
  recordNeighbours(commands, sources);
  commands.endPass();
}

void DiffusionSourcePass::recordMap(gpu::CommandList& commands, const Inputs& inputs,
                                    DiffusionSources& sources) const {
  passes::DeformedMesh& mesh = inputs.mesh;
  FlatScene& flat = inputs.flat;
  commands.use(flat.indices, gpu::Access::Index);
  commands.bind(map_,
                {.positions = mesh.positions, .normals = mesh.normals, .corners = flat.corners},
                {.frame = inputs.frame.data,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .skyIrradiance = {inputs.sky.irradiance, linear_},
                 .texelSurface = {sources.texelSurface, nearest_}});
  commands.beginRendering({{.image = &sources.positionArea},
                           {.image = &sources.normal},
                           {.image = &sources.irradianceObject}});
  commands.drawIndexed(flat.indices, flat.indexCount);
  commands.endRendering();
}

void DiffusionSourcePass::occlude(gpu::CommandList& commands, const Inputs& inputs,
                                  DiffusionSources& sources) const {
  passes::Clusters& clusters = *inputs.occlusion;
  commands.bind(occlude_, {.objects = inputs.tables.objects,
                           .media = inputs.tables.media,
                           .skyIrradiance = {inputs.sky.irradiance, linear_},
                           .clusterNodes = clusters.nodes,
                           .clusters = clusters.clusters,
                           .skyShares = clusters.skyShares,
                           .positionArea = {sources.positionArea, nearest_},
                           .unitNormal = {sources.normal, nearest_},
                           .irradianceObject = sources.irradianceObject});
  commands.dispatchTiles(sources.irradianceObject);
}

void DiffusionSourcePass::recordNeighbours(gpu::CommandList& commands,
                                           DiffusionSources& sources) const {
  commands.bind(neighbours_, {.origins = sources.nearOrigins,
                              .positionArea = {sources.positionArea, nearest_},
                              .irradianceObject = {sources.irradianceObject, nearest_},
                              .nearPosition = sources.nearPosition,
                              .nearFlux = sources.nearFlux,
                              .texelSurface = {sources.texelSurface, nearest_}});
  commands.dispatchTiles(sources.nearPosition);
  commands.bind(cells_,
                {.origins = sources.farOrigins,
                 .positionArea = {sources.positionArea, nearest_},
                 .irradianceObject = {sources.irradianceObject, nearest_},
                 .farPosition = sources.farPosition,
                 .farFlux = sources.farFlux,
                 .texelSurface = {sources.texelSurface, nearest_}},
                {.cellEdge = static_cast<std::int32_t>(sources.cellEdge)});
  commands.dispatchTiles(sources.farPosition);
}

}  // namespace opaline::paper

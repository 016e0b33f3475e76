#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "passes/boundary/ray_pass.h"
#include "passes/gather/surfel_pass.h"
#include "passes/mechanics.h"
#include "passes/ray_bodies.h"
#include "shaders/rays.comp.h"

namespace opaline::passes::test {

constexpr std::uint32_t noPiece = 0xffffffffU;
constexpr std::uint32_t everyObject = 0xffffffffU;

struct Hit {
  std::array<float, 3> normal{};
  float distance = 0;
  std::uint32_t piece = noPiece;
  std::uint32_t object = 0;
  std::uint32_t blocked = 0;
  std::uint32_t unused = 0;
};

/// The bounds as in lib/bounds.glsl.
inline std::vector<std::uint32_t> boundsOf(const std::vector<Vec3>& positions) {
  std::vector<std::uint32_t> bounds(6, 0xffffffffU);
  for (const Vec3& position : positions)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bits = std::bit_cast<std::uint32_t>(position[axis]);
      const std::uint32_t key = (bits >> 31U) != 0 ? ~bits : bits | 0x80000000U;
      bounds[axis] = std::min(bounds[axis], key);
      bounds[axis + 3] = std::min(bounds[axis + 3], ~key);
    }
  return bounds;
}

/// A body divided into surfels, and the device's hierarchy of it.
class RayTracer {
 public:
  RayTracer(gpu::Device& device, const Body& body, double spacingMm, std::size_t maxSurfels)
      : device_(device),
        made_(surfels::makeSurfels(body.surface(), std::vector<double>(body.objects, spacingMm),
                                   maxSurfels)),
        surfels_(SurfelPass::makeSurfels(device, made_, body.surface())),
        hierarchy_(RayPass::makeHierarchy(device, surfels_, made_, body.surface())),
        refit_(device),
        trace_(device, "rays"),
        commands_(device, "rays") {
    moveTo(body.moved);
  }

  const surfels::SurfelDivision& made() const { return made_; }

  void moveTo(const std::vector<Vec3>& positions) {
    std::vector<glm::vec4> packed;
    packed.reserve(positions.size());
    for (const Vec3& p : positions) packed.emplace_back(p[0], p[1], p[2], 1.0F);
    mesh_.positions = gpu::makeBuffer(device_, "positions", packed, roomUsage);
    mesh_.bounds = gpu::makeBuffer(device_, "bounds", boundsOf(positions), roomUsage);
    commands_.begin();
    refit_.record(commands_, mesh_, surfels_, hierarchy_);
    commands_.submit();
    commands_.wait();
  }

  /// Nearest hits on one object, or on all.
  std::vector<Hit> nearest(const std::vector<Ray>& rays, std::uint32_t object) {
    return trace(rays, object, 0);
  }
  std::vector<Hit> nearest(const std::vector<Ray>& rays) { return trace(rays, everyObject, 0); }
  /// How often rays meet the surface, where hits closer than `apart` count as one.
  std::vector<std::uint32_t> crossings(const std::vector<Ray>& rays, float apart) {
    std::vector<std::uint32_t> counts;
    for (const Hit& hit : trace(rays, everyObject, apart)) counts.push_back(hit.piece);
    return counts;
  }

 private:
  std::uint32_t objects() const {
    return static_cast<std::uint32_t>(made_.tree.rootOfObject.size() - 1);
  }

  std::vector<Hit> trace(const std::vector<Ray>& sent, std::uint32_t object, float apart) {
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    gpu::Buffer input = gpu::makeBuffer(device_, "rays", sent, storage);
    gpu::Buffer output = gpu::makeBuffer(device_, "hits", std::vector<Hit>(sent.size()), storage);
    std::vector<std::uint32_t> firstPieces;
    for (const std::uint32_t surfel : made_.firstOfObject)
      firstPieces.push_back(surfel * made_.piecesPerSurfel);
    gpu::Buffer first = gpu::makeBuffer(device_, "first pieces", firstPieces, storage);
    const std::uint32_t firstObject = object == everyObject ? 0 : object;
    const std::uint32_t endObject = object == everyObject ? objects() : object + 1;
    const auto count = static_cast<std::uint32_t>(sent.size());
    commands_.begin();
    commands_.beginPass("trace");
    commands_.bind(trace_,
                   {.pieceCorners = hierarchy_.corners,
                    .rayHierarchy = rays(hierarchy_),
                    .rays = input,
                    .hits = output,
                    .firstPieces = first},
                   {.count = count,
                    .firstNode = made_.tree.rootOfObject[firstObject],
                    .endNode = made_.tree.rootOfObject[endObject],
                    .object = object,
                    .apart = apart});
    commands_.dispatchLinear(count);
    commands_.endPass();
    commands_.submit();
    commands_.wait();
    return gpu::readAs<Hit>(device_, output);
  }

  gpu::Device& device_;
  surfels::SurfelDivision made_;
  Surfels surfels_;
  RayHierarchy hierarchy_;
  DeformedMesh mesh_;
  RayPass refit_;
  gpu::Compute<shaders::Rays> trace_;
  gpu::CommandList commands_;
};

}  // namespace opaline::passes::test

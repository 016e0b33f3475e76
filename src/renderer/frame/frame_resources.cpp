#include "renderer/frame/frame_resources.h"

#include <cstdint>
#include <utility>

#include "gpu/device.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"
#include "renderer/scene/scene_tables.h"

namespace opaline {

void makeTables(gpu::Device& device, const Passes& passes, SceneResources& scene,
                const RenderOptions& options, const Scene& edited, FrameResources& resources) {
  TablesOnHost onHost;
  resources.tables = makeSceneTables(device, scene, options, onHost);
  resources.materials.reset();
  if (MaterialMotion::isNeeded(edited))
    resources.materials = std::make_unique<MaterialMotion>(device, edited, scene, options.transport,
                                                           std::move(onHost));
  if (!scene.materials.empty() && scene.surfels.pieces)
    passes.opaque.cutOut(device, scene.surfels, scene.opaque, resources.tables);
  if (scene.clusters.ranges) {
    passes.opaque.makeShares(device, scene.mesh, scene.surfels, scene.clusters, scene.opaque,
                             !scene.materials.empty(), resources.tables);
    if (resources.tables.haveThinParts) passes::ClusterPass::makeRoomBehind(device, scene.clusters);
  }
  passes.paint.makeTables(device, scene.surfels, scene.clusters, scene.opaque, resources.tables);
  passes.ownSurfaces.makeTilts(device, scene.surfels, scene.opaque, resources.tables);
  // An existing sky was made for other indices of refraction.
  if (resources.sky.reflected)
    passes::SkyPass::takeEtas(device, resources.tables.etas, resources.sky);
}

void makeSky(gpu::Device& device, const Passes& passes, const Lighting& lighting,
             const RenderOptions& options, bool glossy, FrameResources& resources) {
  resources.sky =
      passes.sky.makeSky(device, lighting, options.roughness, resources.tables.etas, glossy);
}

void makeShadows(gpu::Device& device, const Lighting& lighting, const RenderOptions& options,
                 bool cutOut, FrameResources& resources) {
  resources.view.shadowViews = shadowViewCount(lighting);
  resources.shadows = passes::ShadowPass::makeMaps(
      device, static_cast<std::uint32_t>(options.shadowSize), resources.view.shadowViews, cutOut);
}

}  // namespace opaline

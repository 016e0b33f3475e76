#include "renderer/frame.h"

#include <cassert>

#include "renderer/camera_view.h"

namespace opaline {

namespace {

passes::ScatterTransport scatterTransport(Transport transport) {
  return transport == Transport::Dipole ? passes::ScatterTransport::Dipole
                                        : passes::ScatterTransport::BetterDipole;
}

passes::ScatterSite scatterSite(Site site) {
  switch (site) {
    case Site::Vertex:
      return passes::ScatterSite::Vertices;
    case Site::Fragment:
      return passes::ScatterSite::Fragments;
    case Site::Auto:
      break;
  }
  return passes::ScatterSite::PerObject;
}

// What every step of a frame needs.
struct FrameContext {
  gpu::CommandList& commands;
  const Passes& passes;
  const FramePlan& plan;
  passes::DeformedMesh& mesh;
  FrameResources& resources;

  void deform(SceneMotion& motion, const FrameUpload& upload) const {
    motion.record(commands, passes.deform, plan.clip, plan.seconds, mesh);
    passes.fit.record(commands, upload.buffer, upload.offset, mesh, resources.view);
  }

  void gather(passes::Surfels& surfels) const {
    passes.shadow.record(commands, resources.view, mesh, resources.shadows);
    if (plan.map)
      passes.map.record(commands, {resources.view, mesh, resources.tables, resources.shadows},
                        resources.sources);
    if (plan.sum != Sum::Pattern)
      passes.surfels.record(commands, {resources.view, mesh, resources.tables, resources.shadows},
                            surfels);
  }

  passes::SurfelSumPass::Order order() const {
    return {scatterTransport(plan.transport), scatterSite(plan.site), plan.tolerance};
  }

  // Everything where the site is the vertices; else what is always summed there.
  void scatterAtVertices(passes::Surfels& surfels) const {
    if (plan.sum == Sum::Pattern) {
      using Part = passes::PatternPass::VertexPart;
      return passes.pattern.overVertices(
          commands, scatterTransport(plan.transport),
          plan.site == Site::Vertex ? Part::Everything : Part::FarSamples, resources.tables,
          resources.sources, mesh, resources.exitance);
    }
    const passes::SurfelSumPass::Vertices over{resources.tables, surfels, mesh, resources.exitance};
    if (plan.sum == Sum::Tree) passes.sum.treeOverVertices(commands, order(), over);
    if (plan.site == Site::Fragment) return;
    if (plan.sum == Sum::All) passes.sum.allOverVertices(commands, order(), over);
    if (surfels.coarse)
      passes.nearby.overVertices(commands, order().transport, order().site, nearbyInputs(surfels),
                                 mesh, resources.exitance);
  }

  void scatterAtFragments(passes::Surfels& surfels) const {
    if (plan.sum == Sum::Pattern)
      return passes.pattern.overFragments(commands, scatterTransport(plan.transport),
                                          resources.tables, resources.sources, resources.surface,
                                          resources.exitance);
    const passes::SurfelSumPass::Fragments over{resources.tables, surfels, resources.surface,
                                                resources.exitance};
    if (plan.sum == Sum::Tree)
      passes.sum.treeOverFragments(commands, order(), over);
    else
      passes.sum.allOverFragments(commands, order(), over);
    if (surfels.coarse)
      passes.nearby.overFragments(commands, order().transport, order().site, nearbyInputs(surfels),
                                  resources.surface, resources.exitance);
  }

  passes::NearbyPass::Inputs nearbyInputs(passes::Surfels& surfels) const {
    return {resources.view, resources.tables, resources.shadows, surfels};
  }

  void seeSurface(const glm::vec2& jitter, passes::Surfels& surfels) const {
    passes.surface.record(
        commands,
        {resources.view, mesh, resources.sources.charts, jitter, resources.exitance.vertices},
        resources.surface);
    if (plan.site != Site::Vertex) scatterAtFragments(surfels);
  }

  void shade(std::uint32_t sample, std::uint32_t samples) const {
    passes.shade.record(commands,
                        {resources.view, resources.tables, resources.shadows, resources.surface,
                         visibleExitance(plan.site, resources), resources.environmentCube, sample,
                         samples, plan.roughness, plan.specular},
                        resources.radiance);
  }
};

}  // namespace

gpu::GpuImage& visibleExitance(Site site, FrameResources& resources) {
  return site == Site::Vertex ? resources.surface.exitance : resources.exitance.image;
}

Passes::Passes(gpu::Device& device)
    : deform(device),
      fit(device),
      shadow(device),
      map(device),
      surfels(device),
      surface(device),
      pattern(device),
      sum(device),
      nearby(device),
      environment(device),
      shade(device) {}

void recordFrame(gpu::CommandList& commands, const Passes& passes, const FramePlan& plan,
                 const FrameUpload& upload, SceneMotion& motion, SceneResources& scene,
                 FrameResources& resources) {
  assert(plan.site != Site::Auto || plan.sum != Sum::Pattern);
  assert(plan.map || plan.sum != Sum::Pattern);
  const FrameContext context{commands, passes, plan, scene.mesh, resources};
  context.deform(motion, upload);
  context.gather(scene.surfels);
  context.scatterAtVertices(scene.surfels);

  if (plan.samples > 0) {
    const VkExtent2D extent = resources.radiance.extent();
    const glm::vec2 pixel(2 / static_cast<float>(extent.width),
                          2 / static_cast<float>(extent.height));
    const auto samples = static_cast<std::uint32_t>(plan.samples);
    const std::span<const glm::vec2> pattern = samplePattern(plan.samples);
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
      context.seeSurface(pattern[sample] * pixel, scene.surfels);
      context.shade(sample, samples);
    }
  }
  if (plan.centre) context.seeSurface({0, 0}, scene.surfels);
}

}  // namespace opaline

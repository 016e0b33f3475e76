#include "renderer/frame.h"

#include <cassert>

#include "renderer/camera_view.h"

namespace opaline {

namespace {

passes::ScatterTransport scatterTransport(Transport transport) {
  return transport == Transport::Dipole ? passes::ScatterTransport::Dipole
                                        : passes::ScatterTransport::BetterDipole;
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

  void gather() const {
    passes.shadow.record(commands, resources.view, mesh, resources.shadows);
    passes.gather.record(commands, {resources.view, mesh, resources.tables, resources.shadows},
                         resources.sources);
  }

  // Everything where the site is the vertices; else what of the pattern is always summed there.
  void scatterAtVertices() const {
    const passes::ScatterTransport transport = scatterTransport(plan.transport);
    using Part = passes::ScatterPass::VertexPart;
    if (plan.sum == Sum::Pattern)
      passes.scatter.patternOverVertices(
          commands, transport, plan.site == Site::Vertex ? Part::Everything : Part::FarSamples,
          resources.tables, resources.sources, mesh, resources.exitance);
    else if (plan.site == Site::Vertex)
      passes.scatter.allOverVertices(commands, transport, resources.tables, resources.sources, mesh,
                                     resources.exitance);
  }

  void scatterAtFragments() const {
    const passes::ScatterTransport transport = scatterTransport(plan.transport);
    if (plan.sum == Sum::Pattern)
      passes.scatter.patternOverFragments(commands, transport, resources.tables, resources.sources,
                                          resources.surface, resources.exitance);
    else
      passes.scatter.allOverFragments(commands, transport, resources.tables, resources.sources,
                                      resources.surface, resources.exitance);
  }

  void seeSurface(const glm::vec2& jitter) const {
    passes.surface.record(
        commands,
        {resources.view, mesh, resources.sources.charts, jitter, resources.exitance.vertices},
        resources.surface);
    if (plan.site == Site::Fragment) scatterAtFragments();
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
      gather(device),
      surface(device),
      scatter(device),
      environment(device),
      shade(device) {}

void recordFrame(gpu::CommandList& commands, const Passes& passes, const FramePlan& plan,
                 const FrameUpload& upload, SceneMotion& motion, passes::DeformedMesh& mesh,
                 FrameResources& resources) {
  assert(plan.site != Site::Auto);
  const FrameContext context{commands, passes, plan, mesh, resources};
  context.deform(motion, upload);
  context.gather();
  context.scatterAtVertices();

  if (plan.samples > 0) {
    const VkExtent2D extent = resources.radiance.extent();
    const glm::vec2 pixel(2 / static_cast<float>(extent.width),
                          2 / static_cast<float>(extent.height));
    const auto samples = static_cast<std::uint32_t>(plan.samples);
    const std::span<const glm::vec2> pattern = samplePattern(plan.samples);
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
      context.seeSurface(pattern[sample] * pixel);
      context.shade(sample, samples);
    }
  }
  if (plan.centre) context.seeSurface({0, 0});
}

}  // namespace opaline

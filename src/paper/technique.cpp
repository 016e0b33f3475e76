#include "paper/technique.h"

#include "gpu/device.h"
#include "paper/diffusion_source_pass.h"
#include "paper/flat_scene.h"
#include "paper/map_irradiance_pass.h"
#include "paper/pattern_layout.h"
#include "paper/pattern_pass.h"

namespace opaline::paper {

struct Technique::Passes {
  explicit Passes(gpu::Device& device) : map(device), pattern(device), irradiance(device) {}

  DiffusionSourcePass map;
  PatternPass pattern;
  MapIrradiancePass irradiance;
};

Technique::Technique(gpu::Device& device) : passes_(std::make_unique<const Passes>(device)) {}
Technique::~Technique() = default;

FlatScene Technique::layFlat(gpu::Device& device, const core::RestSurface& surface, int mapSize) {
  return makeFlatScene(device, surface, mapSize);
}

Map Technique::makeMap(gpu::Device& device, const RestScene& scene, FlatScene& flat,
                       passes::DeformedMesh& mesh, const RenderOptions& options) const {
  const PatternLayout layout = layOutPattern(scene, flat, options.pattern);
  return {.sources = passes_->map.prepare(device, mesh, flat, layout.maps),
          .pattern = PatternPass::makeTable(device, scene, layout, flat.texelEdgeMm(),
                                            options.transport == Transport::Dipole
                                                ? bssrdf::Model::Dipole
                                                : bssrdf::Model::BetterDipole)};
}

void Technique::gather(gpu::CommandList& commands, const Frame& frame,
                       passes::Clusters* occlusion) const {
  passes_->map.record(
      commands,
      {frame.view, frame.mesh, frame.tables, frame.shadows, frame.sky, frame.flat, occlusion},
      frame.map.sources);
}

void Technique::scatterAtVertices(gpu::CommandList& commands, passes::ScatterTransport transport,
                                  VertexPart part, const Frame& frame) const {
  passes_->pattern.overVertices(commands, transport, part == VertexPart::Everything,
                                {frame.tables, frame.map, frame.exitance}, frame.flat, frame.mesh);
}

void Technique::scatterAtFragments(gpu::CommandList& commands, passes::ScatterTransport transport,
                                   const Frame& frame) const {
  passes_->pattern.overFragments(commands, transport, {frame.tables, frame.map, frame.exitance},
                                 frame.flat, {frame.view, frame.mesh, frame.surfaces});
}

void Technique::showIrradiance(gpu::CommandList& commands, const Frame& frame,
                               gpu::GpuImage& irradiance) const {
  passes_->irradiance.record(commands, {frame.view, frame.mesh, frame.surfaces}, frame.flat,
                             frame.map, irradiance);
}

}  // namespace opaline::paper

#include "renderer/frame/frame_context.h"

namespace opaline {

passes::CutOuts FrameContext::cutOuts() const {
  return {resources.tables, scene.opaque};
}

passes::SeenSurfaces FrameContext::seen() const {
  return {resources.view, scene.mesh, resources.surfaces};
}

passes::BodiesBetween FrameContext::bodiesBetween() const {
  return {scene.rays, scene.surfels, scene.clusters,
          boundary() && looksThrough(plan) && resources.tables.haveThinParts};
}

passes::OpaquePass::Inputs FrameContext::ofOpaque() const {
  return {resources.view, resources.tables, resources.shadows, bodiesBetween()};
}

passes::OpaqueLightsPass::Inputs FrameContext::onOpaque() const {
  return {resources.view, resources.tables, bodiesBetween(), plan.areaLights};
}

passes::NearbyPass::Inputs FrameContext::nearbyInputs() const {
  return {resources.view, resources.tables, resources.shadows,
          resources.sky,  scene.surfels,    scene.opaque};
}

paper::Technique::Frame FrameContext::onPaper() const {
  return {resources.view,     scene.mesh,    resources.tables,
          resources.shadows,  resources.sky, resources.surfaces,
          resources.exitance, *scene.flat,   *resources.map};
}

bool FrameContext::boundary() const {
  return plan.transport == Transport::Boundary;
}

bool FrameContext::carries() const {
  return boundary() || carriesOpaque(plan);
}

passes::ScatterSite FrameContext::site() const {
  switch (plan.site) {
    case Site::Vertex:
      return passes::ScatterSite::Vertices;
    case Site::Fragment:
      return passes::ScatterSite::Fragments;
    case Site::Auto:
      break;
  }
  return passes::ScatterSite::PerObject;
}

passes::ScatterTransport FrameContext::transport() const {
  return plan.transport == Transport::Dipole ? passes::ScatterTransport::Dipole
                                             : passes::ScatterTransport::BetterDipole;
}

// Boundary transport uses only the half-space's detail between clusters, in which most errors
// cancel. Coarse surfels need the estimate to know what is negligible.
bool FrameContext::wantsEstimate() const {
  constexpr float errorWithout = 0.001F;  // at most, relative to what is seen
  return !boundary() || scene.surfels.coarse || plan.tolerance < 5 * errorWithout;
}

passes::SurfelSumPass::Order FrameContext::order() const {
  return {transport(), site(), plan.tolerance, wantsEstimate()};
}

}  // namespace opaline

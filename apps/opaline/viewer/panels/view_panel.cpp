#include <imgui.h>

#include "cli/picture_options.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/option_control.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

struct Variable {
  Aov aov = Aov::Radiance;
  SurfelIndex surfelIndex = SurfelIndex::Surfel;

  bool operator==(const Variable&) const = default;
};

// Groups have up to four members, so this level has the leaves of a million surfels.
constexpr int deepestLevel = 10;

Choices<Variable> shownVariables(const RenderOptions& options) {
  Choices<Variable> table{{"radiance", {Aov::Radiance}},       {"exitance", {Aov::Exitance}},
                          {"irradiance", {Aov::Irradiance}},   {"position", {Aov::Position}},
                          {"normal", {Aov::Normal}},           {"depth", {Aov::Depth}},
                          {"evaluations", {Aov::Evaluations}}, {"object", {Aov::Object}}};
  if (options.sum != Sum::Pattern) {
    table.push_back({"surfels", {Aov::Surfels}});
    table.push_back({"tree levels", {Aov::Surfels, SurfelIndex::Node}});
  }
  if (options.transport == Transport::Boundary) {
    table.push_back({"clusters", {Aov::Surfels, SurfelIndex::Cluster}});
  }
  for (const auto& [name, aov] : Choices<Aov>{{"map: position", Aov::DsmPosition},
                                              {"map: normal", Aov::DsmNormal},
                                              {"map: irradiance", Aov::DsmIrradiance},
                                              {"map: area", Aov::DsmArea}}) {
    table.push_back({name, {aov}});
  }
  return table;
}

bool chooseVariable(Session& session) {
  Variable shown{session.aov};
  if (session.aov == Aov::Surfels) shown.surfelIndex = session.surfelIndex;
  bool changed = controls::choice("variable", shown, shownVariables(session.options),
                                  "What is drawn: light towards the camera, what leaves or enters "
                                  "the surface, its shape, the surfels it is cut into, or the "
                                  "diffusion source map with the atlas it lies on.");
  if (changed) {
    session.aov = shown.aov;
    session.surfelIndex = shown.surfelIndex;
  }
  if (shown == Variable{Aov::Surfels, SurfelIndex::Node}) {
    changed |= controls::integer("level", session.treeLevel, 0, deepestLevel,
                                 "Level of the groups of surfels that the sum can treat as one: "
                                 "whole objects at 0, a few surfels at the deepest.");
  }
  return changed;
}

}  // namespace

void drawViewPanel(Session& session) {
  if (!controls::section("View", false)) return;
  bool changed = chooseVariable(session);
  RenderOptions& options = session.options;
  // These settings only change how the picture is shown; it need not be rendered again.
  if (controls::stops("exposure", session.tone.exposureStops, -8, 8,
                      "Twice the light for every stop. Keys: O, X.")) {
    session.exposesByLight = false;
  }
  if (controls::checkbox("exposure follows the light", session.exposesByLight,
                         "Suits lights and sky, whatever the camera sees.")) {
    exposeByLight(session);
  }
  controls::choice("tone", session.tone.curve, choicesOf<ToneCurve>(),
                   "Neutral bends only what is brighter than white (Khronos 2024).");
  changed |= drawOption("samples a pixel", options, "antialias",
                        "Samples at rest; 1 while the picture moves.");
  changed |= drawOption("reflection on the surface", options, "specular",
                        "GGX reflection of lights and environment (Walter et al. 2007).");
  if (options.specular) {
    changed |= drawOption("roughness", options, "roughness", "Of that reflection.");
  }
  controls::checkbox("scale bar", session.scaleBar,
                     "Millimetres in the picture, beside how far light travels in the medium.");
  float fov = session.scene.camera.verticalFovDegrees;
  if (controls::slider("field of view", fov, 5, 100, "%.1f deg", "Of the camera, vertical.")) {
    session.scene.camera.verticalFovDegrees = fov;
    session.edits.camera = true;
  }
  if (changed) session.edits.picture = true;
}

}  // namespace opaline::app::viewer

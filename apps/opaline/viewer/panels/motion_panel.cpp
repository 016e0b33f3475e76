#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "opaline/options/scene.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

constexpr std::size_t mostDeformers = 8;

const Choices<DeformerKind>& kinds() {
  static const Choices<DeformerKind> table = [] {
    Choices<DeformerKind> choices;
    for (const std::string_view name : options::namesOf<DeformerKind>())
      choices.emplace_back(name, options::named<DeformerKind>(name));
    return choices;
  }();
  return table;
}

/// The useful part of the range that is allowed.
struct Limits {
  float low;
  float high;
  const char* format;
};

Limits limitsOf(DeformerKind kind) {
  switch (kind) {
    case DeformerKind::Twist:
      return {-10, 10, "%.2f rad"};
    case DeformerKind::Bend:
      return {-3.1F, 3.1F, "%.2f rad"};
    case DeformerKind::Squash:
      return {-0.9F, 0.9F, "%.2f"};
    case DeformerKind::Wobble:
      break;
  }
  return {-0.5F, 0.5F, "%.3f"};
}

bool drawDeformer(Deformer& deformer) {
  bool changed = controls::choice("kind", deformer.kind, kinds(),
                                  "Deforms the whole scene about its vertical axis.");
  const Limits limits = limitsOf(deformer.kind);
  if (changed) deformer.amount = std::clamp(deformer.amount, limits.low, limits.high);
  changed |= controls::slider("amount", deformer.amount, limits.low, limits.high, limits.format,
                              "How much: an angle, or a part of the size.");
  bool swings = deformer.periodSeconds > 0;
  if (controls::checkbox("swings", swings, "Swings to and fro instead of standing still.")) {
    deformer.periodSeconds = swings ? 2.0F : 0;
    changed = true;
  }
  if (swings) {
    changed |= controls::slider("period", deformer.periodSeconds, 0.1F, 20, "%.2f s",
                                "Duration of one swing.");
  }
  return changed;
}

bool drawDeformers(std::vector<Deformer>& deformers) {
  bool changed = false;
  for (std::size_t i = 0; i < deformers.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    changed |= drawDeformer(deformers[i]);
    const bool gone = controls::button("remove", "Removes this deformation.");
    ImGui::PopID();
    if (!gone) continue;
    deformers.erase(deformers.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }
  if (deformers.size() < mostDeformers &&
      controls::button("add a deformation", "Twist, bend, squash or wobble the whole scene.")) {
    deformers.push_back({DeformerKind::Wobble, 0.05F, 2});
    changed = true;
  }
  return changed;
}

void drawClips(Session& session) {
  std::vector<std::string> names{"none"};
  for (const Clip& clip : session.scene.clips) {
    names.push_back(clip.name.empty() ? fmt::format("clip {}", names.size()) : clip.name);
  }
  int chosen = session.time.clip + 1;
  if (names.size() > 1 && controls::choice("clip", chosen, names, "Which animation plays.")) {
    session.time.clip = chosen - 1;
    fitPlayback(session);
    session.edits.picture = true;
  }
}

}  // namespace

void drawMotionPanel(Session& session) {
  if (!controls::section("Motion", false)) return;
  Playback& playback = session.playback;
  const bool moving = movesInTime(session);
  const auto orWhyNot = [&](const char* about) { return moving ? about : nothingMoves; };
  ImGui::BeginDisabled(!moving);
  if (controls::button(playback.playing ? "pause" : "play", orWhyNot("Key: space."))) {
    playback.playing = !playback.playing;
  }
  ImGui::SameLine();
  controls::checkbox("loop", playback.loop, orWhyNot("Starts again at the end."));
  ImGui::EndDisabled();
  ImGui::SameLine();
  controls::checkbox("turntable", playback.turntable, "Turns the camera about the scene. Key: T.");
  ImGui::BeginDisabled(!moving);
  session.edits.picture |=
      controls::slider("time", session.time.seconds, playback.beginSeconds, playback.endSeconds,
                       "%.3f s", orWhyNot("The moment that is shown."));
  ImGui::EndDisabled();
  controls::checkbox("poke", session.poke,
                     "The mouse pulls at the body as if it were jelly; beside the body it turns "
                     "the camera. With Ctrl it always pulls. Key: B. Macklin et al. 2016.");
  controls::slider("speed", playback.speed, 0.05F, 4, "%.2f x", "Speed of the playback.");
  drawClips(session);
  if (drawDeformers(session.scene.deformers)) {
    session.edits.deformers = true;
    fitPlayback(session);
  }
}

}  // namespace opaline::app::viewer

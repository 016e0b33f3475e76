#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "cli/material_textures.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/thumbnail.h"

namespace opaline::app::viewer {

namespace {

const char* meaningOf(std::string_view use) {
  if (use == "base color") return "Multiplies the base color.";
  if (use == "color") return "Paint: what a thick body shows of even light, times the color.";
  if (use == "metallic-roughness") return "Green multiplies the roughness, blue the metallic part.";
  if (use == "normal") return "Which way the surface faces: red across, green up, blue outwards.";
  if (use == "occlusion") return "Red: how much of the light from all around gets there.";
  if (use == "emission") return "Multiplies the emission.";
  return "Multiplies the strength of the reflection.";
}

void showTextures(const Object& object) {
  for (const auto& [use, texture] : texturesOf(object)) {
    drawThumbnail(texture->pixels, meaningOf(use));
    controls::note(fmt::format("{} texture", use).c_str());
    ImGui::SameLine();
    ImGui::BeginGroup();
    controls::text(fmt::format("{} texture", use));
    controls::text(fmt::format("{}\n{}x{}", texture->pixels->name, texture->pixels->width,
                               texture->pixels->height));
    ImGui::EndGroup();
  }
}

bool drawNormals(float& scale, const char* about) {
  bool on = scale != 0;
  if (!controls::checkbox("normal texture", on, about)) return false;
  scale = on ? 1.0F : 0.0F;
  return true;
}

constexpr const char* aboutNormals = "Whether the surface is as uneven as its texture says.";
constexpr const char* aboutRoughness =
    "Of the reflection: 0 mirrors sharply. Multiplies its texture, if there is one.";

bool drawOpaque(OpaqueMaterial& material) {
  controls::text(material.name.empty() ? "opaque" : material.name + ", opaque");
  bool changed = controls::color("base color", material.baseColor,
                                 "The share of light that is given back, or mirrored by a metal.");
  changed |= controls::slider("metallic", material.metallic, 0, 1, "%.2f",
                              "How much of it is metal: what mirrors in its own color.");
  changed |= controls::slider("roughness", material.roughness, 0, 1, "%.2f", aboutRoughness);
  changed |= controls::slider("specular", material.specular, 0, 1, "%.2f",
                              "Strength of the reflection of what is no metal.");
  changed |= controls::slider("transmission", material.diffuseTransmission, 0, 1, "%.2f",
                              "Share of the diffuse light that goes through to the other side, as "
                              "through a leaf or paper.");
  changed |= controls::light("emission", material.emission, "Radiance of its own.");
  if (material.normalTexture) changed |= drawNormals(material.normalScale, aboutNormals);
  return changed;
}

// Edits the medium by its look. The inversion supports indices of refraction up to 1.6.
bool drawAppearance(Medium& medium) {
  Appearance appearance{.g = medium.g, .eta = std::min(medium.eta, 1.6)};
  Rgb color = colorOf(medium);
  for (std::size_t c = 0; c < 3; ++c) {
    appearance.color[c] = std::clamp(double{color[c]}, 0.0, 1.0);
    const double extinction =
        medium.sigmaSPrimePerMm[c] / (1 - appearance.g) + medium.sigmaAPerMm[c];
    appearance.meanFreePathMm[c] = std::clamp(1 / extinction, 1e-6, 1e6);
  }
  bool changed = controls::color(
      "color", color, "The share of light that entered which leaves again, of a thick body.");
  for (std::size_t c = 0; c < 3; ++c)
    if (changed) appearance.color[c] = double{color[c]};
  constexpr std::array<const char*, 3> names{"mean free path, red", "mean free path, green",
                                             "mean free path, blue"};
  for (std::size_t c = 0; c < 3; ++c)
    changed |= controls::slider(names[c], appearance.meanFreePathMm[c], 1e-3, 1e2, "%.3g mm",
                                "How far light goes in the medium until it meets something.");
  changed |= controls::slider("g", appearance.g, -0.95, 0.95, "%.2f",
                              "Mean cosine of scattering, by which the mean free path is told: "
                              "above 0 light goes on forward.");
  if (!changed) return false;
  Medium made = mediumOf(appearance);
  made.name = "custom";
  made.eta = medium.eta;
  medium = made;
  return true;
}

bool drawSurface(std::optional<TranslucentSurface>& surface, float standard) {
  TranslucentSurface now = surface.value_or(TranslucentSurface{});
  float roughness = now.roughness.value_or(now.metallicRoughnessTexture ? 1.0F : standard);
  bool changed = controls::slider("roughness", roughness, 0, 1, "%.2f", aboutRoughness);
  if (changed) now.roughness = roughness;
  if (now.normalTexture) changed |= drawNormals(now.normalScale, aboutNormals);
  if (changed) surface = now;
  return changed;
}

// Notes changed numbers as a scene file has them, beside the model's own material.
void noteNumbers(Session& session) {
  const Object& object = session.scene.objects[session.object];
  MaterialNumbers& numbers = session.source.numbersOfObject[object.name];
  if (object.opaque) numbers.opaque = options::chosenIn(*object.opaque);
  if (!object.opaque && object.surface) numbers.surface = options::chosenIn(*object.surface);
}

}  // namespace

void drawMaterialPanel(Session& session) {
  if (!controls::section("Material", false) || session.scene.objects.empty()) return;
  chooseObject(session);
  Object& object = session.scene.objects[session.object];
  bool changed = false;
  if (object.opaque) {
    changed = drawOpaque(*object.opaque);
  } else {
    controls::text(object.medium.name + ", translucent");
    changed = drawAppearance(object.medium);
    if (drawSurface(object.surface, session.options.roughness)) changed = true;
  }
  showTextures(object);
  if (!changed) return;
  noteNumbers(session);
  session.edits.material[session.object] = true;
}

}  // namespace opaline::app::viewer

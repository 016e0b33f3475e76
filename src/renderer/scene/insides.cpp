#include "renderer/scene/insides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "scene/changes.h"
#include "scene/mesh/bodies.h"
#include "scene/text.h"

namespace opaline {

namespace {

// A single further name is listed instead of counted.
std::string listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t mostNamed = 3;
  return scene::listed(names, names.size() == mostNamed + 1 ? names.size() : mostNamed);
}

// Logs objects that are open, entirely or in parts.
void noteOpen(const std::vector<std::string_view>& names, bool inParts, const LogCallback& log) {
  if (names.empty() || !log) return;
  const bool one = names.size() == 1;
  const std::string subject =
      inParts ? (one ? "a part of object " : "parts of objects ") : (one ? "object " : "objects ");
  log(LogLevel::Note,
      fmt::format("{}{} {} open and {} no inside for boundary transport: light scatters there as "
                  "in a half-space, by better-dipole",
                  subject, listed(names), one ? "is" : "are", one ? "has" : "have"));
}

void noteSheetsInside(const std::vector<std::string_view>& names, const LogCallback& log) {
  if (names.empty() || !log) return;
  const bool one = names.size() == 1;
  log(LogLevel::Note,
      fmt::format("object{} {} {} in a translucent one, whose light goes through {}: only what is "
                  "opaque and closed ends it",
                  one ? "" : "s", listed(names), one ? "lies" : "lie", one ? "it" : "them"));
}

bool isPorous(const Scene& scene, std::size_t object) {
  const std::optional<OpaqueMaterial>& opaque = scene.objects[object].opaque;
  return opaque && (opaque->alphaCutoff > 0 || scene::letsLightThrough(scene, object));
}

std::vector<bool> porousObjects(const Scene& scene) {
  std::vector<bool> porous;
  porous.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) porous.push_back(isPorous(scene, i));
  return porous;
}

surfels::Substance substanceOf(const Object& object, bool isPorous, bool hasInside) {
  using surfels::Substance;
  if (object.isGround) return Substance::Other;
  if (!object.opaque) return hasInside ? Substance::Medium : Substance::Other;
  return isPorous || !hasInside ? Substance::Sheet : Substance::Solid;
}

// Whether clips may move parts of an object apart. Deformers move all of space.
bool clipsBend(const Scene& scene, std::size_t object) {
  const std::optional<Rig>& rig = scene.objects[object].rig;
  return !scene.clips.empty() && rig && !(rig->joints.empty() && rig->targets.empty());
}

// For every object's triangles, whether they have an inside.
std::vector<std::vector<bool>> insideOf(const Scene& scene, const scene::MergedMesh& merged) {
  std::vector<std::vector<bool>> inside = scene::insideOfObjects(scene, merged.bodyOfObject);
  // Nobody sees a ground from below.
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (scene.objects[i].isGround) inside[i].assign(inside[i].size(), true);
  return inside;
}

}  // namespace

Insides findInsides(const Scene& scene, const scene::MergedMesh& merged, const LogCallback& log) {
  const std::vector<std::vector<bool>> insideOfObject = insideOf(scene, merged);
  std::vector<bool> bodyHasInside(merged.firstObjectOfBody.size(), false);
  std::vector<bool> bodyIsOpen(merged.firstObjectOfBody.size(), false);
  Insides insides;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::vector<bool>& inside = insideOfObject[i];
    insides.triangleHasInside.insert(insides.triangleHasInside.end(), inside.begin(), inside.end());
    for (const bool has : inside) (has ? bodyHasInside : bodyIsOpen)[merged.bodyOfObject[i]] = true;
  }
  std::vector<std::string_view> open;
  std::vector<std::string_view> openInParts;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const bool any = bodyHasInside[merged.bodyOfObject[i]];
    const bool isOpen = bodyIsOpen[merged.bodyOfObject[i]];
    insides.objectHasInside.push_back(any && !object.opaque);
    insides.objectIsOpen.push_back(isOpen);
    if (isOpen && !object.opaque) (any ? openInParts : open).emplace_back(object.name);
  }
  noteOpen(open, false, log);
  noteOpen(openInParts, true, log);
  return insides;
}

Within findWithin(const Scene& scene, const scene::MergedMesh& merged, const Insides& insides,
                  bool keepsOverlaps, const LogCallback& log) {
  std::vector<bool> porous = porousObjects(scene);
  std::vector<surfels::Substance> substances;
  substances.reserve(merged.triangles.size());
  for (std::size_t t = 0; t < merged.triangles.size(); ++t) {
    const std::uint32_t object = merged.objectOfTriangle[t];
    substances.push_back(
        substanceOf(scene.objects[object], porous[object], insides.triangleHasInside[t]));
  }
  std::vector<bool> boundsMedium;
  boundsMedium.reserve(substances.size());
  for (std::size_t t = 0; t < substances.size(); ++t)
    boundsMedium.push_back(substances[t] == surfels::Substance::Medium &&
                           !clipsBend(scene, merged.objectOfTriangle[t]));
  Within within{{scene::bodiesOf(merged), substances}, {scene::bodiesOf(merged), boundsMedium}};
  within.overlapAtRest = within.overlaps.any();
  within.isPorous = std::move(porous);
  if (keepsOverlaps) within.overlaps = {};
  std::vector<std::string_view> sheets;
  for (const std::uint32_t body : within.linings.sheetsInside())
    sheets.emplace_back(scene.objects[merged.firstObjectOfBody[body]].name);
  noteSheetsInside(sheets, log);
  return within;
}

bool stillHolds(const Within& within, const Scene& scene) {
  return within.isPorous.empty() || within.isPorous == porousObjects(scene);
}

}  // namespace opaline

#include "renderer/scene/insides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "scene/changes.h"
#include "scene/mesh/bodies.h"
#include "scene/mesh/insides.h"
#include "scene/text.h"

namespace opaline {

namespace {

// One more is named, not counted.
std::string listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t mostNamed = 3;
  return scene::listed(names, names.size() == mostNamed + 1 ? names.size() : mostNamed);
}

// Of objects that are open, all over or in parts.
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

surfels::Substance substanceOf(const Scene& scene, std::size_t object, bool hasInside) {
  using surfels::Substance;
  const Object& its = scene.objects[object];
  if (its.isGround) return Substance::Other;
  if (!its.opaque) return hasInside ? Substance::Medium : Substance::Other;
  const bool hasHoles = its.opaque->alphaCutoff > 0;
  const bool isSheet = !hasInside || hasHoles || scene::letsLightThrough(scene, object);
  return isSheet ? Substance::Sheet : Substance::Solid;
}

// Of each body's triangles, object after object.
std::vector<std::vector<bool>> insideOfBodies(const Scene& scene, const scene::MergedMesh& merged) {
  const std::vector<Mesh> bodies = scene::meshesOfBodies(scene, merged.bodyOfObject);
  std::vector<std::vector<bool>> inside;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // Nobody sees a ground from below.
    const bool isGround = scene.objects[merged.firstObjectOfBody[i]].isGround;
    inside.push_back(isGround
                         ? std::vector<bool>(bodies[i].triangles.size(), true)
                         : scene::trianglesWithInside(bodies[i].positionsMm, bodies[i].triangles));
  }
  return inside;
}

}  // namespace

Insides findInsides(const Scene& scene, const scene::MergedMesh& merged, const LogCallback& log) {
  Insides insides;
  const std::vector<std::vector<bool>> insideOfBody = insideOfBodies(scene, merged);
  std::vector<std::size_t> seen(insideOfBody.size(), 0);  // triangles of the body
  std::vector<std::string_view> open;
  std::vector<std::string_view> openInParts;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const std::uint32_t body = merged.bodyOfObject[i];
    const std::vector<bool>& inside = insideOfBody[body];
    const bool any = std::find(inside.begin(), inside.end(), true) != inside.end();
    const bool isOpen = std::find(inside.begin(), inside.end(), false) != inside.end();
    insides.objectHasInside.push_back(any && !object.opaque);
    insides.objectIsOpen.push_back(isOpen);
    const auto first = inside.begin() + static_cast<std::ptrdiff_t>(seen[body]);
    seen[body] += object.mesh.triangles.size();
    std::vector<bool>& all = insides.triangleHasInside;
    all.insert(all.end(), first, inside.begin() + static_cast<std::ptrdiff_t>(seen[body]));
    if (isOpen && !object.opaque) (any ? openInParts : open).emplace_back(object.name);
  }
  noteOpen(open, false, log);
  noteOpen(openInParts, true, log);
  return insides;
}

surfels::Linings findLinings(const Scene& scene, const scene::MergedMesh& merged,
                             const Insides& insides, const LogCallback& log) {
  std::vector<surfels::Substance> substances;
  substances.reserve(merged.triangles.size());
  for (std::size_t t = 0; t < merged.triangles.size(); ++t)
    substances.push_back(
        substanceOf(scene, merged.objectOfTriangle[t], insides.triangleHasInside[t]));
  surfels::Linings linings(scene::bodiesOf(merged), substances);
  std::vector<std::string_view> sheets;
  for (const std::uint32_t body : linings.sheetsInside())
    sheets.emplace_back(scene.objects[merged.firstObjectOfBody[body]].name);
  noteSheetsInside(sheets, log);
  return linings;
}

}  // namespace opaline

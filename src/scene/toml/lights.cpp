#include "scene/toml/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "opaline/options/scene.h"
#include "scene/toml/keys.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// Refuses an entry with a key that it must not have, or without one that it needs.
void requireKeys(const TomlTable& table, std::string_view type,
                 std::span<const std::string_view> known,
                 std::initializer_list<std::string_view> needed) {
  table.requireKeys(known);
  for (const std::string_view key : needed)
    if (!table.has(key)) table.fail("", fmt::format("of type '{}' has no '{}'", type, key));
}

/// The light with what the options' table reads for it. Refuses impossible values.
template <typename Light>
Light completed(const TomlTable& table, std::string_view type, Light light) {
  chosenIn<Light>(table).applyTo(light);
  if (const std::string complaint = complaintAbout(light); !complaint.empty())
    table.fail("", fmt::format("of type '{}': {}", type, complaint));
  return light;
}

void readDirectional(const TomlTable& table, const Vec3& /*centreMm*/, Lighting& lighting) {
  requireKeys(table, "directional", keys::directional, {"direction_to_light"});
  lighting.directional.push_back(
      completed(table, "directional",
                DirectionalLight{.directionToLight = *table.direction("direction_to_light")}));
}

void readPoint(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "point", keys::point, {"position_mm", "intensity"});
  lighting.points.push_back(completed(
      table, "point", PointLight{.positionMm = *placeFrom(table, "position_mm", centreMm)}));
}

void readSpot(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "spot", keys::spot, {"position_mm", "direction", "intensity"});
  lighting.spots.push_back(
      completed(table, "spot",
                SpotLight{.positionMm = *placeFrom(table, "position_mm", centreMm),
                          .direction = *table.direction("direction")}));
}

void readRectangle(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "rectangle", keys::rectangle, {"center_mm", "u_mm", "v_mm", "radiance"});
  lighting.areas.emplace_back(
      completed(table, "rectangle",
                RectangleLight{.centreMm = *placeFrom(table, "center_mm", centreMm),
                               .uMm = *table.vector("u_mm"),
                               .vMm = *table.vector("v_mm")}));
}

void readDisc(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "disc", keys::disc, {"center_mm", "normal", "radius_mm", "radiance"});
  lighting.areas.emplace_back(
      completed(table, "disc",
                DiscLight{.centreMm = *placeFrom(table, "center_mm", centreMm),
                          .normal = *table.direction("normal")}));
}

void readSphere(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "sphere", keys::sphere, {"center_mm", "radius_mm", "radiance"});
  lighting.areas.emplace_back(completed(
      table, "sphere", SphereLight{.centreMm = *placeFrom(table, "center_mm", centreMm)}));
}

void readTube(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  requireKeys(table, "tube", keys::tube, {"from_mm", "to_mm", "radius_mm", "radiance"});
  lighting.areas.emplace_back(completed(table, "tube",
                                        TubeLight{.fromMm = *placeFrom(table, "from_mm", centreMm),
                                                  .toMm = *placeFrom(table, "to_mm", centreMm)}));
}

void readAmbient(const TomlTable& table, const Vec3& /*centreMm*/, Lighting& lighting) {
  requireKeys(table, "ambient", keys::ambient, {"radiance"});
  Lighting ambient;
  chosenIn<Lighting>(table).applyTo(ambient);
  for (std::size_t c = 0; c < 3; ++c) lighting.ambient[c] += ambient.ambient[c];
}

constexpr keys::Keys<8> types{"directional", "point",  "spot", "rectangle",
                              "disc",        "sphere", "tube", "ambient"};
using Reader = void (*)(const TomlTable&, const Vec3&, Lighting&);
constexpr std::array<Reader, types.size()> readers{readDirectional, readPoint,  readSpot,
                                                   readRectangle,   readDisc,   readSphere,
                                                   readTube,        readAmbient};

}  // namespace

void readLight(const TomlTable& table, const Vec3& centreMm, Lighting& lighting) {
  const auto type = table.choice("type", types);
  if (!type) table.fail("", fmt::format("has no 'type': {}", fmt::join(types, ", ")));
  const auto found = std::find(types.begin(), types.end(), *type) - types.begin();
  readers[static_cast<std::size_t>(found)](table, centreMm, lighting);
}

}  // namespace opaline::scene

#include "viewer/session/light_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <variant>

namespace opaline::app::viewer {

namespace {

constexpr std::array<const char*, 4> names{"directional", "point", "spot", "area"};
constexpr std::array<const char*, 4> shapes{"rectangle", "disc", "sphere", "tube"};

std::array<std::size_t, names.size()> countsOf(const Lighting& lighting) {
  return {lighting.directional.size(), lighting.points.size(), lighting.spots.size(),
          lighting.areas.size()};
}

// How many area lights up to this one have its shape.
std::size_t numberInShape(const std::vector<AreaLight>& areas, std::size_t index) {
  const auto first = areas.begin();
  return static_cast<std::size_t>(
      std::count_if(first, first + static_cast<std::ptrdiff_t>(index + 1),
                    [&](const AreaLight& light) { return light.index() == areas[index].index(); }));
}

template <typename Light>
void eraseAt(std::vector<Light>& lights, std::size_t index) {
  lights.erase(std::next(lights.begin(), static_cast<std::ptrdiff_t>(index)));
}

}  // namespace

std::size_t countOf(const Lighting& lighting) {
  std::size_t sum = 0;
  for (const std::size_t count : countsOf(lighting)) sum += count;
  return sum;
}

LightEntry entryOf(const Lighting& lighting, std::size_t light) {
  const auto counts = countsOf(lighting);
  std::size_t kind = 0;
  while (light >= counts[kind]) light -= counts[kind++];
  return {static_cast<LightKind>(kind), light};
}

std::size_t numberOfLast(LightKind kind, const Lighting& lighting) {
  const auto counts = countsOf(lighting);
  std::size_t end = 0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(kind); ++k) end += counts[k];
  return end - 1;
}

std::string nameOf(LightKind kind) {
  return names[static_cast<std::size_t>(kind)];
}

std::string nameOf(const Lighting& lighting, const LightEntry& entry) {
  if (entry.kind != LightKind::Area)
    return fmt::format("{} {}", nameOf(entry.kind), entry.index + 1);
  return fmt::format("{} {}", shapes[lighting.areas[entry.index].index()],
                     numberInShape(lighting.areas, entry.index));
}

Rgb powerOf(const Lighting& lighting, const LightEntry& entry) {
  switch (entry.kind) {
    case LightKind::Directional:
      return lighting.directional[entry.index].irradiance;
    case LightKind::Point:
      return lighting.points[entry.index].intensity;
    case LightKind::Spot:
      return lighting.spots[entry.index].intensity;
    case LightKind::Area:
      break;
  }
  return std::visit([](const auto& light) { return light.radiance; }, lighting.areas[entry.index]);
}

void erase(const LightEntry& entry, Lighting& lighting) {
  switch (entry.kind) {
    case LightKind::Directional:
      return eraseAt(lighting.directional, entry.index);
    case LightKind::Point:
      return eraseAt(lighting.points, entry.index);
    case LightKind::Spot:
      return eraseAt(lighting.spots, entry.index);
    case LightKind::Area:
      return eraseAt(lighting.areas, entry.index);
  }
}

}  // namespace opaline::app::viewer

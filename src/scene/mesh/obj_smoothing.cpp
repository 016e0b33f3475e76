#include "scene/mesh/obj_smoothing.h"

#include <array>
#include <bit>
#include <unordered_map>

#include "scene/hash.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

// The polygon's area vector, twice its area long (Newell; Sutherland, Sproull and Schumacker 1974).
Double3 areaOf(std::span<const Vec3> positions, const ObjFace& face) {
  Double3 sum{};
  const Double3 origin = toDouble(positions[face.positions[0]]);
  for (std::size_t i = 0; i < face.positions.size(); ++i) {
    const std::size_t next = (i + 1) % face.positions.size();
    sum = sum + cross(toDouble(positions[face.positions[i]]) - origin,
                      toDouble(positions[face.positions[next]]) - origin);
  }
  return sum;
}

double angleOfCorner(std::span<const Vec3> positions, const ObjFace& face, std::size_t corner) {
  const std::size_t count = face.positions.size();
  const auto place = [&](std::size_t i) { return toDouble(positions[face.positions[i % count]]); };
  return angleAt(place(corner), place(corner + 1), place(corner + count - 1));
}

Double3 unitOr0(const Double3& v) {
  const double size = length(v);
  return size > 0 ? (1.0 / size) * v : Double3{};
}

using InGroup = std::array<std::uint32_t, 2>;     // position and group
using WithNormal = std::array<std::uint32_t, 4>;  // position and bits of the normal

}  // namespace

ObjNormals normalsOfSmoothing(std::span<const Vec3> positions, std::span<const ObjFace> faces,
                              std::span<const ObjSmoothing> smoothing) {
  std::vector<std::uint32_t> groups;
  std::vector<Double3> flat;
  std::unordered_map<InGroup, Double3, HashOfNumbers> sums;
  std::size_t next = 0;
  std::uint32_t group = 0;
  for (const ObjFace& face : faces) {
    while (next < smoothing.size() && smoothing[next].firstFace <= face.number)
      group = smoothing[next++].group;
    groups.push_back(group);
    flat.push_back(face.positions.empty() ? Double3{} : unitOr0(areaOf(positions, face)));
    if (group == 0) continue;
    for (std::size_t i = 0; i < face.positions.size(); ++i) {
      Double3& sum = sums[{face.positions[i], group}];
      sum = sum + angleOfCorner(positions, face, i) * flat.back();
    }
  }
  ObjNormals made;
  std::unordered_map<WithNormal, std::uint32_t, HashOfNumbers> known;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::uint32_t position : faces[f].positions) {
      const Vec3 normal =
          toFloat(groups[f] == 0 ? flat[f] : unitOr0(sums.at({position, groups[f]})));
      const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(normal);
      const auto [entry, isNew] = known.try_emplace(
          {position, bits[0], bits[1], bits[2]}, static_cast<std::uint32_t>(made.normals.size()));
      if (isNew) made.normals.push_back(normal);
      made.ofCorner.push_back(entry->second);
    }
  return made;
}

}  // namespace opaline::scene

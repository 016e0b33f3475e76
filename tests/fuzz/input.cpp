#include "input.h"

#include "opaline/error.h"
#include "scene/raw_scene.h"
#include "scene/repair/repair.h"

namespace opaline::fuzz {

namespace {

constexpr std::uint32_t mostVertices = 64;
constexpr std::uint32_t mostObjects = 4;

float coordinate(Input& input, std::uint32_t kind) {
  switch (kind) {
    case 0:
      return static_cast<float>(input.below(5));
    case 1: {
      float x = 1;
      for (std::uint32_t steps = input.below(4); steps > 0; --steps) x = std::nextafter(x, 2.0F);
      return x;
    }
    case 2:
      return static_cast<float>(input.take<std::int8_t>()) * input.magnitude();
    default:
      return std::clamp(input.finite(), -1e7F, 1e7F);
  }
}

/// Every object from 0 on has a triangle.
void closeGaps(std::vector<std::uint32_t>& objects) {
  std::array<std::uint32_t, mostObjects> number{};
  for (const std::uint32_t object : objects) number[object] = 1;
  std::uint32_t next = 0;
  for (std::uint32_t& one : number) one = one != 0 ? next++ : 0;
  for (std::uint32_t& object : objects) object = number[object];
}

}  // namespace

awkward::Shape meshFrom(Input& input, std::size_t mostTriangles) {
  awkward::Shape shape{"fuzzed", {}, {}, {}};
  const std::uint32_t vertices = 3 + input.below(mostVertices - 2);
  const std::uint32_t kind = input.below(5);
  const std::uint32_t objects = 1 + input.below(mostObjects);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    // Of the last kind every vertex chooses for itself.
    const std::uint32_t own = kind < 4 ? kind : input.below(4);
    Vec3 place{};
    for (float& x : place) x = coordinate(input, own);
    shape.positions.push_back(place);
  }
  while (!input.ended() && shape.triangles.size() < mostTriangles) {
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) corner = input.below(vertices);
    shape.triangles.push_back(triangle);
    shape.objects.push_back(objects > 1 ? input.below(objects) : 0);
  }
  closeGaps(shape.objects);
  return shape;
}

awkward::Shape repairedMeshFrom(Input& input) {
  const awkward::Shape shape = meshFrom(input);
  awkward::Shape repaired{"repaired", {}, {}, {}};
  for (std::uint32_t object = 0; object < mostObjects; ++object) {
    scene::RawMesh mesh;
    mesh.positions = shape.positions;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t)
      if (shape.objects[t] == object) mesh.triangles.push_back(shape.triangles[t]);
    try {
      scene::repairMesh(mesh, "fuzzed");
    } catch (const Error&) {
      continue;
    }
    const auto first = static_cast<std::uint32_t>(repaired.positions.size());
    repaired.positions.insert(repaired.positions.end(), mesh.positions.begin(),
                              mesh.positions.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      repaired.triangles.push_back({first + a, first + b, first + c});
      repaired.objects.push_back(object);
    }
  }
  closeGaps(repaired.objects);
  return repaired;
}

}  // namespace opaline::fuzz

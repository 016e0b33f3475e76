#include "scene/vertex_attributes.h"

#include "scene/raw_scene.h"

namespace opaline::scene {

namespace {

template <typename T>
void join(std::vector<T>& to, std::size_t had, const std::vector<T>& more, std::size_t all,
          const T& missing) {
  if (to.empty() && more.empty()) return;
  to.resize(had, missing);
  to.insert(to.end(), more.begin(), more.end());
  to.resize(all, missing);
}

template <typename T>
void gather(std::vector<T>& values, const std::vector<Provenance>& origins) {
  if (values.empty()) return;
  std::vector<T> gathered;
  gathered.reserve(origins.size());
  for (const Provenance& of : origins) gathered.push_back(values[of.vertex]);
  values = std::move(gathered);
}

}  // namespace

void appendAttributes(VertexAttributes& to, VertexAttributes&& more) {
  const std::size_t had = to.vertices;
  to.vertices += more.vertices;
  for (std::size_t set = 0; set < 2; ++set)
    join(to.textureCoordinates[set], had, more.textureCoordinates[set], to.vertices, Vec2{});
  join(to.colors, had, more.colors, to.vertices, {1, 1, 1, 1});
}

void alignAttributes(RawObject& object) {
  VertexAttributes& attributes = object.attributes;
  const std::vector<Provenance>& origins = object.mesh.provenance;
  for (std::vector<Vec2>& set : attributes.textureCoordinates) gather(set, origins);
  gather(attributes.colors, origins);
  attributes.vertices = origins.size();
}

}  // namespace opaline::scene

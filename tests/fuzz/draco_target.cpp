#include <fmt/format.h>

#include "input.h"
#include "loading.h"
#include "scene/gltf/glb.h"

// Numbers of vertices and indices, then the stream.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const std::uint32_t vertices = 1 + input.below(256);
  const std::uint32_t indices = 3 * (1 + input.below(256));
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_draco_mesh_compression"],"nodes":[)"
      R"({{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":2,)"
      R"("TEXCOORD_0":3}},"indices":1,"extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,)"
      R"("attributes":{{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}}}}}}}]}}],"accessors":[)"
      R"({{"componentType":5126,"count":{0},"type":"VEC3"}},)"
      R"({{"componentType":5125,"count":{1},"type":"SCALAR"}},)"
      R"({{"componentType":5126,"count":{0},"type":"VEC3"}},)"
      R"({{"componentType":5126,"count":{0},"type":"VEC2"}}],"bufferViews":[{{"buffer":0,)"
      R"("byteLength":{2}}}],"buffers":[{{"byteLength":{2}}}]}})",
      vertices, indices, input.rest().size());
  fuzz::expectSoundOrRefused(scene::loadGltf, "a.glb", test::glb(json, std::string(input.rest())));
  return 0;
}

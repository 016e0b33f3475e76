#include <fmt/format.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <array>
#include <vector>

#include "input.h"
#include "loading.h"
#include "scene/gltf/glb.h"
#include "scene/gltf/meshopt_attributes.h"

namespace {

using namespace opaline;

/// What both decoders take for a sound stream they read alike.
void compareDecoders(std::string_view stream, std::size_t stride, std::size_t count) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(stream.data());
  std::vector<unsigned char> ours(stride * count);
  std::vector<unsigned char> theirs(stride * count);
  const bool sound = scene::decodeMeshoptAttributes({bytes, stream.size()}, stride, ours);
  const bool theirsSound =
      meshopt_decodeVertexBuffer(theirs.data(), count, stride, bytes, stream.size()) == 0;
  if (sound && theirsSound) {
    EXPECT_EQ(ours, theirs);
  }
}

}  // namespace

// Mode, filter, stride and count, then the stream.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array modes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
  constexpr std::array filters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
  fuzz::Input input(data, size);
  const char* mode = modes.at(input.below(modes.size()));
  const char* filter = filters.at(input.below(filters.size()));
  const std::size_t stride = 2 * (1 + input.below(128));
  const std::size_t count = input.below(1024);
  if (stride % 4 == 0 && count > 0) compareDecoders(input.rest(), stride, count);
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_meshopt_compression"],"nodes":[)"
      R"({{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":{4},"type":"VEC3"}}],"bufferViews":[)"
      R"({{"buffer":1,"byteLength":{5},"byteStride":{3},"extensions":{{"KHR_meshopt_compression":)"
      R"({{"buffer":0,"byteLength":{0},"byteStride":{3},"count":{4},"mode":"{1}","filter":"{2}"}}}}}}],)"
      R"("buffers":[{{"byteLength":{0}}},{{"byteLength":{5}}}]}})",
      input.rest().size(), mode, filter, stride, count, stride * count);
  fuzz::expectSoundOrRefused(scene::loadGltf, "a.glb", test::glb(json, std::string(input.rest())));
  return 0;
}

#include <draco/compression/encode.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cstdlib>
#include <random>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/gltf/glb.h"
#include "scene/shapes.h"

// Damaged files either load as sound scenes, or are refused with an Error. The seed is fixed;
// OPALINE_MUTATIONS sets the number of mutations per format.

namespace opaline {
namespace {

std::string seedPly() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nelement face 12\nproperty list uchar int vertex_indices\n"
      "end_header\n";
  const scene::RawMesh cube = test::cube();
  for (const Vec3& p : cube.positions) {
    for (const float x : p) text += std::to_string(static_cast<int>(x)) + " ";
  }
  for (const Triangle& t : cube.triangles) {
    text += "\n3";
    for (const std::uint32_t v : t) text += " " + std::to_string(v);
  }
  return text;
}

std::string seedBinaryPly() {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\n"
      "property float y\nproperty float z\nelement face 12\n"
      "property list uchar uint vertex_indices\nend_header\n";
  const scene::RawMesh cube = test::cube();
  for (const Vec3& p : cube.positions) bytes += test::raw<float>({p[0], p[1], p[2]});
  for (const Triangle& t : cube.triangles) {
    bytes += '\3' + test::raw<std::uint32_t>({t[0], t[1], t[2]});
  }
  return bytes;
}

std::string seedObj() {
  return "o cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
         "vn 0 0 1\nusemtl ketchup\nf 1 3 4 2\nf 5//1 6//1 8//1 7//1\nusemtl marble\n"
         "f -8 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

std::string seedGlb() {
  const std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],"nodes":[{"children":[1],)"
      R"("scale":[1,2,-1]},{"mesh":0,"skin":0,"rotation":[0,0,0,1]},{"camera":0,"extensions":)"
      R"({"KHR_lights_punctual":{"light":0}}}],"skins":[{"joints":[0,1]}],"cameras":[{"type":)"
      R"("perspective","perspective":{"yfov":0.5,"znear":0.1}}],"extensions":{"KHR_lights_punctual":)"
      R"({"lights":[{"type":"point","intensity":5}]}},"materials":[{"name":"wax","extras":)"
      R"({"sigma_s_prime_per_mm":[1,2,3],"sigma_a_per_mm":[1,1,1]}}],"meshes":[{"weights":[0.5],)"
      R"("primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1,)"
      R"("material":0,"targets":[{"POSITION":4}]}]}],"accessors":[{"bufferView":0,"componentType":)"
      R"(5126,"count":4,"type":"VEC3"},{"bufferView":0,"byteOffset":48,"componentType":5123,)"
      R"("count":12,"type":"SCALAR"},{"bufferView":1,"componentType":5121,"count":4,"type":"VEC4"},)"
      R"({"bufferView":1,"byteOffset":16,"componentType":5121,"normalized":true,"count":4,"type":)"
      R"("VEC4"},{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,"indices":)"
      R"({"bufferView":1,"componentType":5121},"values":{"bufferView":0,"byteOffset":12}}}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":32}],)"
      R"("buffers":[{"byteLength":104}]})";
  std::string binary = test::raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
                       test::raw<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  for (int i = 0; i < 32; ++i) binary += i % 4 == 0 ? '\1' : '\0';
  return test::glb(json, binary);
}

/// Two clips with all interpolations move a skinned and a morphed mesh.
std::string seedAnimation() {
  const std::string json =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"skin":0},{"children":[2]},{"mesh":1,)"
      R"("translation":[1,0,0]}],"skins":[{"joints":[1,2]}],"meshes":[{"primitives":[{"attributes":)"
      R"({"POSITION":0,"NORMAL":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]},{"weights":[0.5],)"
      R"("primitives":[{"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":0}]}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":0,)"
      R"("byteOffset":48,"componentType":5123,"count":12,"type":"SCALAR"},{"bufferView":1,)"
      R"("componentType":5121,"count":4,"type":"VEC4"},{"bufferView":1,"byteOffset":16,)"
      R"("componentType":5121,"normalized":true,"count":4,"type":"VEC4"},{"bufferView":2,)"
      R"("componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":2,"byteOffset":8,)"
      R"("componentType":5126,"count":2,"type":"VEC3"},{"bufferView":2,"componentType":5126,)"
      R"("count":2,"type":"VEC4"},{"bufferView":2,"componentType":5126,"count":6,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":32},)"
      R"({"buffer":0,"byteOffset":104,"byteLength":32}],"animations":[{"name":"a","samplers":[)"
      R"({"input":4,"output":5},{"input":4,"output":6,"interpolation":"STEP"},{"input":4,"output":7,)"
      R"("interpolation":"CUBICSPLINE"}],"channels":[{"sampler":0,"target":{"node":1,"path":)"
      R"("translation"}},{"sampler":1,"target":{"node":1,"path":"rotation"}},{"sampler":2,"target":)"
      R"({"node":2,"path":"weights"}}]},{"samplers":[{"input":4,"output":5}],"channels":[{"sampler":)"
      R"(0,"target":{"node":2,"path":"scale"}}]}],"buffers":[{"byteLength":136}]})";
  std::string binary = test::raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
                       test::raw<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  for (int i = 0; i < 32; ++i) binary += i % 4 == 0 ? '\1' : '\0';
  return test::glb(json, binary + test::raw<float>({0, 1, 0, 0, 0.5F, 1, 1, 1}));
}

/// The tetrahedron of seedGlb(), compressed by both extensions.
std::string seedMeshopt() {
  const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::uint16_t> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, 12));
  vertices.resize(
      meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), corners.data(), 4, 12));
  std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(12, 4));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), faces.data(), 12));
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["EXT_meshopt_compression"],"nodes":[)"
      R"({{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
      R"("accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},)"
      R"({{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}}],"bufferViews":[)"
      R"({{"buffer":1,"byteLength":48,"extensions":{{"EXT_meshopt_compression":{{"buffer":0,)"
      R"("byteLength":{0},"byteStride":12,"count":4,"mode":"ATTRIBUTES"}}}}}},{{"buffer":1,)"
      R"("byteOffset":48,"byteLength":24,"extensions":{{"EXT_meshopt_compression":{{"buffer":0,)"
      R"("byteOffset":{0},"byteLength":{1},"byteStride":2,"count":12,"mode":"TRIANGLES"}}}}}}],)"
      R"("buffers":[{{"byteLength":{2}}},{{"byteLength":72}}]}})",
      vertices.size(), indices.size(), vertices.size() + indices.size());
  return test::glb(json, test::raw(vertices) + test::raw(indices));
}

std::string seedDraco() {
  const scene::RawMesh cube = test::cube();
  draco::Mesh mesh;
  mesh.set_num_points(8);
  for (const Triangle& t : cube.triangles) {
    mesh.AddFace({draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
  }
  draco::GeometryAttribute attribute;
  attribute.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh.AddAttribute(attribute, true, 8);
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &cube.positions[i]);
  }
  draco::Encoder encoder;
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 8);
  draco::EncoderBuffer buffer;
  encoder.EncodeMeshToBuffer(mesh, &buffer);
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_draco_mesh_compression"],"nodes":[)"
      R"({{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,)"
      R"("extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,"attributes":{{"POSITION":0)"
      R"(}}}}}}}}]}}],"accessors":[{{"componentType":5126,"count":8,"type":"VEC3"}},)"
      R"({{"componentType":5123,"count":36,"type":"SCALAR"}}],"bufferViews":[{{"buffer":0,)"
      R"("byteLength":{0}}}],"buffers":[{{"byteLength":{0}}}]}})",
      buffer.size());
  return test::glb(json, {buffer.data(), buffer.size()});
}

std::string seedToml() {
  return "model = 'seed.ply'\ndiagonal_mm = 20\n[media.soap]\nsigma_s_per_mm = [1, 2, 3]\n"
         "sigma_a_per_mm = [0.1, 0.1, 0.1]\n[objects.seed]\nmedium = 'soap'\nscale = 2\n"
         "rotation_degrees = [1, 2, 3]\n[[lights]]\ntype = 'point'\nposition_mm = [1, 2, 3]\n"
         "intensity = 4\n[camera]\ndirection = [0, 1, 1]\n[[deform]]\nkind = 'twist'\namount = "
         "0.5\n"
         "period_seconds = 2\n[render]\nsize = [64, 64]\nseconds = 1\n";
}

std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t limit) { return random() % limit; };
  const std::size_t changes = 1 + below(4);
  static const std::string interesting[] = {
      "-1", "0",    "99999999999",        "nan",        "1e999", "{", "[",
      "\"", "\xFF", std::string(1, '\0'), "4294967295", "e",     "."};
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1U << below(8)));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, below(20));
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        break;
      default:
        bytes.replace(at, 1, interesting[below(std::size(interesting))]);
        break;
    }
  }
  return bytes;
}

struct Seed {
  const char* file;
  std::string (*bytes)();
};

class Mutations : public testing::TestWithParam<Seed> {};

TEST_P(Mutations, LoadSoundlyOrAreRefused) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder / "seed.ply", seedPly());
  const char* wanted = std::getenv("OPALINE_MUTATIONS");
  const int count = wanted != nullptr ? std::atoi(wanted) : 400;
  const std::string seed = GetParam().bytes();
  test::writeBytes(folder / GetParam().file, seed);
  test::expectSound(loadScene(folder / GetParam().file));
  std::mt19937 random(20081213);
  int loaded = 0;
  for (int i = 0; i < count; ++i) {
    const std::string bytes = mutated(seed, random);
    test::writeBytes(folder / GetParam().file, bytes);
    try {
      test::expectSound(loadScene(folder / GetParam().file));
      ++loaded;
    } catch (const Error& error) {
      ASSERT_NE(std::string(error.what()), "");
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "mutation " << i;
  }
  EXPECT_GT(loaded, 0);
  EXPECT_LT(loaded, count);
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutations,
                         testing::Values(Seed{"ascii.ply", seedPly},
                                         Seed{"binary.ply", seedBinaryPly}, Seed{"a.obj", seedObj},
                                         Seed{"a.glb", seedGlb}, Seed{"moving.glb", seedAnimation},
                                         Seed{"meshopt.glb", seedMeshopt},
                                         Seed{"draco.glb", seedDraco}, Seed{"a.toml", seedToml}));

}  // namespace
}  // namespace opaline

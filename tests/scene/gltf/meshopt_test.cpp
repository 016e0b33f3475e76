// Files with EXT_meshopt_compression and KHR_meshopt_compression. Streams are made by
// meshoptimizer, or by hand from the specification where it cannot make them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/gltf/gltf_fixture.h"
#include "scene/gltf/meshopt_streams.h"

namespace opaline {
namespace {

using test::Bytes;
using test::encodedAttributes;
using test::Gltf;
using test::Parts;
using test::raw;
using test::tetrahedron;
using test::tetrahedronFaces;
using testing::HasSubstr;

Bytes encodedTriangles(const std::vector<std::uint16_t>& indices) {
  Bytes bytes(meshopt_encodeIndexBufferBound(indices.size(), 65536));
  meshopt_encodeIndexVersion(1);
  bytes.resize(
      meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}

Bytes encodedIndices(const std::vector<std::uint16_t>& indices) {
  Bytes bytes(meshopt_encodeIndexSequenceBound(indices.size(), 65536));
  meshopt_encodeIndexVersion(1);
  bytes.resize(
      meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}

/// One view of a file and its compression.
struct Compressed {
  Bytes stream;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode = "ATTRIBUTES";
  std::string filter{};
  std::string more{};  ///< more members of the view
};

const Compressed positions{encodedAttributes(tetrahedron, 12), 4, 12};
const Compressed faces{encodedTriangles(tetrahedronFaces), 12, 2, "TRIANGLES"};
const Compressed sequence{encodedIndices(tetrahedronFaces), 12, 2, "INDICES"};

struct Packed {
  Parts parts;
  std::string binary;
};

const char* const placeholder = R"(,{"byteLength":4000,"extensions":{"%":{"fallback":true}}})";

Packed packed(const std::vector<Compressed>& views,
              const std::string& extension = "EXT_meshopt_compression",
              std::string second = placeholder) {
  Packed result;
  result.parts.views.clear();
  std::size_t offset = 0;
  for (const Compressed& of : views) {
    const std::string filter = of.filter.empty() ? "" : fmt::format(R"(,"filter":"{}")", of.filter);
    result.parts.views += fmt::format(
        R"({}{{"buffer":1,"byteOffset":{},"byteLength":{}{},"extensions":{{"{}":{{"buffer":0,)"
        R"("byteOffset":{},"byteLength":{},"byteStride":{},"count":{},"mode":"{}"{}}}}}}})",
        offset == 0 ? "" : ",", offset, of.count * of.stride, of.more, extension,
        result.binary.size(), of.stream.size(), of.stride, of.count, of.mode, filter);
    offset += of.count * of.stride;
    result.binary += raw(of.stream);
    while (result.binary.size() % 4 != 0) result.binary += '\0';
  }
  if (const auto name = second.find('%'); name != std::string::npos) {
    second.replace(name, 1, extension);
  }
  result.parts.buffers = fmt::format(R"({{"byteLength":{}}})", result.binary.size()) + second;
  result.parts.more = fmt::format(
      R"(,"extensionsUsed":["{0}"],"extensionsRequired":["{0}","KHR_mesh_quantization"])",
      extension);
  return result;
}

class Meshopt : public Gltf {
 protected:
  Scene loadPacked(const Packed& of) { return load(of.parts, of.binary); }

  /// The error after replacing one piece of the file's JSON.
  std::string errorWith(Packed of, const std::string& old, const std::string& by) {
    of.parts.views = test::changed(of.parts.views, old, by);
    return errorOf(of.parts, of.binary);
  }
};

TEST_F(Meshopt, GivesTheSameAsWithout) {
  const Scene plain = load({});
  const std::vector<std::string> buffers{
      placeholder,
      R"(,{"byteLength":4000})",
      R"(,{"byteLength":4000,"uri":"is not here.bin","extensions":{"%":{"fallback":true}}})",
      R"(,{"byteLength":72,"uri":"data:application/octet-stream;base64,)" + std::string(96, 'A') +
          R"("})",
  };
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (const std::string& second : buffers) {
      const Scene scene = loadPacked(packed({positions, sequence}, extension, second));
      ASSERT_EQ(scene.objects.size(), 1U);
      EXPECT_EQ(scene.objects[0].mesh.positionsMm, plain.objects[0].mesh.positionsMm);
      EXPECT_EQ(scene.objects[0].mesh.triangles, plain.objects[0].mesh.triangles);
    }
  }
}

// This mode may rotate a triangle's corners.
TEST_F(Meshopt, ReadsTriangles) {
  const Scene scene = loadPacked(packed({positions, faces}));
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 4U);
  EXPECT_NEAR(volumeMm3(scene), 1e9 / 6, 1);
}

TEST_F(Meshopt, FiltersExponential) {
  std::vector<std::uint32_t> packedNumbers(12);
#if MESHOPTIMIZER_VERSION >= 190
  meshopt_encodeFilterExp(packedNumbers.data(), 4, 12, 16, tetrahedron.data(),
                          meshopt_EncodeExpSharedVector);
#else
  meshopt_encodeFilterExp(packedNumbers.data(), 4, 12, 16, tetrahedron.data());
#endif
  const Compressed filtered{encodedAttributes(packedNumbers, 12), 4, 12, "ATTRIBUTES",
                            "EXPONENTIAL"};
  EXPECT_NEAR(volumeMm3(loadPacked(packed({filtered, faces}))), 1e9 / 6, 1);
}

TEST_F(Meshopt, FiltersOctahedral) {
  // Outward normals of a tetrahedron's corners, in no special direction.
  const double root = std::sqrt(3.0);
  std::vector<float> normals;
  for (const std::array<double, 3> n :
       {std::array{-1 / root, -1 / root, -1 / root}, std::array{0.96, -0.28, 0.0},
        std::array{-0.48, 0.8, -0.36}, std::array{0.0, -0.6, 0.8}}) {
    for (const double c : n) normals.push_back(static_cast<float>(c));
    normals.push_back(0);
  }
  std::vector<std::int16_t> octahedral(16);
  meshopt_encodeFilterOct(octahedral.data(), 4, 8, 16, normals.data());
  const Compressed filtered{
      encodedAttributes(octahedral, 8), 4, 8, "ATTRIBUTES", "OCTAHEDRAL", R"(,"byteStride":8)"};
  Packed file = packed({positions, faces, filtered});
  file.parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":2},"indices":1}]})";
  file.parts.accessors +=
      R"(,{"bufferView":2,"componentType":5122,"normalized":true,"count":4,"type":"VEC3"})";
  const Scene scene = loadPacked(file);
  ASSERT_EQ(scene.objects[0].mesh.normals.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      // 16 bits, decoded to one unit in the last place.
      EXPECT_NEAR(scene.objects[0].mesh.normals[i][c], normals[4 * i + c], 3.0 / 32767);
    }
  }
}

TEST_F(Meshopt, FiltersQuaternions) {
  // A third of a turn about the diagonal: x becomes y, y becomes z.
  const std::vector<float> turn{0.5F, 0.5F, 0.5F, 0.5F};
  std::vector<std::int16_t> quaternion(4);
  meshopt_encodeFilterQuat(quaternion.data(), 1, 8, 16, turn.data());
  const Compressed filtered{encodedAttributes(quaternion, 8), 1, 8, "ATTRIBUTES", "QUATERNION"};
  const Compressed longX{
      encodedAttributes(std::vector<float>{0, 0, 0, 4, 0, 0, 0, 2, 0, 0, 0, 1}, 12), 4, 12};
  Packed file = packed({longX, faces, filtered});
  file.parts.nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
      "ROTATION":2}}}})";
  file.parts.accessors +=
      R"(,{"bufferView":2,"componentType":5122,"normalized":true,"count":1,"type":"VEC4"})";
  const Bounds bounds = boundsOf(loadPacked(file));
  EXPECT_NEAR(bounds.maxMm[0] - bounds.minMm[0], 1000, 1);
  EXPECT_NEAR(bounds.maxMm[1] - bounds.minMm[1], 4000, 1);
  EXPECT_NEAR(bounds.maxMm[2] - bounds.minMm[2], 2000, 1);
}

/// Black, red, green and blue of a value, in luma, orange and green chroma (appendix B, filter 4).
template <typename T>
std::vector<T> colors(int value, int alpha) {
  std::vector<T> result;
  const int half = value / 2;
  const int quarter = value / 4;
  for (const std::array<int, 4>& c :
       {std::array{0, 0, 0, alpha}, std::array{quarter, half, -quarter, alpha},
        std::array{half, 0, half, alpha}, std::array{quarter, -half, -quarter, alpha}}) {
    for (const int number : c) result.push_back(static_cast<T>(number));
  }
  return result;
}

TEST_F(Meshopt, FiltersColors) {
  // As positions, they make a tetrahedron whose edges are that value.
  const auto volume = [&](const Bytes& stream, std::size_t stride, int componentType) {
    const Compressed filtered{stream,       4,       stride,
                              "ATTRIBUTES", "COLOR", fmt::format(R"(,"byteStride":{})", stride)};
    Packed file = packed({filtered, faces}, "KHR_meshopt_compression");
    file.parts.accessors =
        fmt::format(R"({{"bufferView":0,"componentType":{},"count":4,"type":"VEC3"}},)"
                    R"({{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}})",
                    componentType);
    return volumeMm3(loadPacked(file)) / 1e9;
  };
  const auto eight = [&](int value, int alpha) {
    return volume(encodedAttributes(colors<std::uint8_t>(value, alpha), 4), 4, 5121);
  };
  // As many bits as alpha has: all 8, or 4 of them, where 12 means 12/15.
  EXPECT_NEAR(eight(240, 0xff), std::pow(240.0, 3) / 6, 1e-3);
  EXPECT_NEAR(eight(12, 0x0b), std::pow(255.0 * 12 / 15, 3) / 6, 1e-3);
  const double sixteen = volume(encodedAttributes(colors<std::uint16_t>(3276, 0xfff), 8), 8, 5123);
  EXPECT_NEAR(sixteen / (std::pow(65535 * 0.8, 3) / 6), 1, 1e-6);
}

TEST_F(Meshopt, ViewsThatLieAreErrors) {
  const Packed file = packed({positions, faces});
  const std::string positionStride = R"("byteStride":12)";
  EXPECT_THAT(errorWith(file, positionStride, R"("byteStride":0)"),
              HasSubstr("elements of 0 bytes"));
  EXPECT_THAT(errorWith(file, positionStride, R"("byteStride":6)"),
              HasSubstr("elements of 6 bytes"));
  EXPECT_THAT(errorWith(file, positionStride, R"("byteStride":260)"),
              HasSubstr("elements of 260 bytes"));
  EXPECT_THAT(errorWith(file, R"("byteStride":2)", R"("byteStride":1)"),
              HasSubstr("elements of 1 bytes"));
  EXPECT_THAT(errorWith(file, positionStride, R"("byteStride":-12)"), HasSubstr("negative"));
  EXPECT_THAT(errorWith(file, positionStride, R"("stride":12)"), HasSubstr("'byteStride'"));
  EXPECT_THAT(errorWith(file, R"("count":4)", R"("count":5)"), HasSubstr("5 elements of 12 bytes"));
  EXPECT_THAT(errorWith(file, R"("count":4)", R"("count":4000000000)"), HasSubstr("'count'"));
  EXPECT_THAT(errorWith(file, R"("count":12)", R"("count":11)"), HasSubstr("has 11 indices"));
  EXPECT_THAT(errorWith(file, R"("mode":"ATTRIBUTES")", R"("mode":"BALLADS")"),
              HasSubstr("the mode 'BALLADS'"));
  EXPECT_THAT(errorWith(file, R"("mode":"ATTRIBUTES")", R"("mode":3)"), HasSubstr("mode ''"));
  EXPECT_THAT(errorWith(file, R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"RED")"),
              HasSubstr("the filter 'RED'"));
  EXPECT_THAT(
      errorWith(file, R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"QUATERNION")"),
      HasSubstr("does not allow"));
  EXPECT_THAT(
      errorWith(file, R"("mode":"TRIANGLES")", R"("mode":"TRIANGLES","filter":"EXPONENTIAL")"),
      HasSubstr("does not allow"));
  EXPECT_THAT(errorWith(file, R"("buffer":0,"byteOffset":0)", R"("buffer":0,"byteOffset":9999)"),
              HasSubstr("beyond the end of its compressed buffer"));
  EXPECT_THAT(
      errorWith(file, R"("buffer":0,"byteOffset":0)", R"("buffer":0,"byteOffset":4294967296)"),
      HasSubstr("'byteOffset'"));
  EXPECT_THAT(errorWith(file, R"("buffer":0)", R"("buffer":7)"), HasSubstr("does not exist"));
  EXPECT_THAT(errorWith(file, R"("extensions")", R"("extras")"), HasSubstr("beyond the end"));
}

TEST_F(Meshopt, StreamsThatAreDamagedAreErrors) {
  for (const std::size_t view : {0U, 1U, 2U}) {
    std::vector<Compressed> views{positions, faces, sequence};
    Bytes& stream = views[view].stream;
    stream.pop_back();
    const Packed file = packed(views);
    EXPECT_THAT(errorOf(file.parts, file.binary),
                HasSubstr(fmt::format("the compressed data of buffer view {} are damaged", view)));
    stream.assign(6, 0xa0);
    const Packed shorter = packed(views);
    EXPECT_THAT(errorOf(shorter.parts, shorter.binary), HasSubstr("damaged"));
  }
}

TEST_F(Meshopt, SizesAreNotBelieved) {
  Compressed huge = positions;
  huge.count = 100'000'000;
  const Packed file = packed({huge, faces});
  EXPECT_THAT(errorOf(file.parts, file.binary), HasSubstr("promises 1200000000 bytes"));
  // A stream that is honest but used many times.
  Compressed long1{encodedAttributes(Bytes(40'000'000), 4), 10'000'000, 4};
  Packed repeated = packed({long1});
  const std::string view = repeated.parts.views;
  for (int i = 0; i < 30; ++i) repeated.parts.views += "," + view;
  EXPECT_THAT(errorOf(repeated.parts, repeated.binary), HasSubstr("grow to more than"));
}

}  // namespace
}  // namespace opaline

// Files that lie: each causes an error that names it, and no header's claim causes an allocation.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/gltf/gltf_fixture.h"

namespace opaline {
namespace {

using test::Gltf;
using test::Parts;
using test::tetrahedron;
using test::tetrahedronBytes;
using test::tetrahedronFaces;
using testing::HasSubstr;

TEST_F(Gltf, GraphsThatAreNoTreesAreErrors) {
  Parts parts;
  parts.nodes = R"({"mesh":0,"children":[1]},{"children":[0]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("cycle"));
  parts.nodes = R"({"mesh":0,"children":[0]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("cycle"));
  parts.nodes = R"({"mesh":0,"children":[2]},{"children":[2]},{})";
  EXPECT_THAT(errorOf(parts), HasSubstr("two parents"));
  parts.nodes = R"({"mesh":0,"children":[7]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("child 7"));
  parts.nodes = R"({"mesh":3})";
  EXPECT_THAT(errorOf(parts), HasSubstr("mesh 3"));
  parts = {};
  parts.scene = R"("scene":9,"scenes":[{"nodes":[0]}],)";
  EXPECT_THAT(errorOf(parts), HasSubstr("scene 9"));
  parts.scene = R"("scenes":[{"nodes":[]}],)";
  EXPECT_THAT(errorOf(parts), HasSubstr("no triangle mesh"));
}

TEST_F(Gltf, ScenesTooSmallOrTooLargeForTheirNumbersAreErrors) {
  Parts parts;
  for (const char* scale : {"1e-12", "1e-30", "1e9"}) {
    parts.nodes = fmt::format(R"({{"mesh":0,"scale":[{0},{0},{0}]}})", scale);
    EXPECT_THAT(errorOf(parts), HasSubstr("its diagonal is")) << scale;
  }
  parts.nodes = R"({"mesh":0,"scale":[1e-8,1e-8,1e-8]})";
  EXPECT_EQ(load(parts).objects.size(), 1U);
}

std::string withAccessor0(const std::string& accessor) {
  return accessor + R"(,{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
}

TEST_F(Gltf, AccessorsThatLieAreErrors) {
  const char* accessors[] = {
      R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})",
      R"({"bufferView":0,"componentType":5126,"count":4000000000000,"type":"VEC3"})",
      R"({"bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3"})",
      R"({"bufferView":0,"byteOffset":18446744073709551612,"componentType":5126,"count":4,"type":"VEC3"})",
      R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":4,"type":"VEC3"})",
      R"({"bufferView":9,"componentType":5126,"count":4,"type":"VEC3"})",
      R"({"bufferView":-7,"componentType":5126,"count":4,"type":"VEC3"})",
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})",
      R"({"bufferView":0,"componentType":1,"count":4,"type":"VEC3"})",
      R"({"componentType":5126,"count":4000000000,"type":"VEC3"})",
      R"({"componentType":5126,"count":4,"type":"VEC3"})",  // all at one place
      R"({"bufferView":0,"componentType":5126,"count":-4,"type":"VEC3"})",
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":-1,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}})",
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":4,"indices":{"bufferView":1,"byteOffset":-5,"componentType":5123},"values":{"bufferView":0}}})",
      R"({"bufferView":0,"componentType":5126,"count":2,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}})",
  };
  for (const char* accessor : accessors) {
    Parts parts;
    parts.accessors = withAccessor0(accessor);
    EXPECT_NE(errorOf(parts), "") << accessor;
  }
}

TEST_F(Gltf, BufferViewsAndBuffersThatLieAreErrors) {
  const std::string second = R"(,{"buffer":0,"byteOffset":48,"byteLength":24})";
  for (const char* view :
       {R"({"buffer":0,"byteOffset":60,"byteLength":48})", R"({"buffer":5,"byteLength":48})",
        R"({"buffer":0,"byteOffset":18446744073709551600,"byteLength":48})",
        R"({"buffer":0,"byteLength":18446744073709551615,"byteOffset":8})",
        R"({"buffer":0,"byteLength":48,"byteStride":4})"}) {
    Parts parts;
    parts.views = view + second;
    EXPECT_NE(errorOf(parts), "") << view;
  }
  Parts parts;
  parts.buffers = R"({"byteLength":4000000000000})";
  errorOf(parts);
  parts.buffers = R"({"byteLength":72},{"byteLength":72})";
  EXPECT_THAT(errorOf(parts), HasSubstr("more than one buffer"));
  parts.buffers = R"({"byteLength":72,"uri":"data:application/octet-stream;base64,AAAA"})";
  errorOf(parts);
}

TEST_F(Gltf, BadNumbersAndIndicesAreErrors) {
  std::vector<std::uint16_t> wild = tetrahedronFaces;
  wild[7] = 4;
  EXPECT_THAT(errorOf({}, test::raw(tetrahedron) + test::raw(wild)), HasSubstr("vertex 4"));
  std::vector<float> broken = tetrahedron;
  broken[4] = NAN;
  EXPECT_THAT(errorOf({}, test::raw(broken) + test::raw(tetrahedronFaces)), HasSubstr("finite"));
  Parts parts;
  parts.nodes = R"({"mesh":0,"scale":[1e300,1e300,1e300]})";
  errorOf(parts);
  parts.nodes = R"({"mesh":0,"scale":[1e37,1e37,1e37]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("too large"));
  parts.nodes = R"({"mesh":0,"scale":[0,0,0]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("degenerate"));
  parts.nodes = R"({"mesh":0,"translation":[1,2]})";
  EXPECT_THAT(errorOf(parts), HasSubstr("node 0"));
}

TEST_F(Gltf, ManyInstancesAreRefusedBeforeMemoryIs) {
  Parts parts;
  const int count = 3000;
  parts.nodes.clear();
  std::string list;
  for (int i = 0; i < count; ++i) {
    parts.nodes += i == 0 ? R"({"mesh":0})" : R"(,{"mesh":0})";
    list += (i == 0 ? "" : ",") + std::to_string(i);
  }
  parts.scene = R"("scenes":[{"nodes":[)" + list + "]}],";
  // Fans of 16,000 triangles, each with its own vertices as there are no normals.
  std::vector<std::uint16_t> fan(16'000);
  for (std::size_t i = 0; i < fan.size(); ++i) fan[i] = static_cast<std::uint16_t>(i % 4);
  parts.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                       {"bufferView":1,"componentType":5123,"count":16000,"type":"SCALAR"})";
  parts.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32000})";
  parts.buffers = R"({"byteLength":32048})";
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":6}]})";
  EXPECT_THAT(errorOf(parts, test::raw(tetrahedron) + test::raw(fan)), HasSubstr("more than"));
}

TEST_F(Gltf, BrokenContainersAndJsonAreErrors) {
  const std::string whole = test::glb(Parts{}.json(), tetrahedronBytes());
  for (std::size_t size = 1; size < whole.size(); size += 11) {
    EXPECT_NE(test::messageOf([&] { loadBytes(whole.substr(0, size)); }), "");
  }
  const auto textError = [&](const std::string& json) {
    test::writeBytes(folder / "a.gltf", json);
    return test::messageOf([&] { loadScene(folder / "a.gltf"); });
  };
  EXPECT_THAT(textError(std::string(100'000, '[')), HasSubstr("nested"));
  EXPECT_THAT(textError("{\"a\":" + std::string(100'000, '{')), HasSubstr("JSON"));
  EXPECT_THAT(textError("{\"asset\":{\"version\":\"2.0\"},\"x\":\"\xFF\xFE\"}"), HasSubstr("JSON"));
  EXPECT_THAT(textError("{ \"a\": 1 }"), HasSubstr("asset"));
  EXPECT_THAT(textError(R"({"asset":{"version":"1.0"}})"), HasSubstr("'1.0'"));
  EXPECT_THAT(textError(R"({"asset":{"version":"2.1","minVersion":"2.1"},"nodes":[5]})"),
              HasSubstr("a.gltf: it needs a reader of glTF version '2.1'"));
  EXPECT_THAT(textError(R"({"asset":{"version":"2.0"},"nodes":[5]})"), HasSubstr("glTF"));
  EXPECT_THAT(
      textError(R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":5}]}]})"),
      HasSubstr("a.gltf"));
  for (const char* text : {"hello", "[]", "[{\"asset\":1}]", "1", "\"glTF\""})
    EXPECT_THAT(textError(text), testing::EndsWith("a.gltf: it is not a glTF file")) << text;
  const std::string buffer = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":72}]})";
  EXPECT_THAT(textError(buffer), HasSubstr("a buffer has no 'uri', which only a .glb file may"));
  EXPECT_THAT(textError(test::changed(buffer, "72", R"(72,"uri":"https://example.com/a%20b.bin")")),
              HasSubstr("its buffer 'https://example.com/a b.bin' is on the network"));
}

TEST_F(Gltf, WhatIsNoJsonIsNoGltf) {
  const auto complaint = [&](const std::string& bytes) {
    return test::messageOf([&] { loadBytes(bytes); });
  };
  EXPECT_THAT(complaint("\x89PNG\r\n\x1A\n"), testing::EndsWith("a.glb: it is not a glTF file"));
  EXPECT_THAT(complaint("this is no glTF"), testing::EndsWith("a.glb: it is not a glTF file"));
  EXPECT_THAT(complaint("{\"asset\":,}"),
              testing::EndsWith("a.glb: its JSON is damaged at byte 10"));
}

}  // namespace
}  // namespace opaline

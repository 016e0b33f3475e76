#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bssrdf/profile.h"
#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/gltf/gltf_fixture.h"

namespace opaline {
namespace {

using test::Gltf;
using test::Parts;
using test::tetrahedronBytes;
using testing::HasSubstr;

TEST_F(Gltf, MetresBecomeMillimetresAndMissingNormalsAreFlat) {
  const Scene scene = load({});
  test::expectSound(scene);
  EXPECT_TRUE(scene.repairs.empty());
  EXPECT_EQ(scene.objects[0].name, "tetra");
  EXPECT_EQ(scene.objects[0].medium.name, "marble");
  EXPECT_EQ(boundsOf(scene).maxMm, (Vec3{1000, 1000, 1000}));
  const Mesh& mesh = scene.objects[0].mesh;
  ASSERT_EQ(mesh.positionsMm.size(), 12U);
  EXPECT_EQ(mesh.normals[0], (Vec3{0, 0, -1}));
  EXPECT_EQ(mesh.normals[2], (Vec3{0, 0, -1}));
  EXPECT_NEAR(volumeMm3(scene), 1e9 / 6, 1e3);
  EXPECT_TRUE(notes.empty());
}

TEST_F(Gltf, TransformsAreAppliedDownTheTree) {
  Parts parts;
  // A quarter turn about z, a shift, then a mirror.
  parts.nodes = R"({"children":[1],"translation":[1,0,0],"rotation":[0,0,0.70710678,0.70710678]},
                   {"mesh":0,"scale":[-2,1,1]})";
  const Scene scene = load(parts);
  EXPECT_TRUE(scene.repairs.empty());
  // x in [-2,0] becomes y, y in [0,1] becomes -x.
  const Bounds bounds = boundsOf(scene);
  EXPECT_NEAR(bounds.minMm[0], 0, 1e-3);
  EXPECT_NEAR(bounds.maxMm[0], 1000, 1e-3);
  EXPECT_NEAR(bounds.minMm[1], -2000, 1e-3);
  EXPECT_NEAR(volumeMm3(scene), 2e9 / 6, 1e4);
  parts.nodes = R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,0,0,1]})";
  EXPECT_NEAR(boundsOf(load(parts)).minMm[0], 4000, 1e-2);
}

TEST_F(Gltf, InstancesPrimitivesAndMedia) {
  Parts parts;
  parts.nodes = R"({"mesh":0,"name":"left"},{"mesh":0,"name":"ketchup","translation":[3,0,0]})";
  parts.scene = R"("scenes":[{"nodes":[0,1]}],)";
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1},
                                   {"attributes":{"POSITION":0},"mode":0},
                                   {"attributes":{"POSITION":0},"indices":1,"material":0}]})";
  parts.more = R"(,"materials":[{"name":"SkimMilk"}])";
  const Scene scene = load(parts);
  ASSERT_EQ(scene.objects.size(), 4U);
  EXPECT_EQ(scene.objects[0].medium.name, "marble");
  EXPECT_EQ(scene.objects[1].medium.name, "skimmilk");
  EXPECT_EQ(scene.objects[2].medium.name, "ketchup");
  EXPECT_EQ(scene.objects[0].name, "left (marble)");
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("points and lines")));
}

// Eleven indices make three triangles, and two are left.
TEST_F(Gltf, IncompleteTrianglesAreNamed) {
  Parts parts;
  parts.meshes = R"({"name":"body","primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  EXPECT_TRUE(load(parts).notShown.empty());
  parts.accessors = test::changed(parts.accessors, R"("count":12)", R"("count":11)");
  const Scene scene = load(parts);
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 3U);
  ASSERT_EQ(scene.notShown.size(), 1U);
  EXPECT_EQ(scene.notShown[0].what, "incomplete triangles");
  EXPECT_THAT(scene.notShown[0].names, testing::ElementsAre("body"));
  // The four vertices in order are one triangle, and one is left.
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  EXPECT_EQ(load(parts).notShown.size(), 1U);
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"mode":5}]})";
  EXPECT_TRUE(load(parts).notShown.empty());
}

TEST_F(Gltf, StripsFansAndMissingIndices) {
  const std::string square = test::raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  Parts parts;
  parts.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";
  parts.views = R"({"buffer":0,"byteLength":48})";
  parts.buffers = R"({"byteLength":48})";
  for (const int mode : {5, 6}) {
    parts.meshes =
        fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":0}},"mode":{}}}]}})", mode);
    const Scene scene = load(parts, square);
    EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 2U);
    if (mode == 5) {
      for (const Vec3& n : scene.objects[0].mesh.normals) EXPECT_EQ(n, (Vec3{0, 0, 1}));
    }
  }
}

TEST_F(Gltf, AllComponentTypesNormalisedOrNot) {
  struct Case {
    int type;
    bool normalised;
    std::string bytes;  // of 0 0 0, 1 0 0, 0 1 0 or the like
  };
  const auto three = [](auto one) {
    using T = decltype(one);
    return test::raw(std::vector<T>{0, 0, 0, one, 0, 0, 0, one, 0});
  };
  const Case cases[] = {
      {5120, true, three(std::int8_t{127})},    {5121, true, three(std::uint8_t{255})},
      {5122, true, three(std::int16_t{32767})}, {5123, true, three(std::uint16_t{65535})},
      {5120, false, three(std::int8_t{1})},     {5121, false, three(std::uint8_t{1})},
      {5122, false, three(std::int16_t{1})},    {5123, false, three(std::uint16_t{1})},
      {5125, false, three(std::uint32_t{1})},   {5126, false, three(1.0F)},
  };
  for (const Case& of : cases) {
    Parts parts;
    parts.accessors = fmt::format(
        R"({{"bufferView":0,"componentType":{},"normalized":{},"count":3,"type":"VEC3"}})", of.type,
        of.normalised);
    parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
    parts.views = fmt::format(R"({{"buffer":0,"byteLength":{}}})", of.bytes.size());
    parts.buffers = fmt::format(R"({{"byteLength":{}}})", of.bytes.size());
    EXPECT_EQ(boundsOf(load(parts, of.bytes)).maxMm, (Vec3{1000, 1000, 0})) << of.type;
  }
}

TEST_F(Gltf, MorphTargetsByDefaultWeightsNodeBeforeMesh) {
  Parts parts;
  parts.accessors += R"(,{"componentType":5126,"count":4,"type":"VEC3",
      "sparse":{"count":1,"indices":{"bufferView":2,"componentType":5121},
                "values":{"bufferView":3}}})";
  parts.views += R"(,{"buffer":0,"byteOffset":72,"byteLength":1},
                     {"buffer":0,"byteOffset":76,"byteLength":12})";
  parts.buffers = R"({"byteLength":88})";
  parts.meshes = R"({"weights":[0.5],"primitives":[{"attributes":{"POSITION":0},"indices":1,
                     "targets":[{"POSITION":2}]}]})";
  const std::string binary =
      tetrahedronBytes() + std::string("\x03\0\0\0", 4) + test::raw<float>({0, 0, 4});
  EXPECT_NEAR(boundsOf(load(parts, binary)).maxMm[2], 3000, 1e-2);
  parts.nodes = R"({"mesh":0,"weights":[1]})";
  EXPECT_NEAR(boundsOf(load(parts, binary)).maxMm[2], 5000, 1e-2);
}

TEST_F(Gltf, SkinsIgnoreTheirNodeAndWeightsAreBroughtToOne) {
  Parts parts;
  parts.scene = R"("scenes":[{"nodes":[0,1]}],)";
  parts.nodes = R"({"mesh":0,"skin":0,"translation":[100,0,0]},{"translation":[0,0,2]})";
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},
                     "indices":1}]})";
  parts.accessors += R"(,{"bufferView":2,"componentType":5121,"count":4,"type":"VEC4"},
                         {"bufferView":3,"componentType":5126,"count":4,"type":"VEC4"})";
  parts.views += R"(,{"buffer":0,"byteOffset":72,"byteLength":16},
                     {"buffer":0,"byteOffset":88,"byteLength":64})";
  parts.buffers = R"({"byteLength":152})";
  parts.more = R"(,"skins":[{"joints":[1]}])";
  std::vector<float> weights(16, 0);
  for (std::size_t v = 0; v < 4; ++v) weights[4 * v] = 0.25F;
  const std::string binary = tetrahedronBytes() + std::string(16, '\0') + test::raw(weights);
  const Bounds bounds = boundsOf(load(parts, binary));
  EXPECT_EQ(bounds.minMm, (Vec3{0, 0, 2000}));
  EXPECT_EQ(bounds.maxMm, (Vec3{1000, 1000, 3000}));
  EXPECT_THAT(errorOf(parts, tetrahedronBytes() + std::string(16, '\5') + test::raw(weights)),
              HasSubstr("joint 5"));
}

TEST_F(Gltf, CamerasAndLights) {
  Parts parts;
  parts.scene = R"("scenes":[{"nodes":[0,1,2,3,4]}],)";
  parts.nodes = R"({"mesh":0},{"camera":0,"translation":[0.25,0.25,5]},
      {"extensions":{"KHR_lights_punctual":{"light":0}},"rotation":[0,0.70710678,0,0.70710678]},
      {"extensions":{"KHR_lights_punctual":{"light":1}},"translation":[0,0,2]},
      {"extensions":{"KHR_lights_punctual":{"light":2}}})";
  parts.more =
      R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.7853981634,"znear":0.1}}],
      "extensions":{"KHR_lights_punctual":{"lights":[
        {"type":"directional","intensity":3,"color":[1,0.5,0]},
        {"type":"point","intensity":7},{"type":"lantern","name":"S"}]}})";
  const Scene scene = load(parts);
  EXPECT_EQ(scene.camera.positionMm, (Vec3{250, 250, 5000}));
  EXPECT_NEAR(scene.camera.verticalFovDegrees, 45, 1e-4);
  EXPECT_NEAR(scene.camera.targetMm[2], 500, 1e-2);
  ASSERT_EQ(scene.lighting.directional.size(), 1U);
  // A light shines along its -z; the node rotates +z to +x.
  EXPECT_NEAR(scene.lighting.directional[0].directionToLight[0], 1, 1e-6);
  EXPECT_EQ(scene.lighting.directional[0].irradiance, (Rgb{3, 1.5F, 0}));
  ASSERT_EQ(scene.lighting.points.size(), 1U);
  EXPECT_EQ(scene.lighting.points[0].positionMm, (Vec3{0, 0, 2000}));
  // 7 candela give 7 lux at one metre.
  EXPECT_NEAR(scene.lighting.points[0].intensity[0] / 1e6, 7, 1e-5);
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("lantern")));
}

TEST_F(Gltf, SpotLights) {
  Parts parts;
  parts.scene = R"("scenes":[{"nodes":[0,1,2]}],)";
  parts.nodes = R"({"mesh":0},
      {"extensions":{"KHR_lights_punctual":{"light":0}},"translation":[0,0,2],
       "rotation":[0,0.70710678,0,0.70710678]},
      {"extensions":{"KHR_lights_punctual":{"light":1}}})";
  const auto spots = [&](const std::string& cone) {
    parts.more = R"(,"extensions":{"KHR_lights_punctual":{"lights":[
        {"type":"spot","intensity":7,"color":[1,0.5,0],"name":"lamp","spot":{)" +
                 cone + R"(}},{"type":"spot","spot":{}}]}})";
  };
  spots(R"("innerConeAngle":0.34906585,"outerConeAngle":1.5707963268)");
  const Scene scene = load(parts);
  ASSERT_EQ(scene.lighting.spots.size(), 2U);
  const SpotLight& light = scene.lighting.spots[0];
  EXPECT_EQ(light.positionMm, (Vec3{0, 0, 2000}));
  // It shines along its -z, which the node rotates to -x.
  EXPECT_NEAR(light.direction[0], -1, 1e-6);
  EXPECT_NEAR(light.intensity[0] / 1e6, 7, 1e-5);
  EXPECT_NEAR(light.intensity[1] / 1e6, 3.5, 1e-5);
  EXPECT_NEAR(light.innerDegrees, 20, 1e-5);
  EXPECT_EQ(light.outerDegrees, 90);
  EXPECT_EQ(scene.lighting.spots[1].innerDegrees, 0);
  EXPECT_NEAR(scene.lighting.spots[1].outerDegrees, 45, 1e-5);
  EXPECT_TRUE(scene.notShown.empty());
  for (const char* cone : {R"("innerConeAngle":1,"outerConeAngle":0.5)", R"("outerConeAngle":2)",
                           R"("innerConeAngle":-1)", R"("outerConeAngle":0)"}) {
    spots(cone);
    EXPECT_THAT(errorOf(parts), HasSubstr("cone of light 'lamp'")) << cone;
  }
}

TEST_F(Gltf, MediumFromExtrasNameOrVolume) {
  Parts parts;
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]})";
  const std::string volume = R"("extensions":{"KHR_materials_ior":{"ior":1.4},
      "KHR_materials_volume":{"attenuationDistance":0.001,"attenuationColor":[0.5,0.25,0.125]},
      "KHR_materials_volume_scatter":{"multiscatterColor":[0.9,0.5,0]}})";
  parts.more = R"(,"materials":[{"name":"own",)" + volume + R"(,"extras":{
      "sigma_s_prime_per_mm":[1,2,3],"sigma_a_per_mm":[0,0.5,1]}}])";
  Medium medium = load(parts).objects[0].medium;
  EXPECT_EQ(medium.name, "own");
  EXPECT_EQ(medium.sigmaSPrimePerMm[2], 3);
  EXPECT_EQ(medium.sigmaAPerMm[1], 0.5);
  EXPECT_EQ(medium.eta, 1.4);

  parts.more = R"(,"materials":[{"name":"MARBLE",)" + volume + "}]";
  EXPECT_EQ(load(parts).objects[0].medium.eta, 1.5);

  parts.more = R"(,"materials":[{"name":"wax of mine",)" + volume + "}]";
  medium = load(parts).objects[0].medium;
  const double colour[] = {0.9, 0.5, 0};
  // The share of the entered light that leaves a half-space of index 1.4 again in even light. This
  // formula is within 0.003 of exact transfer.
  const auto seen = [](double albedo) {
    const double s = std::sqrt(1 - albedo);
    return (1 - s) * (1 - 0.480 * s) / (1 + 3.569 * s);
  };
  for (int c = 0; c < 3; ++c) {
    const bssrdf::Coefficients of = bssrdf::coefficients(medium, c);
    // One millimetre transmits 1/2, 1/4 and 1/8.
    EXPECT_NEAR(of.sigmaTPrimePerMm, (c + 1) * std::log(2.0), 1e-9);
    EXPECT_NEAR(seen(of.albedo), colour[c], 1e-4);
  }
  // Under its current name and with forward scattering: σ_s (1 - g) is the same.
  parts.more = R"(,"materials":[{"name":"gel","extensions":{"KHR_materials_ior":{"ior":1.4},
      "KHR_materials_volume":{"attenuationDistance":0.001,"attenuationColor":[0.5,0.25,0.125]},
      "KHR_materials_volume_scatter":{"multiscatterColorFactor":[0.9,0.5,0],
                                      "scatterAnisotropy":0.8}}}])";
  const Medium forwards = load(parts).objects[0].medium;
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const bssrdf::Coefficients of = bssrdf::coefficients(forwards, c);
    EXPECT_NEAR(seen(of.albedo), colour[c], 1e-4);
    EXPECT_NEAR(forwards.sigmaSPrimePerMm[i] / (1 - 0.8) + forwards.sigmaAPerMm[i],
                (c + 1) * std::log(2.0), 1e-9);
  }
  parts.more = R"(,"materials":[{"extras":{"sigma_s_prime_per_mm":[1,2,-3],
      "sigma_a_per_mm":[0,0.5,1]}}])";
  EXPECT_THAT(errorOf(parts), HasSubstr("sigma_s_per_mm 1,2,-3"));
}

TEST_F(Gltf, InstancesAreDrawn) {
  Parts parts;
  parts.nodes = R"({"mesh":0,"name":"cube","translation":[1,0,0],"extensions":{
      "EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}})";
  // The places are the mesh's own vertices: the origin, and a metre along each axis.
  const Scene scene = load(parts);
  ASSERT_EQ(scene.objects.size(), 4U);
  EXPECT_EQ(scene.objects[0].name, "cube 1");
  EXPECT_TRUE(scene.notShown.empty());
  const std::vector<Vec3> places{{1000, 0, 0}, {2000, 0, 0}, {1000, 1000, 0}, {1000, 0, 1000}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    Scene one;
    one.objects = {scene.objects[i]};
    EXPECT_EQ(boundsOf(one).minMm, places[i]);
  }
  parts.nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
      "TRANSLATION":0,"SCALE":1}}}})";
  EXPECT_THAT(errorOf(parts), HasSubstr("instances of node 0"));
  parts.nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
      "TRANSLATION":77}}}})";
  EXPECT_THAT(errorOf(parts), HasSubstr("77"));
}

TEST_F(Gltf, ExternalBuffersOnlyFromTheOwnFolder) {
  namespace fs = std::filesystem;
  fs::create_directories(folder / "models/parts");
  const std::string bytes = tetrahedronBytes();
  test::writeBytes(folder / "models/parts/a b.bin", bytes);
  test::writeBytes(folder / "secret.bin", bytes);
  fs::create_symlink(folder / "secret.bin", folder / "models/link.bin");
  const auto load = [&](const std::string& uri) {
    Parts parts;
    parts.buffers = R"({"byteLength":72,"uri":")" + uri + R"("})";
    test::writeBytes(folder / "models/a.gltf", parts.json());
    return loadScene(folder / "models/a.gltf");
  };
  test::expectSound(load("parts/a%20b.bin"));
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("parts/../../secret.bin"),
        (folder / "secret.bin").string(), std::string("link.bin"), std::string("none.bin"),
        std::string("%2e%2e/secret.bin"), std::string("parts")}) {
    EXPECT_THAT(test::messageOf([&] { load(uri); }), HasSubstr("a.gltf")) << uri;
  }
  EXPECT_THAT(test::messageOf([&] { load("../secret.bin"); }), HasSubstr("outside"));
  EXPECT_THAT(test::messageOf([&] { load("link.bin"); }), HasSubstr("out of"));
}

TEST_F(Gltf, ChainOfFiftyThousandNodesIsWalked) {
  Parts parts;
  parts.nodes.clear();
  constexpr int length = 50'000;
  for (int i = 0; i < length; ++i) {
    parts.nodes += fmt::format(R"({{"children":[{}],"translation":[0.001,0,0]}},)", i + 1);
  }
  parts.nodes += R"({"mesh":0})";
  EXPECT_NEAR(boundsOf(load(parts)).minMm[0], 50'000, 1);
}

TEST_F(Gltf, WhatIsNotShownIsCounted) {
  Parts parts;
  parts.nodes = R"({"mesh":0},{"mesh":0},{"mesh":1},{"camera":0},{"camera":1},)"
                R"({"extensions":{"KHR_lights_punctual":{"light":0}}})";
  parts.scene = R"("scene":0,"scenes":[{"nodes":[0,1,2,3,4,5]}],)";
  parts.meshes =
      R"({"name":"body","primitives":[{"attributes":{"POSITION":0,"COLOR_0":0},"indices":1,"material":0},)"
      R"({"attributes":{"POSITION":0},"mode":1,"material":2}]},)"
      R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":1}]})";
  parts.more =
      R"(,"textures":[{}],"materials":[{"name":"skin1","alphaMode":"MASK","pbrMetallicRoughness":)"
      R"({"metallicFactor":0,"baseColorTexture":{"index":0}},"normalTexture":{"index":0},)"
      R"("extensions":{"KHR_materials_ior":{"ior":1.4},"KHR_materials_sheen":{}}},)"
      R"({"emissiveFactor":[1,0,0],"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,1,1],)"
      R"("baseColorTexture":{"index":0}}},{"name":"unused","alphaMode":"BLEND"}],)"
      R"("cameras":[{"type":"perspective","name":"a","perspective":{"yfov":1,"znear":1}},)"
      R"({"type":"perspective","name":"b","perspective":{"yfov":1,"znear":1}}],)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"lantern","name":"lamp"}]}},)"
      R"("extensionsUsed":["KHR_lights_punctual","KHR_materials_sheen","ACME_fog"])";
  const Scene scene = load(parts);
  std::string said;
  for (const NotShown& kind : scene.notShown) {
    said += kind.what + " " + std::to_string(kind.count);
    for (const std::string& name : kind.names) said += " " + name;
    said += "\n";
  }
  EXPECT_EQ(said,
            "points and lines 1 body\nvertex colours 1 body\nbase-colour textures 1 skin1\n"
            "alpha masks 1 skin1\nKHR_materials_sheen 1 skin1\n"
            "extensions 1 ACME_fog\ncameras after the first 1 b\nlantern lights 1 lamp\n"
            "textures that cannot be read 1\n");
  EXPECT_EQ(scene.camera.verticalFovDegrees, static_cast<float>(180 / std::numbers::pi));
  EXPECT_TRUE(scene.cameraChosen);
}

// ymag is half of the visible height (glTF 2.0, section 3.10).
TEST_F(Gltf, OrthographicCamerasSeeTwiceTheirMagnification) {
  Parts parts;
  parts.scene = R"("scenes":[{"nodes":[0,1]}],)";
  parts.nodes = R"({"mesh":0},{"camera":0,"translation":[0.25,0.25,5],"scale":[3,3,3]})";
  const auto withHeight = [&](const char* ymag) {
    parts.more = std::string(R"(,"cameras":[{"type":"orthographic","name":"a","orthographic":)") +
                 R"({"xmag":2,"ymag":)" + ymag + R"(,"znear":0.1,"zfar":9}}])";
    return load(parts);
  };
  const Camera camera = withHeight("1.5").camera;
  EXPECT_EQ(camera.positionMm, (Vec3{250, 250, 5000}));
  ASSERT_TRUE(camera.orthographicHeightMm);
  EXPECT_NEAR(*camera.orthographicHeightMm, 3000, 1e-2);
  EXPECT_THROW(withHeight("0"), Error);
}

TEST_F(Gltf, RequiredExtensionsThatAreUnknownAreNamed) {
  Parts parts;
  parts.more = R"(,"extensionsRequired":["KHR_mesh_quantization","EXT_example_hair",)"
               R"("ACME_\u0007cloth","ACME_\u0007cloth"])";
  const std::string message = errorOf(parts);
  EXPECT_THAT(message, HasSubstr("requires 'ACME_\uFFFDcloth' and 'EXT_example_hair', "
                                 "which are not supported"));
  EXPECT_THAT(message, HasSubstr("docs/gltf.md"));
  // Any other problem of such a file follows from not knowing the extensions.
  EXPECT_THAT(test::messageOf([&] {
                loadBytes(test::glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4},)"
                                    R"({"byteLength":4}],"accessors":[{"componentType":5126}],)"
                                    R"("extensionsRequired":["EXT_example_hair"]})",
                                    "1234"));
              }),
              HasSubstr("requires 'EXT_example_hair', which is not supported"));
  // Extensions that only affect the look may be ignored, unless the file requires them.
  parts.more = R"(,"extensionsRequired":["KHR_mesh_quantization","KHR_materials_clearcoat"])";
  EXPECT_THAT(errorOf(parts),
              HasSubstr("requires 'KHR_materials_clearcoat', which is not supported"));
  parts.more = R"(,"extensionsUsed":["KHR_mesh_quantization","KHR_materials_clearcoat"])";
  EXPECT_FALSE(load(parts).objects.empty());
}

TEST_F(Gltf, ImagesAreNotRead) {
  Parts parts;
  parts.more = R"(,"images":[{"uri":"/dev/zero"},{"bufferView":0,"mimeType":"image/png"},
      {"uri":"data:image/png;base64,AAAA"}],"textures":[{"source":0}])";
  test::expectSound(load(parts));
}

}  // namespace
}  // namespace opaline

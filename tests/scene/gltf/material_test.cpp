#include <fmt/format.h>
#include <webp/encode.h>

#include <array>
#include <cmath>

#include "opaline/image_file.h"
#include "opaline/tone.h"
#include "scene/gltf/gltf_fixture.h"
#include "scene/mesh/tangents.h"

namespace opaline {
namespace {

using test::Gltf;
using test::Parts;
using testing::Contains;
using testing::HasSubstr;

class GltfMaterial : public Gltf {
 protected:
  /// A tetrahedron whose positions also serve as texture coordinates and colours.
  static Parts parts(const std::string& material) {
    Parts parts;
    parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"COLOR_0":0},"indices":1,)"
                   R"("material":0}]})";
    parts.more = R"(,"materials":[)" + material + "]";
    return parts;
  }

  /// The things of a scene that are not shown, as text.
  static std::string said(const Scene& scene) {
    std::string kinds;
    for (const NotShown& kind : scene.notShown) kinds += kind.what + " ";
    return kinds;
  }
};

TEST_F(GltfMaterial, WithoutASignOfTranslucencyItIsOpaque) {
  const Scene scene = load(
      parts(R"({"name":"paint","emissiveFactor":[1,0.5,0],"alphaMode":"MASK","alphaCutoff":0.25,)"
            R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,0.75],"metallicFactor":0.5,)"
            R"("roughnessFactor":0.75},"extensions":{"KHR_materials_ior":{"ior":1.25},)"
            R"("KHR_materials_emissive_strength":{"emissiveStrength":4},)"
            R"("KHR_materials_specular":{"specularFactor":0.5,"specularColorFactor":[1,2,3]}}})"));
  ASSERT_TRUE(scene.objects[0].opaque);
  const OpaqueMaterial& material = *scene.objects[0].opaque;
  EXPECT_EQ(material.name, "paint");
  EXPECT_EQ(material.baseColor, (Rgb{0.5F, 0.25F, 1}));
  EXPECT_EQ(material.alpha, 0.75F);
  EXPECT_EQ(material.alphaCutoff, 0.25F);
  EXPECT_EQ(material.metallic, 0.5F);
  EXPECT_EQ(material.roughness, 0.75F);
  EXPECT_EQ(material.emission, (Rgb{4, 2, 0}));
  EXPECT_EQ(material.ior, 1.25F);
  EXPECT_EQ(material.specular, 0.5F);
  EXPECT_EQ(material.specularColor, (Rgb{1, 2, 3}));
  EXPECT_EQ(scene.objects[0].mesh.colors.size(), scene.objects[0].mesh.positionsMm.size());
  EXPECT_TRUE(scene.notShown.empty());
}

TEST_F(GltfMaterial, WithoutAnyItIsMarble) {
  Parts without = parts("");
  without.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  const Scene scene = load(without);
  EXPECT_FALSE(scene.objects[0].opaque);
  EXPECT_EQ(scene.objects[0].medium.name, "marble");
}

// Flat triangles have their own vertices, and colours go with them.
TEST_F(GltfMaterial, AttributesFollowTheirVertices) {
  const Scene scene = load(parts(R"({"pbrMetallicRoughness":{"metallicFactor":0}})"));
  const Mesh& mesh = scene.objects[0].mesh;
  ASSERT_EQ(mesh.positionsMm.size(), 12U);
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(mesh.colors[v][c], mesh.positionsMm[v][c] / 1000);
}

// Both extensions must describe the same medium.
TEST_F(GltfMaterial, ScatterIsReadAsVolumeScatterIs) {
  const auto medium = [&](const std::string& extensions) {
    const Scene scene =
        load(parts(R"({"name":"jelly","extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
                   R"("attenuationDistance":0.001,"attenuationColor":[0.1,0.2,0.3]},)" +
                   extensions + "}}"));
    EXPECT_FALSE(scene.objects[0].opaque);
    return scene.objects[0].medium;
  };
  const std::string colour = R"("multiscatterColorFactor":[0.8,0.5,0.2],"scatterAnisotropy":0.4)";
  const Medium former = medium(R"("KHR_materials_volume_scatter":{)" + colour + "}");
  const Medium later =
      medium(R"("KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_scatter":)"
             R"({"scatterStrengthFactor":1,)" +
             colour + "}");
  EXPECT_EQ(former, later);
  EXPECT_NE(former.sigmaAPerMm[0], former.sigmaAPerMm[2]);
}

// KHR_materials_scatter: the strength scales the multiple-scattering albedo.
TEST_F(GltfMaterial, StrengthScalesTheColour) {
  const auto colour = [&](double strength, double thickness) -> std::optional<Rgb> {
    const Scene scene = load(parts(fmt::format(
        R"({{"name":"jelly","pbrMetallicRoughness":{{"metallicFactor":0}},"extensions":)"
        R"({{"KHR_materials_volume":{{"thicknessFactor":{},"attenuationDistance":0.001,)"
        R"("attenuationColor":[0.1,0.2,0.3]}},"KHR_materials_transmission":)"
        R"({{"transmissionFactor":1}},"KHR_materials_scatter":{{"scatterStrengthFactor":{},)"
        R"("multiscatterColorFactor":[0.8,0.6,0.4]}}}}}})",
        thickness, strength)));
    if (scene.objects[0].opaque) return std::nullopt;
    return colorOf(scene.objects[0].medium);
  };
  const Rgb half = colour(0.5, 1).value();
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(half[c], 0.5 * (0.8 - 0.2 * static_cast<double>(c)), 1e-5);
  EXPECT_FALSE(colour(0, 1));  // only absorbs
  EXPECT_FALSE(colour(1, 0));  // thin
}

TEST_F(GltfMaterial, AVolumeThatScattersNothingIsNoMedium) {
  const auto with = [&](const std::string& extension) {
    return load(parts(R"({"name":"glass","pbrMetallicRoughness":{"metallicFactor":0},)"
                      R"("extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
                      R"("attenuationDistance":0.001,"attenuationColor":[0.1,0.2,0.3]},)" +
                      extension + "}}"));
  };
  const Scene glass = with(R"("KHR_materials_transmission":{"transmissionFactor":1})");
  EXPECT_TRUE(glass.objects[0].opaque);
  EXPECT_EQ(said(glass), "KHR_materials_transmission KHR_materials_volume ");
  const Scene diffuse =
      with(R"("KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":1})");
  EXPECT_EQ(diffuse.objects[0].medium.name, "marble");
}

TEST_F(GltfMaterial, ASheetThatLetsLightThroughIsOpaque) {
  Parts leaf = parts(R"({"name":"leaf","pbrMetallicRoughness":{"metallicFactor":0},"extensions":{)"
                     R"("KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.5,)"
                     R"("diffuseTransmissionColorFactor":[0.25,0.5,2]}}})");
  leaf.more += R"(,"extensionsUsed":["KHR_materials_diffuse_transmission"])"
               R"(,"extensionsRequired":["KHR_materials_diffuse_transmission"])";
  const Scene scene = load(leaf);
  ASSERT_TRUE(scene.objects[0].opaque);
  EXPECT_EQ(scene.objects[0].opaque->diffuseTransmission, 0.5F);
  EXPECT_EQ(scene.objects[0].opaque->diffuseTransmissionColor, (Rgb{0.25F, 0.5F, 1}));
  EXPECT_TRUE(scene.notShown.empty());
}

// A medium takes in all light that its surface does not mirror.
TEST_F(GltfMaterial, HowLightGetsIntoAMediumIsToldWhereItIsNotShown) {
  const auto told = [&](const std::string& extensions, const std::string& factor = "1") {
    Parts file = parts(
        R"({"name":"jelly","pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":[1,)" +
        factor +
        R"(,1,1]},"extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
        R"("attenuationDistance":0.001,"attenuationColor":[0.1,0.2,0.3]},)"
        R"("KHR_materials_volume_scatter":{"multiscatterColorFactor":[0.8,0.5,0.2]},)" +
        extensions + "}}");
    file.meshes = test::changed(file.meshes, R"(,"COLOR_0":0)", "");
    return said(load(file));
  };
  const std::string clear = R"("KHR_materials_transmission":{"transmissionFactor":)";
  const std::string diffuse =
      R"("KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":)";
  EXPECT_EQ(told(clear + "1}"), "");
  EXPECT_EQ(told(clear + "1}", "0.5"), "base colours ");
  EXPECT_EQ(told(diffuse + "1}", "0.5"), "");  // it reflects nothing by the base colour
  EXPECT_EQ(told(clear + "0.5}"), "partial transmission ");
  EXPECT_EQ(told(diffuse + "0.5}", "0.5"), "base colours partial transmission ");
  EXPECT_EQ(told(clear + "0.5}," + diffuse + "1}"), "");
  EXPECT_EQ(told(clear + R"(1,"transmissionTexture":{"index":0}})"), "textures of transmission ");
  EXPECT_EQ(told(diffuse + R"(1,"diffuseTransmissionColorFactor":[1,0.5,1]})"),
            "colours of diffuse transmission ");
}

TEST_F(GltfMaterial, VariantsAndOtherScenesAreTold) {
  Parts file = parts(R"({"pbrMetallicRoughness":{"metallicFactor":0}})");
  file.meshes =
      test::changed(file.meshes, R"("material":0)",
                    R"("material":0,"extensions":{"KHR_materials_variants":{"mappings":[]}})");
  file.scene = R"("scene":1,"scenes":[{"name":"draft"},{"nodes":[0]}],)";
  EXPECT_EQ(said(load(file)), "KHR_materials_variants other scenes ");
}

TEST_F(GltfMaterial, StrengthMayVaryByTheAlphaOfATexture) {
  writePng(folder / "strength.png", {2, 1, {0, 0, 0, 255, 255, 255, 255, 128}});
  Parts file = parts(R"({"name":"jelly","pbrMetallicRoughness":{"metallicFactor":0},)"
                     R"("extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
                     R"("attenuationDistance":0.001,"attenuationColor":[0.1,0.2,0.3]},)"
                     R"("KHR_materials_transmission":{"transmissionFactor":1},)"
                     R"("KHR_materials_scatter":{"multiscatterColorFactor":[0.8,0.5,0.2],)"
                     R"("scatterStrengthFactor":1,"scatterStrengthTexture":{"index":0}}}}],)"
                     R"("textures":[{"source":0}],"images":[{"uri":"strength.png"}],"extras":[{})");
  file.meshes = test::changed(file.meshes, R"("COLOR_0":0)", R"("TEXCOORD_0":2)");
  file.accessors += R"(,{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})";
  const Scene scene = load(file);
  ASSERT_TRUE(scene.objects[0].paint && scene.objects[0].paint->colorTexture);
  const auto& rgba = scene.objects[0].paint->colorTexture->pixels->rgba;
  EXPECT_EQ(rgba[0], 65535);
  EXPECT_NEAR(decodeSrgb(static_cast<float>(rgba[4]) / 65535.0F), 128.0 / 255, 1e-4);
}

// Custom properties of a material, as Blender exports them.
TEST_F(GltfMaterial, CustomPropertiesSayHowItLooks) {
  const Scene scene =
      load(parts(R"({"name":"jelly","pbrMetallicRoughness":{"metallicFactor":0,)"
                 R"("baseColorFactor":[0.8,0.5,0.2,1]},"extras":{"mean_free_path_mm":[2,1,0.5],)"
                 R"("g":0.5}})"));
  ASSERT_FALSE(scene.objects[0].opaque);
  const Medium& medium = scene.objects[0].medium;
  const Rgb color = colorOf(medium);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(color[c], 0.8 - 0.3 * static_cast<double>(c), 1e-5);
    EXPECT_NEAR(medium.sigmaSPrimePerMm[c] / 0.5 + medium.sigmaAPerMm[c],
                0.5 * static_cast<double>(1U << c), 1e-9);
  }
  for (const NotShown& kind : scene.notShown) EXPECT_NE(kind.what, "base colours");
  EXPECT_THAT(errorOf(parts(R"({"extras":{"mean_free_path_mm":-1}})")),
              HasSubstr("mean_free_path_mm"));
  EXPECT_THAT(errorOf(parts(R"({"name":"wax","extras":{"mean_free_path_mm":1,"ball_mm":"40"}})")),
              HasSubstr("material 'wax': ball_mm in its extras must be a number"));
  EXPECT_THAT(errorOf(parts(R"({"extras":{"mean_free_path_mm":[1,2]}})")),
              HasSubstr("must be a number or three"));
  EXPECT_THAT(errorOf(parts(R"({"extras":{"sigma_s_prime_per_mm":[1,1,1]}})")),
              HasSubstr("must be beside sigma_a_per_mm"));
  EXPECT_NO_THROW(load(parts(R"({"extras":{"color":"red","g":"?"}})")));  // somebody else's extras
}

// Kulla and Conty 2017, as in the drafts: 0.37 becomes an albedo of 0.83 (computed by hand).
TEST_F(GltfMaterial, ColoursMeanWhatTheModelSays) {
  const Parts file =
      parts(R"({"name":"jelly","extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
            R"("attenuationDistance":0.001,"attenuationColor":[0.5,0.5,0.5]},)"
            R"("KHR_materials_volume_scatter":{"multiscatterColorFactor":[0.37,0.37,0.37]}}})");
  const std::string bytes = test::glb(file.json(), test::tetrahedronBytes());
  const Medium observed = loadBytes(bytes).objects[0].medium;
  EXPECT_NEAR(colorOf(observed)[0], 0.37, 1e-5);
  LoadOptions options;
  options.colorModel = ColorModel::Khr;
  const Medium khr = loadBytes(bytes, options).objects[0].medium;
  const double extinction = khr.sigmaSPrimePerMm[0] + khr.sigmaAPerMm[0];
  EXPECT_NEAR(extinction, std::log(2), 1e-9);
  EXPECT_NEAR(khr.sigmaSPrimePerMm[0] / extinction, 0.83, 0.005);
  EXPECT_NEAR(colorOf(khr)[0], 0.16, 0.005);
}

TEST_F(GltfMaterial, WebpIsReadBeforeItsFallback) {
  const std::array<std::uint8_t, 4> red{200, 10, 20, 255};
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(red.data(), 1, 1, 4, &encoded);
  test::writeBytes(folder / "a.webp", std::string(reinterpret_cast<char*>(encoded), size));
  WebPFree(encoded);
  writePng(folder / "a.png", {1, 1, {1, 2, 3, 255}});
  const auto texture = [&](const std::string& textures) {
    Parts file = parts(R"({"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":)"
                       R"({"index":0}}}],"textures":[)" +
                       textures +
                       R"(],"images":[{"uri":"a.webp"},{"uri":"a.png"},{"uri":"no.webp"}],)"
                       R"("extras":[{})");
    file.meshes = test::changed(file.meshes, R"("COLOR_0":0)", R"("TEXCOORD_0":2)");
    file.accessors += R"(,{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})";
    notes.clear();
    const Scene scene = load(file);
    const auto& found = scene.objects[0].opaque->baseColorTexture;
    return found ? found->pixels->rgba[0] / 257 : -1;
  };
  const std::string webp = R"("extensions":{"EXT_texture_webp":{"source":0}})";
  EXPECT_EQ(texture("{" + webp + "}"), 200);
  EXPECT_EQ(texture(R"({"source":1,)" + webp + "}"), 200);
  EXPECT_EQ(texture(R"({"source":1,"extensions":{"EXT_texture_webp":{"source":2}}})"), 1);
  EXPECT_EQ(texture(R"({"source":1,"extensions":{"KHR_texture_basisu":{"source":0}}})"), 1);
  EXPECT_EQ(texture(R"({"extensions":{"KHR_texture_basisu":{"source":0}}})"), -1);
  EXPECT_THAT(notes, Contains(HasSubstr("KHR_texture_basisu")));
}

TEST_F(GltfMaterial, AFileThatRequiresTexturesThatAreNotReadIsRefused) {
  Parts file =
      parts(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[)"
            R"({"extensions":{"KHR_texture_basisu":{"source":0}}}],"images":[{"uri":"a.ktx2"})");
  file.more += R"(,"extensionsRequired":["KHR_texture_basisu"])";
  EXPECT_THAT(errorOf(file), HasSubstr("requires 'KHR_texture_basisu', which is not supported"));
}

// The medium is as bright as all but the brightest twentieth, and bare where the picture has that
// colour.
TEST_F(GltfMaterial, ATextureOfColoursIsPaintOnTheirBrightest) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 10; ++i) {
    const auto level = static_cast<std::uint8_t>(i < 4 ? 255 : 60);
    pixels.insert(pixels.end(), {level, level, level, 255});
  }
  writePng(folder / "bands.png", {10, 1, pixels});
  Parts file = parts(R"({"name":"jelly","pbrMetallicRoughness":{"metallicFactor":0},)"
                     R"("extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
                     R"("attenuationDistance":0.001,"attenuationColor":[0.1,0.2,0.3]},)"
                     R"("KHR_materials_volume_scatter":{"multiscatterColorFactor":[0.8,0.5,0.2],)"
                     R"("multiscatterColorTexture":{"index":0}}}}],)"
                     R"("textures":[{"source":0}],"images":[{"uri":"bands.png"}],"extras":[{})");
  file.meshes = test::changed(file.meshes, R"("COLOR_0":0)", R"("TEXCOORD_0":2)");
  file.accessors += R"(,{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})";
  const Scene scene = load(file);
  const Object& object = scene.objects[0];
  EXPECT_FALSE(object.opaque);
  ASSERT_TRUE(object.paint && object.paint->colorTexture);
  EXPECT_EQ(object.paint->colorTexture->pixels->width, 10);
  EXPECT_TRUE(scene.notShown.empty());
  const Rgb bare = colorOf(object.medium);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(object.paint->color[c], bare[c], 1e-6);
  EXPECT_GT(bare[0], bare[1]);
  EXPECT_GT(bare[1], bare[2]);
}

// A medium keeps the file's own maps, and a roughness only if the file gives it: by default all is
// rough.
TEST_F(GltfMaterial, RoughnessAndNormalsOfAMediumAreItsSurface) {
  writePng(folder / "map.png", {1, 1, {128, 64, 255, 255}});
  const auto surface = [&](const std::string& pbr, const LoadOptions& options = {},
                           const char* name = "jade") {
    Parts file = parts(std::string(R"({"name":")") + name + R"(",)" + pbr +
                       R"(}],"textures":[{"source":0}],"images":[{"uri":"map.png"}],"extras":[{})");
    file.meshes = test::changed(file.meshes, R"("COLOR_0":0)", R"("TEXCOORD_0":2)");
    file.accessors += R"(,{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})";
    const Scene scene = loadBytes(test::glb(file.json(), test::tetrahedronBytes()), options);
    EXPECT_FALSE(scene.objects[0].opaque);
    EXPECT_TRUE(scene.notShown.empty());
    return scene.objects[0].surface;
  };
  const std::string dielectric = R"("pbrMetallicRoughness":{"metallicFactor":0)";
  EXPECT_FALSE(surface(dielectric + "}"));
  const auto said = surface(dielectric + R"(,"roughnessFactor":0.75})");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->roughness, 0.75F);
  EXPECT_FALSE(said->normalTexture);
  const std::string maps = dielectric + R"(,"metallicRoughnessTexture":{"index":0}},)"
                                        R"("normalTexture":{"index":0,"scale":0.5})";
  LoadOptions marble;
  marble.medium = Medium{"marble", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
  for (const auto& mapped : {surface(maps), surface(maps, marble, "plaster")}) {
    ASSERT_TRUE(mapped && mapped->metallicRoughnessTexture && mapped->normalTexture);
    EXPECT_EQ(mapped->roughness, 1.0F);
    EXPECT_EQ(mapped->normalScale, 0.5F);
    EXPECT_EQ(mapped->normalTexture->pixels->rgba[1], 64 * 257);
  }
}

TEST_F(GltfMaterial, OfAMediumByOptionAllButMetal) {
  for (const bool metal : {false, true}) {
    const Parts file =
        parts(metal ? R"({"name":"steel"})" : R"({"pbrMetallicRoughness":{"metallicFactor":0}})");
    LoadOptions options;
    options.medium = Medium{"jelly", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
    const Scene scene = loadBytes(test::glb(file.json(), test::tetrahedronBytes()), options);
    EXPECT_EQ(scene.objects[0].opaque.has_value(), metal);
  }
}

TEST_F(GltfMaterial, TexturesKeepWhatTheFileSaysOfThem) {
  writePng(folder / "a b.png", {1, 1, {10, 20, 30, 255}});
  Parts file = parts(R"({"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0,)"
                     R"("texCoord":1,"extensions":{"KHR_texture_transform":{"offset":[0.25,0.5],)"
                     R"("rotation":1.5707963267948966,"scale":[2,3]}}}}}],)"
                     R"("textures":[{"source":0,"sampler":0}],"images":[{"uri":"a%20b.png"}],)"
                     R"("samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],"extras":[{})");
  const Scene without = load(file);
  EXPECT_FALSE(without.objects[0].opaque->baseColorTexture);
  EXPECT_EQ(without.notShown.at(0).what, "textures without coordinates");
  file.meshes = test::changed(file.meshes, R"("COLOR_0":0)", R"("TEXCOORD_1":2)");
  file.accessors += R"(,{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})";
  const Scene scene = load(file);
  ASSERT_TRUE(scene.objects[0].opaque->baseColorTexture);
  const Texture& texture = *scene.objects[0].opaque->baseColorTexture;
  EXPECT_EQ(texture.pixels->rgba[1], 20 * 257);
  EXPECT_EQ(texture.coordinates, 1);
  EXPECT_EQ(texture.wrapU, TextureWrap::ClampToEdge);
  EXPECT_EQ(texture.wrapV, TextureWrap::MirroredRepeat);
  EXPECT_FALSE(texture.interpolated);
  // KHR_texture_transform, applied from the right: moved, rotated, scaled.
  const std::array<Vec3, 2> expected{{{0, 3, 0.25F}, {-2, 0, 0.5F}}};
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(texture.transform[row][i], expected[row][i], 1e-6);
}

TEST_F(GltfMaterial, PicturesThatCannotBeReadAreLeftOutAndNamed) {
  test::writeBytes(folder / "bad.png", "no picture");
  for (const std::string uri : {"missing.png", "bad.png", "../a.glb"}) {
    notes.clear();
    const Scene scene =
        load(parts(R"({"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":)"
                   R"({"index":0}}}],"textures":[{"source":0}],"images":[{"uri":")" +
                   uri + R"("}],"extras":[{})"));
    EXPECT_FALSE(scene.objects[0].opaque->baseColorTexture);
    EXPECT_THAT(notes, Contains(HasSubstr("a texture is left out"))) << uri;
    ASSERT_EQ(scene.notShown.size(), 1U);
    EXPECT_EQ(scene.notShown[0].what, "textures that cannot be read");
    EXPECT_THAT(scene.notShown[0].names, testing::ElementsAre(uri));
  }
  EXPECT_THAT(errorOf(parts(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":7}}})")),
              HasSubstr("texture 7 does not exist"));
}

// Two squares side by side, the second with a mirrored texture.
TEST(Tangents, FollowTheTextureOnBothHands) {
  Mesh mesh;
  for (const float y : {0.0F, 1.0F})
    for (const float x : {-1.0F, 0.0F, 1.0F}) {
      mesh.positionsMm.push_back({x, y, 0});
      mesh.normals.push_back({0, 0, 1});
      mesh.textureCoordinates[0].push_back({std::abs(x), 1 - y});
    }
  mesh.triangles = {{1, 2, 4}, {2, 5, 4}, {0, 1, 3}, {1, 4, 3}};
  const auto tangents = scene::tangentsOf(mesh, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle& t = mesh.triangles[i];
    for (const Vec2& corner : tangents[i].corners) {
      Vec3 along{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        along[axis] = corner[0] * (mesh.positionsMm[t[1]][axis] - mesh.positionsMm[t[0]][axis]) +
                      corner[1] * (mesh.positionsMm[t[2]][axis] - mesh.positionsMm[t[0]][axis]);
      EXPECT_NEAR(along[0], i < 2 ? 1 : -1, 1e-6);
      EXPECT_NEAR(along[1], 0, 1e-6);
    }
    EXPECT_EQ(tangents[i].side, i < 2 ? 1 : -1);
  }
}

}  // namespace
}  // namespace opaline

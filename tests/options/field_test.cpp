#include "opaline/options/field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "opaline/options/scene.h"

namespace opaline::options {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Range, HoldsItsEndsAndNothingThatIsNotFinite) {
  const Range range{1, 2};
  EXPECT_TRUE(range.holds(1));
  EXPECT_TRUE(range.holds(2));
  EXPECT_FALSE(range.holds(std::nextafter(1.0, 0.0)));
  EXPECT_FALSE(range.holds(std::nextafter(2.0, 3.0)));
  EXPECT_FALSE(range.holds(std::nan("")));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE((Range{0, infinity}.holds(infinity)));
  EXPECT_FALSE((Range{1, 2, "", true}.holds(1)));
}

TEST(Allowed, HoldsTheEndsOfItsRangeAsFloatsRoundThem) {
  const float most = 1e30F;
  ASSERT_GT(double{most}, 1e30);
  const Allowed allowed{{0, 1e30}};
  EXPECT_TRUE(allowed.holds(most));
  EXPECT_TRUE(allowed.holds(Rgb{most, 0, most}));
  const float more = std::nextafter(most, std::numeric_limits<float>::infinity());
  EXPECT_FALSE(allowed.holds(Rgb{1, 1, more}));
  EXPECT_FALSE((Allowed{{0, 1, "", true}}.holds(Rgb{0, 1, 1})));
}

TEST(Range, IsDescribedWithItsUnit) {
  EXPECT_EQ(describe({0, 1000, "mean free paths"}), "from 0 to 1000 mean free paths");
  EXPECT_EQ(describe({0, 100, "mm", true}), "above 0 and at most 100 mm");
}

TEST(Range, NumbersAreAsShortAsTheyCanBe) {
  EXPECT_EQ(numberText(1e6), "1e6");
  EXPECT_EQ(numberText(1e-6), "1e-6");
  EXPECT_EQ(numberText(1e15), "1e15");
  EXPECT_EQ(numberText(-32), "-32");
  EXPECT_EQ(numberText(4'194'304), "4194304");
  EXPECT_EQ(numberText(1.01), "1.01");
}

TEST(Requirement, SaysWhatAValueMustBe) {
  EXPECT_EQ(requirement({{1e-4, 1}}, 0.0F), "must be from 0.0001 to 1");
  EXPECT_EQ(requirement({{0, 8}}, 0), "must be a whole number from 0 to 8");
  EXPECT_EQ(requirement({.range = {1, 8}, .counts = {1, 2, 4, 8}}, 0), "must be 1, 2, 4 or 8");
  EXPECT_EQ(requirement({.choices = {"auto", "vertex"}}, std::string()),
            "must be one of auto, vertex");
  EXPECT_EQ(requirement({{0, 1}}, Rgb{}), "must be three numbers, each from 0 to 1");
  EXPECT_EQ(requirement({{1, 16384}}, Size{}),
            "must be a width and a height, each from 1 to 16384");
}

TEST(Requirement, HasTheFormsInWhichPeopleTypeAValue) {
  EXPECT_EQ(typedRequirement({{0, 8}}, 0), "must be a whole number from 0 to 8");
  EXPECT_EQ(typedRequirement({{0, 1}}, Rgb{}),
            "must be three numbers or one for all three, each from 0 to 1");
  EXPECT_EQ(typedRequirement({.range = {0, 1}, .choices = {"none"}}, Rgb{}),
            "must be three numbers or one for all three, each from 0 to 1, or none");
  EXPECT_EQ(typedRequirement({{1, 16384}}, Size{}), "must be WIDTHxHEIGHT, each from 1 to 16384");
}

TEST(Text, IsWhatPeopleType) {
  EXPECT_EQ(textOf(0.01F), "0.01");
  EXPECT_EQ(textOf(true), "true");
  EXPECT_EQ(textOf(Size{640, 480}), "640x480");
  EXPECT_EQ(textOf(Rgb{0, 0.25F, 1}), "0,0.25,1");
}

template <typename Owner>
class Table : public testing::Test {};

using Owners = testing::Types<PictureSettings, NamedSettings, RendererOptions, Medium, Camera,
                              DirectionalLight, PointLight, SpotLight, RectangleLight, DiscLight,
                              SphereLight, TubeLight, Lighting, Deformer, LoadOptions>;
TYPED_TEST_SUITE(Table, Owners);

TYPED_TEST(Table, HasEachKeyOnce) {
  std::set<std::string_view> keys;
  for (const Field<TypeParam>& field : fieldsOf<TypeParam>()) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(field.formerKey.empty() || keys.insert(field.formerKey).second) << field.key;
    EXPECT_EQ(findField<TypeParam>(field.key), &field);
    EXPECT_FALSE(field.help.empty()) << field.key;
  }
  EXPECT_EQ(findField<TypeParam>("no_such_key"), nullptr);
}

TYPED_TEST(Table, DefaultsAreAllowedExceptAMediumOfNothing) {
  TypeParam owner{};
  if constexpr (std::is_same_v<TypeParam, Medium>) owner.sigmaSPrimePerMm = {1, 1, 1};
  EXPECT_EQ(complaintAboutFields(owner), "");
}

// Of a number outside the range: the same in place of each of several.
Value outside(const Field<PictureSettings>& field, double number) {
  return std::visit(
      [&](auto value) -> Value {
        using Kind = decltype(value);
        if constexpr (std::is_same_v<Kind, bool>)
          return value;
        else if constexpr (std::is_arithmetic_v<Kind>)
          return static_cast<Kind>(number);
        else if constexpr (std::is_same_v<Kind, std::string>)
          return std::string("no such name");
        else
          return Kind{static_cast<typename Kind::value_type>(number)};
      },
      field.like);
}

TEST(Picture, WhatIsOutOfRangeIsRefusedWithOneSentence) {
  for (const Field<PictureSettings>& field : fieldsOf<PictureSettings>()) {
    if (std::holds_alternative<bool>(field.like) || std::holds_alternative<std::string>(field.like))
      continue;
    const Range& range = field.allowed.range;
    for (const double number : {range.least - 1, range.most + 1}) {
      PictureSettings settings;
      field.set(settings, outside(field, number));
      EXPECT_EQ(complaintAboutFields(settings), std::string(field.key) + " " +
                                                    textOf(*field.get(settings)) + ": " +
                                                    requirement(field.allowed, field.like));
      const bool ofTone = field.key == "exposure" || field.key == "background";
      const bool sound =
          complaintAbout(settings.render).empty() && complaintAbout(settings.time).empty();
      EXPECT_EQ(sound, ofTone) << field.key;
    }
  }
}

TEST(Names, AValueOutsideItsEnumerationIsRefusedWithOneSentence) {
  EXPECT_EQ(complaintAbout(RenderOptions{.transport = static_cast<Transport>(99)}),
            "transport 99: must be one of dipole, better-dipole, boundary");
  EXPECT_EQ(complaintAbout(RenderOptions{.site = static_cast<Site>(-1)}),
            "site -1: must be one of auto, vertex, fragment");
  EXPECT_EQ(complaintAbout(Deformer{.kind = static_cast<DeformerKind>(4)}),
            "kind 4: must be one of twist, bend, squash, wobble");
  EXPECT_EQ(complaintAbout(Appearance{.colorModel = static_cast<ColorModel>(2)}),
            "color_model 2: must be one of observed, khr");
}

TEST(Textures, AnUnknownWrapIsRefused) {
  const auto pixels = std::make_shared<TexturePixels>(TexturePixels{1, 1, {0, 0, 0, 0}, "leaf"});
  OpaqueMaterial material{.baseColorTexture = Texture{pixels}};
  EXPECT_EQ(complaintAbout(material), "");
  material.baseColorTexture->wrapV = static_cast<TextureWrap>(3);
  EXPECT_EQ(complaintAbout(material), "texture 'leaf' has an unknown wrap 3");
}

TEST(Names, OfAnOptionThatMayHaveNoValueAreItsChoices) {
  const Field<LoadOptions>& field = fieldOf<LoadOptions>("color_model");
  EXPECT_THAT(field.allowed.choices, ElementsAre("observed", "khr"));
  EXPECT_FALSE(field.allowed.holds(std::string("bogus")));
  EXPECT_EQ(named<ColorModel>("observed"), ColorModel::Observed);
  EXPECT_THROW(named<ColorModel>("bogus"), UsageError);
  LoadOptions options;
  EXPECT_THROW(field.set(options, std::string("bogus")), UsageError);
}

TEST(Picture, NotANumberIsOutOfEveryRange) {
  RenderOptions options;
  options.tolerance = std::nanf("");
  EXPECT_EQ(complaintAbout(options), "tolerance nan: must be from 0.0001 to 1");
}

TEST(Picture, ChosenOptionsAreAppliedAndOthersStay) {
  Chosen<PictureSettings> chosen;
  EXPECT_TRUE(chosen.empty());
  chosen.set(fieldOf<PictureSettings>("bounces"), 5);
  chosen.set(fieldOf<PictureSettings>("site"), std::string("fragment"));
  RenderOptions options;
  options.roughness = 0.5F;
  apply(chosen, options);
  EXPECT_EQ(options.bounces, 5);
  EXPECT_EQ(options.site, Site::Fragment);
  EXPECT_EQ(options.roughness, 0.5F);
  chosen.erase("bounces");
  EXPECT_FALSE(chosen.has("bounces"));
}

TEST(Picture, AChosenOptionThatNothingReadsIsFound) {
  const Spelling spelling = [](const Field<PictureSettings>& field, const Value& value) {
    return std::string(field.key) + ":" + textOf(value);
  };
  const Chosen<PictureSettings> all = chosenIn(PictureSettings{});
  RenderOptions options;
  const auto unused = [&] {
    std::vector<std::string_view> keys;
    Chosen<PictureSettings> chosen = all;
    while (const auto found = findUnused(chosen, options, spelling)) {
      keys.push_back(found->key);
      chosen.erase(found->key);
    }
    return keys;
  };
  EXPECT_THAT(unused(),
              ElementsAre("near_rings", "near_spacing", "far_distance", "ambient_occlusion"));
  options.sum = Sum::Pattern;
  EXPECT_THAT(unused(), ElementsAre("transport", "sum", "max_surfels", "ambient_occlusion"));
  chooseTransport(options);
  EXPECT_EQ(options.transport, Transport::Dipole);
  EXPECT_THAT(unused(), ElementsAre("tolerance", "max_surfels", "max_clusters", "bounces"));
  options.ambientOcclusion = true;
  EXPECT_THAT(unused(), ElementsAre("max_surfels", "bounces"));
  options.sum = Sum::All;
  options.ambientOcclusion = false;
  options.specular = false;
  EXPECT_THAT(unused(), ElementsAre("near_rings", "near_spacing", "far_distance", "tolerance",
                                    "max_clusters", "bounces", "roughness"));
  EXPECT_EQ(findUnused(all, options, spelling)->why, "shapes the pattern and needs sum:pattern");
  options.sum = Sum::Tree;
  EXPECT_FALSE(findUnused({}, options, spelling));
}

TEST(Picture, OlderNamesAreUnderstood) {
  EXPECT_EQ(findField<PictureSettings>("max_sources"), findField<PictureSettings>("max_surfels"));
  EXPECT_EQ(findField<PictureSettings>("boundary_surfels"),
            findField<PictureSettings>("max_clusters"));
}

TEST(Medium, IsRefusedWhereItsCoefficientsMakeNoSense) {
  Medium medium{"wax", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
  EXPECT_EQ(complaintAbout(medium), "");
  medium.sigmaSPrimePerMm[1] = 0;
  EXPECT_THAT(complaintAbout(medium), HasSubstr("sigma_s_per_mm 1,0,1"));
  medium.sigmaSPrimePerMm[1] = 1;
  medium.sigmaAPerMm[2] = -1;
  EXPECT_THAT(complaintAbout(medium), HasSubstr("sigma_a_per_mm"));
  medium.sigmaAPerMm[2] = std::nan("");
  EXPECT_THAT(complaintAbout(medium), HasSubstr("sigma_a_per_mm"));
  medium.sigmaAPerMm[2] = 0;
  medium.eta = 1;
  EXPECT_EQ(complaintAbout(medium), "eta 1: must be from 1.01 to 3");
}

TEST(Appearance, IsRefusedWhereNoMediumHasIt) {
  Appearance appearance{.meanFreePathMm = {1, 1, 2e-6}, .g = -0.99};
  EXPECT_EQ(complaintAbout(appearance), "");
  appearance.meanFreePathMm[2] = 1.9e-6;  // σ_s' may be 1.99 / 1.9e-6, about 1.05e6 per mm
  EXPECT_THAT(complaintAbout(appearance), HasSubstr("mean_free_path_mm 1.9e-06 and g -0.99"));
  appearance.g = 0;
  EXPECT_EQ(complaintAbout(appearance), "");
}

TEST(Lights, AreRefusedWhereTheyMakeNoSense) {
  EXPECT_THAT(complaintAbout(DirectionalLight{.directionToLight = {}}), HasSubstr("not zero"));
  EXPECT_THAT(complaintAbout(DirectionalLight{.irradiance = {-1, 0, 0}}),
              HasSubstr("irradiance -1,0,0: must be"));
  EXPECT_THAT(complaintAbout(PointLight{.positionMm = {0, std::nanf(""), 0}}), HasSubstr("finite"));
  Lighting lighting;
  lighting.directional.resize(Lighting::maxLights);
  EXPECT_EQ(complaintAbout(lighting), "");
  lighting.directional.emplace_back();
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("16 lights in all"));
  lighting.directional.clear();
  lighting.points.resize(8);
  EXPECT_EQ(complaintAbout(lighting), "");
  lighting.points.emplace_back();
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("need 54 shadow maps, but there may be 48"));
  lighting.points.pop_back();
  lighting.spots.emplace_back();
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("need 49 shadow maps"));
  lighting.points.clear();
  lighting.spots.assign(16, SpotLight{});
  EXPECT_EQ(complaintAbout(lighting), "");
  lighting.spots.emplace_back();
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("there are 17 lights"));
  lighting.spots.assign(9, SpotLight{.outerDegrees = 51});
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("need 54 shadow maps"));
  lighting.spots.assign(1, SpotLight{.direction = {}});
  EXPECT_EQ(complaintAbout(lighting), "a spot light: its direction must be finite and not zero");
  lighting.spots.clear();
  lighting.ambient = {0, -1, 0};
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("the ambient light: radiance 0,-1,0"));
}

TEST(SpotLights, AreRefusedWhereTheyMakeNoSense) {
  EXPECT_EQ(complaintAbout(SpotLight{}), "");
  EXPECT_THAT(complaintAbout(SpotLight{.positionMm = {0, std::nanf(""), 0}}), HasSubstr("finite"));
  EXPECT_THAT(complaintAbout(SpotLight{.direction = {0, 0, std::nanf("")}}), HasSubstr("finite"));
  EXPECT_THAT(complaintAbout(SpotLight{.direction = {}}), HasSubstr("not zero"));
  EXPECT_THAT(complaintAbout(SpotLight{.intensity = {0, -1, 0}}), HasSubstr("intensity 0,-1,0"));
  EXPECT_EQ(complaintAbout(SpotLight{.innerDegrees = 46}),
            "inner_degrees 46: must not be above outer_degrees, which is 45");
  EXPECT_EQ(complaintAbout(SpotLight{.innerDegrees = 45}), "");
  EXPECT_EQ(complaintAbout(SpotLight{.innerDegrees = -1}),
            "inner_degrees -1: must be from 0 to 90 degrees");
  EXPECT_EQ(complaintAbout(SpotLight{.outerDegrees = 91}),
            "outer_degrees 91: must be above 0 and at most 90 degrees");
  EXPECT_THAT(complaintAbout(SpotLight{.outerDegrees = std::nanf("")}), HasSubstr("outer_degrees"));
  EXPECT_EQ(shadowMapsOf({.outerDegrees = 50}), 1U);
  EXPECT_EQ(shadowMapsOf({.outerDegrees = 50.1F}), 6U);
}

TEST(AreaLights, AreRefusedWhereTheyMakeNoSense) {
  const float nan = std::nanf("");
  for (const AreaLight& light : {AreaLight{RectangleLight{}}, AreaLight{DiscLight{}},
                                 AreaLight{SphereLight{}}, AreaLight{TubeLight{}}})
    EXPECT_EQ(complaintAbout(light), "");
  const auto complaint = [](const AreaLight& light) { return complaintAbout(light); };
  EXPECT_THAT(complaint(RectangleLight{.uMm = {}}), HasSubstr("neither be zero nor parallel"));
  EXPECT_THAT(complaint(RectangleLight{.uMm = {1, 2, 3}, .vMm = {-2, -4, -6}}),
              HasSubstr("neither be zero nor parallel"));
  EXPECT_THAT(complaint(RectangleLight{.vMm = {0, nan, 0}}), HasSubstr("finite"));
  EXPECT_THAT(complaint(RectangleLight{.radiance = {-1, 0, 0}}), HasSubstr("radiance -1,0,0"));
  EXPECT_THAT(complaint(DiscLight{.normal = {}}), HasSubstr("not zero"));
  EXPECT_THAT(complaint(DiscLight{.centreMm = {nan, 0, 0}}), HasSubstr("finite"));
  EXPECT_EQ(complaint(DiscLight{.radiusMm = -1}),
            "radius_mm -1: must be above 0 and at most 1e6 mm");
  EXPECT_EQ(complaint(SphereLight{.radiusMm = 0}),
            "radius_mm 0: must be above 0 and at most 1e6 mm");
  EXPECT_THAT(complaint(SphereLight{.radiusMm = nan}), HasSubstr("radius_mm"));
  EXPECT_THAT(complaint(SphereLight{.radiance = {0, nan, 0}}), HasSubstr("radiance"));
  EXPECT_THAT(complaint(TubeLight{.fromMm = {1, 1, 1}, .toMm = {1, 1, 1}}),
              HasSubstr("two places"));
  EXPECT_THAT(complaint(TubeLight{.radiusMm = -2}), HasSubstr("radius_mm"));
  Lighting lighting;
  lighting.points.resize(8);
  lighting.areas.resize(8);
  EXPECT_EQ(complaintAbout(lighting), "");
  lighting.areas.emplace_back();
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("there are 17 lights, 0 directional, 8 point"));
  lighting.areas.assign(1, SphereLight{.radiusMm = 0});
  EXPECT_THAT(complaintAbout(lighting), HasSubstr("an area light: radius_mm 0"));
}

TEST(Deformers, HaveTheRangesOfTheirKinds) {
  struct Case {
    Deformer least, most;
    const char* allowed;
  };
  using Kind = DeformerKind;
  for (const auto& [least, most, allowed] :
       {Case{{Kind::Twist, -100, 0}, {Kind::Twist, 100, 2}, "from -100 to 100 radians"},
        Case{{Kind::Bend, -6.28F, 0}, {Kind::Bend, 6.28F, 2}, "from -6.28 to 6.28 radians"},
        Case{{Kind::Squash, -3, 0}, {Kind::Squash, 0.9F, 0}, "from -3 to 0.9"},
        Case{{Kind::Squash, -0.9F, 2}, {Kind::Squash, 0.9F, 2}, "from -0.9 to 0.9"},
        Case{{Kind::Wobble, -1, 0}, {Kind::Wobble, 1, 2}, "from -1 to 1 diagonals"}}) {
    for (Deformer deformer : {least, most}) {
      EXPECT_EQ(complaintAbout(deformer), "");
      EXPECT_TRUE(fieldOf<Deformer>("amount").allowed.holds(deformer.amount));
      deformer.amount *= 1.01F;
      EXPECT_THAT(complaintAbout(deformer), HasSubstr(allowed));
      EXPECT_THAT(complaintAbout(deformer), HasSubstr(nameOf(deformer.kind)));
      deformer.amount = std::nanf("");
      EXPECT_THAT(complaintAbout(deformer), HasSubstr(allowed));
    }
  }
}

TEST(Deformers, SwingNeitherTooFastNorTooSlowly) {
  for (const float period : {0.0F, 0.001F, 1e6F})
    EXPECT_EQ(complaintAbout(Deformer{DeformerKind::Twist, 1, period}), "");
  for (const float period : {-1.0F, 0.0009F, 1.1e6F, std::nanf("")})
    EXPECT_THAT(complaintAbout(Deformer{DeformerKind::Twist, 1, period}),
                HasSubstr("must be 0 or from 0.001 to 1e6 s"));
}

TEST(Names, AreAnyTextThatIsNotEmpty) {
  for (const Field<NamedSettings>& field : fieldsOf<NamedSettings>()) {
    EXPECT_TRUE(field.allowed.holds(std::string("xyzzy")));
    EXPECT_FALSE(field.allowed.holds(std::string()));
    NamedSettings settings;
    EXPECT_FALSE(field.get(settings));
    field.set(settings, std::string("xyzzy"));
    EXPECT_EQ(field.get(settings), Value(std::string("xyzzy")));
  }
}

TEST(Camera, IsRefusedWhereItMakesNoSense) {
  EXPECT_EQ(complaintAbout(Camera{.positionMm = {0, 0, 1}}), "");
  EXPECT_THAT(complaintAbout(Camera{}), HasSubstr("position and target must differ"));
  EXPECT_EQ(complaintAbout(Camera{.positionMm = {0, 0, 1}, .verticalFovDegrees = 171}),
            "field of view 171: must be from 1 to 170 degrees");
}

TEST(MemoryLimit, IsRefusedWhereItMakesNoSense) {
  EXPECT_EQ(complaintAboutFields(RendererOptions{.memoryLimit = 1.0F}),
            "memory limit 1: must be from 64 to 1e7 MB");
}

TEST(Range, ItsEndsAsFloatsAreWithin) {
  // The nearest floats are 1.00999999 and 1.10000002.
  const Range inner{1.01, 1.1};
  EXPECT_TRUE(inner.holds(static_cast<double>(inner.leastFloat())));
  EXPECT_TRUE(inner.holds(static_cast<double>(inner.mostFloat())));
  EXPECT_EQ(inner.leastFloat(), 1.01000011F);
  EXPECT_EQ(inner.mostFloat(), 1.09999990F);
  const Range open{0, 8, "", true};
  EXPECT_TRUE(open.holds(static_cast<double>(open.leastFloat())));
  EXPECT_EQ(open.mostFloat(), 8.0F);
  const Range exact{0.25, 2};
  EXPECT_EQ(exact.leastFloat(), 0.25F);
  EXPECT_EQ(exact.mostFloat(), 2.0F);
}

}  // namespace
}  // namespace opaline::options

// Small pictures of the built-in scenes against the pictures in golden/ that cases.json lists.
// OPALINE_UPDATE_GOLDEN=1 writes them instead.

#include <gtest/gtest.h>
#include <stb_image.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "opaline/file.h"
#include "opaline/image_file.h"
#include "opaline/tone.h"
#include "renderer/renderer_fixture.h"

namespace opaline {
namespace {

using nlohmann::json;

const std::filesystem::path folder =
    std::filesystem::path(OPALINE_SOURCE_DIR) / "tests" / "renderer" / "golden";

template <typename Value>
Value oneOf(const std::map<std::string, Value>& values, const std::string& name) {
  const auto found = values.find(name);
  if (found == values.end()) throw Error("cases.json: '" + name + "' is unknown");
  return found->second;
}

/// One picture in cases.json. Missing keys have RenderOptions' defaults; unknown ones are refused.
struct GoldenCase {
  std::string name;
  std::string scene;
  RenderOptions options;
  double largestDifference = 0;  ///< of any channel of any pixel, in units of 1/255
  double rmsDifference = 0;      ///< over all channels, in units of 1/255
};

GoldenCase readCase(const json& description) {
  GoldenCase golden;
  for (const auto& [key, value] : description.items()) {
    if (key == "name")
      golden.name = value;
    else if (key == "scene")
      golden.scene = value;
    else if (key == "width")
      golden.options.width = value;
    else if (key == "height")
      golden.options.height = value;
    else if (key == "dsm_size")
      golden.options.dsmSize = value;
    else if (key == "shadow_size")
      golden.options.shadowSize = value;
    else if (key == "antialias")
      golden.options.antialias = value;
    else if (key == "specular")
      golden.options.specular = value;
    else if (key == "roughness")
      golden.options.roughness = value;
    else if (key == "largest_difference")
      golden.largestDifference = value;
    else if (key == "rms_difference")
      golden.rmsDifference = value;
    else if (key == "transport")
      golden.options.transport = oneOf<Transport>({{"dipole", Transport::Dipole},
                                                   {"better-dipole", Transport::BetterDipole},
                                                   {"boundary", Transport::Boundary}},
                                                  value);
    else if (key == "sum")
      golden.options.sum =
          oneOf<Sum>({{"pattern", Sum::Pattern}, {"tree", Sum::Tree}, {"all", Sum::All}}, value);
    else if (key == "site")
      golden.options.site = oneOf<Site>(
          {{"vertex", Site::Vertex}, {"fragment", Site::Fragment}, {"auto", Site::Auto}}, value);
    else
      throw Error("cases.json: key '" + key + "' is unknown");
  }
  return golden;
}

std::vector<GoldenCase> readCases() {
  const std::vector<std::byte> text = readFile(folder / "cases.json", 1 << 20);
  const auto* characters = reinterpret_cast<const char*>(text.data());
  std::vector<GoldenCase> cases;
  for (const json& description : json::parse(characters, characters + text.size()))
    cases.push_back(readCase(description));
  return cases;
}

Image8 readPng(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = readFile(file, 1 << 22);
  Image8 image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &image.width, &image.height, &channels,
                            4),
      stbi_image_free);
  if (!pixels) throw Error(file.string() + " is no picture");
  const auto count = static_cast<std::ptrdiff_t>(image.width) * image.height * 4;
  image.rgba.assign(pixels.get(), pixels.get() + count);
  return image;
}

bool isUpdating() {
  const char* wish = std::getenv("OPALINE_UPDATE_GOLDEN");
  return wish != nullptr && std::string(wish) == "1";
}

class GoldenTest : public test::RendererTestBase<testing::TestWithParam<GoldenCase>> {};

TEST_P(GoldenTest, LooksAsBefore) {
  const GoldenCase& golden = GetParam();
  renderer().setScene(oneOf<Scene (*)(const LoadOptions&)>(
      {{"bear", builtInBear}, {"teapot", builtInTeapot}}, golden.scene)({}));
  const RenderResult result = renderer().render(golden.options);
  if (result.report.device.type != "software")
    GTEST_SKIP() << "golden pictures are those of the software device, not of "
                 << result.report.device.name;

  const Image8 picture = toneMap(result.images[0]);
  const std::filesystem::path file = folder / (golden.name + ".png");
  if (isUpdating()) {
    writePng(file, picture);
    return;
  }
  ASSERT_TRUE(std::filesystem::exists(file))
      << file << " does not exist; run this test with OPALINE_UPDATE_GOLDEN=1 to make it";
  const Image8 expected = readPng(file);
  ASSERT_EQ(picture.width, expected.width);
  ASSERT_EQ(picture.height, expected.height);
  double squares = 0;
  double largest = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    const double difference = std::abs(int{picture.rgba[i]} - int{expected.rgba[i]});
    squares += difference * difference;
    largest = std::max(largest, difference);
  }
  const double rms = std::sqrt(squares / static_cast<double>(picture.rgba.size()));
  EXPECT_LE(largest, golden.largestDifference);
  EXPECT_LE(rms, golden.rmsDifference);
  if (!HasFailure()) return;
  const std::filesystem::path seen =
      std::filesystem::temp_directory_path() / ("opaline-" + golden.name + ".png");
  writePng(seen, picture);
  std::cerr << "what was rendered stands in " << seen << '\n';
}

std::string nameOf(const testing::TestParamInfo<GoldenCase>& golden) {
  return golden.param.name;
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(readCases()), nameOf);

}  // namespace
}  // namespace opaline

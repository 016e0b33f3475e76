#include "studio.h"

#include <fmt/format.h>
#include <stb_image_write.h>

#include <cmath>
#include <cstdio>

#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/media.h"

namespace opaline::figures {

namespace {

/// Above 90, stb_image_write keeps colour at full resolution.
constexpr int jpegQuality = 92;

/// IEC 61966-2-1.
float decodeSrgb(std::uint8_t encoded) {
  const float value = static_cast<float>(encoded) / 255;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

LoadOptions loadOptions(std::string_view medium, float diagonalMm) {
  LoadOptions options;
  options.medium = findMedium(medium);
  options.diagonalMm = diagonalMm;
  return options;
}

}  // namespace

Scene load(const Studio& studio, const std::string& file, std::string_view medium, float diagonalMm,
           const std::string& morphTo) {
  LoadOptions options = loadOptions(medium, diagonalMm);
  if (!morphTo.empty()) options.morphTo = studio.models / morphTo;
  return loadScene(studio.models / file, options);
}

Scene bear(std::string_view medium, float diagonalMm) {
  return builtInBear(loadOptions(medium, diagonalMm));
}

Scene teapot(std::string_view medium, float diagonalMm) {
  return builtInTeapot(loadOptions(medium, diagonalMm));
}

Lighting stageLight() {
  Lighting lighting;
  lighting.directional = {{{-0.487F, 0.487F, -0.725F}, {6, 5.6F, 5}},
                          {{0.808F, 0.303F, -0.505F}, {2.5F, 2.2F, 2}},
                          {{-0.352F, 0.704F, 0.616F}, {0.5F, 0.5F, 0.55F}}};
  lighting.ambient = {0.08F, 0.08F, 0.1F};
  return lighting;
}

RenderOptions paperMethod() {
  RenderOptions options;
  options.transport = Transport::Dipole;
  options.sum = Sum::Pattern;
  options.site = Site::Fragment;
  options.shadowSize = 2048;
  return options;
}

RenderOptions usual() {
  RenderOptions options;
  options.shadowSize = 2048;
  return options;
}

RenderOptions objectSpace() {
  RenderOptions options = paperMethod();
  options.sum = Sum::Tree;
  options.site = Site::Auto;
  return options;
}

Image overBox(Image map, const Bounds& bounds) {
  for (std::size_t i = 0; i < map.rgba.size(); ++i) {
    const std::size_t c = i % 4;
    if (c == 3) continue;
    map.rgba[i] = (map.rgba[i] - bounds.minMm[c]) / (bounds.maxMm[c] - bounds.minMm[c]);
  }
  return map;
}

Image asColour(Image map) {
  for (std::size_t i = 0; i < map.rgba.size(); ++i) {
    if (i % 4 != 3) map.rgba[i] = 0.5F + 0.5F * map.rgba[i];
  }
  return map;
}

Image8 photograph(Studio& studio, RenderOptions options, const Exposure& exposure) {
  options.width = 2 * exposure.width / studio.shrunk;
  options.height = 2 * exposure.height / studio.shrunk;
  options.maxClusters /= studio.shrunk;
  return develop(halved(studio.renderer.render(options).images.at(0)), exposure.stops);
}

Image8 develop(const Image& radiance, float stops, const Paper& paper) {
  const Rgb background{decodeSrgb(paper[0]), decodeSrgb(paper[1]), decodeSrgb(paper[2])};
  return toneMap(radiance, {stops, ToneCurve::Neutral, background});
}

void publish(const Studio& studio, const std::string& name, const Image8& picture) {
  const std::filesystem::path file = studio.output / (name + ".jpg");
  requireWritable(file);
  std::string encoded;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  constexpr int channels = 4;
  const int done = stbi_write_jpg_to_func(append, &encoded, picture.width, picture.height, channels,
                                          picture.rgba.data(), jpegQuality);
  if (done == 0 || encoded.empty()) {
    throw Error(fmt::format("cannot write {}: there is not enough memory", file.string()));
  }
  writeWhole(file, encoded);
  fmt::print("wrote {}, {}x{}, {} KiB\n", file.lexically_normal().string(), picture.width,
             picture.height, encoded.size() / 1024);
  static_cast<void>(std::fflush(stdout));
}

}  // namespace opaline::figures

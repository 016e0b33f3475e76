#include "lab/compare_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/paths.h"
#include "opaline/error.h"
#include "opaline/file.h"

namespace opaline::app {

namespace {

struct Input {
  Image image;
  bool encoded = false;  ///< a PNG
};

bool isPng(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89PNG";
  const std::vector<std::byte> head = readFileHead(file, signature.size());
  const auto same = [](std::byte a, char b) { return a == static_cast<std::byte>(b); };
  return extensionOf(file) == ".png" ||
         std::equal(head.begin(), head.end(), signature.begin(), signature.end(), same);
}

Input readImage(const std::filesystem::path& file) {
  if (isPng(file)) return {readPng(file), true};
  return {readHdrImage(file, Negatives::Stay), false};
}

void requireSameSize(const Image& a, const std::filesystem::path& fileA, const Image& b,
                     const std::filesystem::path& fileB) {
  if (a.width == b.width && a.height == b.height) return;
  throw Error(
      fmt::format("{} has {}x{} pixels and {} {}x{}; only images of one size can be compared, so "
                  "render both with the same --size",
                  fileA.string(), a.width, a.height, fileB.string(), b.width, b.height));
}

ToneOptions toneOptions(const CompareTone& tone) {
  ToneOptions options;
  options.exposureStops = tone.exposureStops.value_or(options.exposureStops);
  options.curve = tone.curve.value_or(options.curve);
  return options;
}

Image8 shownOverBlack(const Input& input, ToneOptions options) {
  options.background = Rgb{0, 0, 0};
  if (!input.encoded) return toneMap(input.image, options);
  Image linear = input.image;
  for (std::size_t i = 0; i < linear.rgba.size(); ++i) {
    if (i % 4 != 3) linear.rgba[i] = decodeSrgb(linear.rgba[i]);
  }
  options.exposureStops = 0;
  options.curve = ToneCurve::None;
  return toneMap(linear, options);
}

/// Makes the picture that `render` would write as PNG.
void makePicture(Input& input, const ToneOptions& options) {
  if (input.encoded) return;
  const Image8 picture = toneMap(input.image, options);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    const auto value = static_cast<float>(picture.rgba[i]) / 255.0F;
    // Coverage decides which pixels count, and so keeps its precision.
    if (i % 4 != 3) input.image.rgba[i] = value;
  }
  input.encoded = true;
}

}  // namespace

ComparedImages readCompared(const std::filesystem::path& a, const std::filesystem::path& b,
                            const CompareTone& tone) {
  Input inputA = readImage(a);
  Input inputB = readImage(b);
  requireSameSize(inputA.image, a, inputB.image, b);
  if (inputA.encoded && inputB.encoded && (tone.exposureStops || tone.curve)) {
    throw UsageError(
        fmt::format("--exposure and --tone belong to linear images, EXR or HDR; {} and {} are PNG",
                    a.string(), b.string()));
  }
  const ToneOptions options = toneOptions(tone);
  ComparedImages compared;
  compared.pictures = inputA.encoded || inputB.encoded;
  compared.shownA = shownOverBlack(inputA, options);
  compared.shownB = shownOverBlack(inputB, options);
  if (compared.pictures) {
    makePicture(inputA, options);
    makePicture(inputB, options);
  }
  compared.a = std::move(inputA.image);
  compared.b = std::move(inputB.image);
  return compared;
}

compare::Selection readMask(const std::filesystem::path& file, const Image& image,
                            const std::filesystem::path& imageFile) {
  const Input mask = readImage(file);
  requireSameSize(mask.image, file, image, imageFile);
  return compare::maskedPixels(mask.image);
}

}  // namespace opaline::app

#include <cmath>
#include <memory>

#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/compare.h"
#include "opaline/exposure.h"
#include "opaline/image_file.h"
#include "opaline/tone.h"

struct OpalineImage : opaline::c::Handle<OpalineImage> {
  opaline::Image image;
};

namespace opaline::c {

namespace {

OpalineTone defaultTone() {
  return {0, 0, 1, nullptr};
}

ToneOptions toneOf(const OpalineTone* given) {
  ToneOptions tone;
  if (!given) return tone;
  const OpalineTone whole = wholeOf(given, defaultTone(), "tone");
  tone.exposureStops = whole.exposureStops;
  tone.curve = whole.neutral != 0 ? ToneCurve::Neutral : ToneCurve::None;
  if (whole.background) tone.background = vectorOf(whole.background, "background");
  return tone;
}

}  // namespace

void requirePictureSize(int width, int height) {
  constexpr int largest = 16384;
  if (width < 1 || height < 1 || width > largest || height > largest) {
    throw UsageError(fmt::format("A picture of {}x{}: must be from 1 to {} pixels each.", width,
                                 height, largest));
  }
}

Image imageOf(const float* rgba, int width, int height, const char* name) {
  required(rgba, name);
  requirePictureSize(width, height);
  Image image(width, height);
  std::copy_n(rgba, image.rgba.size(), image.rgba.begin());
  return image;
}
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineDefaultTone(OpalineTone* tone) {
  return guarded([&] { c::give(c::defaultTone(), tone, "tone"); });
}

OpalineStatus opalineAutomaticExposure(const OpalineScene* scene, float* stops) {
  return guarded(
      [&] { required(stops, "stops") = automaticExposureStops(required(scene, "scene").scene); });
}

OpalineStatus opalineWritePng(const char* file, const float* rgba, int32_t width, int32_t height,
                              const OpalineTone* tone) {
  return guarded([&] {
    writePng({&required(file, "file")},
             toneMap(c::imageOf(rgba, width, height, "rgba"), c::toneOf(tone)));
  });
}

OpalineStatus opalineWriteExr(const char* file, const float* rgba, int32_t width, int32_t height) {
  return guarded(
      [&] { writeExr({&required(file, "file")}, c::imageOf(rgba, width, height, "rgba")); });
}

OpalineStatus opalineReadImage(const char* file, OpalineImage** image) {
  return guarded([&] {
    required(image, "image");
    *image = new OpalineImage{{}, readHdrImage(&required(file, "file"), Negatives::Stay)};
  });
}

void opalineDestroyImage(OpalineImage* image) {
  c::destroy(image);
}

int32_t opalineImageWidth(const OpalineImage* image) {
  return c::isLiving(image) ? image->image.width : 0;
}

int32_t opalineImageHeight(const OpalineImage* image) {
  return c::isLiving(image) ? image->image.height : 0;
}

const float* opalineImagePixels(const OpalineImage* image) {
  return c::isLiving(image) ? image->image.rgba.data() : nullptr;
}

OpalineStatus opalineCompare(const float* rgbaOfA, const float* rgbaOfB, int32_t width,
                             int32_t height, OpalineDifference* difference) {
  return guarded([&] {
    const Image a = c::imageOf(rgbaOfA, width, height, "rgbaOfA");
    const Image b = c::imageOf(rgbaOfB, width, height, "rgbaOfB");
    const auto figures = compare::figuresOver(a, b, compare::commonPixels(a, b));
    if (!figures) throw UsageError("No pixel is covered by both images.");
    const compare::ErrorFigures& all = figures->all;
    c::give(
        {0, figures->coveredPixels, all.relRmse, all.relBias, all.p95Rel, all.maxAbs, all.psnrDb},
        difference, "difference");
  });
}

}  // extern "C"

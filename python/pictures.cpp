#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>

#include "opaline/compare.h"
#include "opaline/error.h"
#include "opaline/image_file.h"
#include "opaline/tone.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace opaline::python {

namespace {

ToneOptions toneOf(float exposureStops, const std::string& curve, const py::object& background) {
  ToneOptions tone;
  tone.exposureStops = exposureStops;
  if (curve != "neutral" && curve != "none") {
    throw UsageError(fmt::format("There is no curve '{}'; there are 'neutral' and 'none'.", curve));
  }
  tone.curve = curve == "neutral" ? ToneCurve::Neutral : ToneCurve::None;
  if (!background.is_none()) tone.background = vectorOf(background, "background");
  return tone;
}

py::dict figuresOf(const py::object& a, const py::object& b, const py::object& mask) {
  const Image first = imageOf(a, "a");
  const Image second = imageOf(b, "b");
  if (first.width != second.width || first.height != second.height) {
    throw UsageError(fmt::format("a is {}x{} and b is {}x{}; they must have one size.", first.width,
                                 first.height, second.width, second.height));
  }
  compare::Selection selection = compare::commonPixels(first, second);
  if (!mask.is_none()) {
    const auto chosen = py::array_t<bool, py::array::c_style | py::array::forcecast>::ensure(mask);
    if (!chosen || chosen.ndim() != 2 || chosen.shape(0) != first.height ||
        chosen.shape(1) != first.width) {
      PyErr_Clear();
      throw UsageError("mask must be an array (height, width) of the pictures' size.");
    }
    const bool* const counts = chosen.data();
    for (std::size_t i = 0; i < selection.size(); ++i) {
      if (!counts[i]) selection[i] = 0;
    }
  }
  const auto figures = compare::figuresOver(first, second, selection);
  if (!figures) {
    throw UsageError(mask.is_none()
                         ? "No pixel is covered by both pictures."
                         : "No pixel that the mask chooses is covered by both pictures.");
  }
  py::dict result;
  result["rel_rmse"] = figures->all.relRmse;
  result["rel_bias"] = figures->all.relBias;
  result["p95_rel"] = figures->all.p95Rel;
  result["max_abs"] = figures->all.maxAbs;
  result["psnr_db"] = figures->all.psnrDb;
  result["covered_pixels"] = figures->coveredPixels;
  return result;
}

}  // namespace

void bindPictures(py::module_& module) {
  using py::arg;
  module.def("compare", &figuresOf, arg("a"), arg("b"), arg("mask") = py::none(),
             R"(How far picture a is from b, over the pixels that both cover: a dict of floats.

a, b: arrays (height, width, 4) or (height, width, 3) of one size; mask: array (height, width), where it is true counts.
rel_rmse, rel_bias and p95_rel are over the mean of |b|; max_abs and psnr_db are absolute; covered_pixels is a count.)");
  module.def(
      "tone_map",
      [](const py::object& picture, float exposureStops, const std::string& curve,
         const py::object& background) {
        return arrayOf(
            toneMap(imageOf(picture, "picture"), toneOf(exposureStops, curve, background)));
      },
      arg("picture"), arg("exposure_stops") = 0.F, arg("curve") = "neutral",
      arg("background") = py::none(),
      R"(Linear radiance as sRGB to look at: array (height, width, 4), uint8.

exposure_stops: in [-32, 32], see Scene.exposure_stops; curve: neutral (Khronos PBR Neutral) or none; background: linear
RGB under the picture, or None, by which alpha stays coverage.)");
  module.def(
      "read_image",
      [](const std::filesystem::path& file) {
        return arrayOf(readHdrImage(file, Negatives::Stay));
      },
      arg("file"), "An .exr or .hdr file: array (height, width, 4), float32, linear.");
  module.def(
      "write_exr",
      [](const std::filesystem::path& file, const py::object& picture) {
        writeExr({file}, imageOf(picture, "picture"));
      },
      arg("file"), arg("picture"), "Writes an array (height, width, 3 or 4) as OpenEXR, float.");
  module.def(
      "write_png",
      [](const std::filesystem::path& file, const py::object& picture, float exposureStops,
         const std::string& curve, const py::object& background) {
        writePng({file},
                 toneMap(imageOf(picture, "picture"), toneOf(exposureStops, curve, background)));
      },
      arg("file"), arg("picture"), arg("exposure_stops") = 0.F, arg("curve") = "neutral",
      arg("background") = py::none(), "Writes what tone_map() makes of linear radiance.");
}

}  // namespace opaline::python

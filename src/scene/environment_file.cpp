#include "scene/environment_file.h"

#include <fmt/format.h>

#include <cmath>

#include "core/sound_image.h"
#include "opaline/error.h"
#include "opaline/image_file.h"
#include "scene/text.h"

namespace opaline::options {

template <>
const std::vector<Field<EnvironmentFile>>& fieldsOf() {
  using File = EnvironmentFile;
  static const std::vector<Field<File>> table{
      field<File, &File::intensity>("intensity", {{0, 1e6}}, "factor of its radiance"),
      field<File, &File::rotationDegrees>("rotation_degrees", {{-1e6, 1e6, "degrees"}}, "about +y"),
  };
  return table;
}

}  // namespace opaline::options

namespace opaline {

std::shared_ptr<const Image> readEnvironment(const EnvironmentFile& from) {
  if (const std::string complaint = options::complaintAboutFields(from); !complaint.empty())
    throw UsageError(complaint);
  Image image = readHdrImage(from.file);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    image.rgba[i] *= from.intensity;
    if (std::isfinite(image.rgba[i])) continue;
    throw Error(fmt::format("{}: an intensity of {} makes a pixel infinite",
                            scene::cleanText(from.file.string(), 1000), from.intensity));
  }
  return std::make_shared<const Image>(turned(image, from.rotationDegrees));
}

Image turned(const Image& environment, double degrees) {
  core::requireSound(environment);
  if (!std::isfinite(degrees)) throw UsageError("an environment must be turned by a finite angle");
  const double turns = degrees / 360;
  const double columns = (turns - std::floor(turns)) * environment.width;
  const double whole = std::floor(columns);
  const auto part = static_cast<float>(columns - whole);
  const int shift = static_cast<int>(whole);
  Image result(environment.width, environment.height);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const float* left = environment.pixel((x + shift) % result.width, y);
      const float* right = environment.pixel((x + shift + 1) % result.width, y);
      float* pixel = result.pixel(x, y);
      for (int c = 0; c < 4; ++c) {
        pixel[c] = part == 0 ? left[c] : (1 - part) * left[c] + part * right[c];
      }
    }
  }
  return result;
}

}  // namespace opaline

#include "renderer/readback.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gpu/device.h"
#include "gpu/transfer.h"

namespace opaline {

namespace {

Image emptyImage(const gpu::GpuImage& source) {
  return {static_cast<int>(source.extent().width), static_cast<int>(source.extent().height)};
}

Image readFloats(gpu::Device& device, gpu::GpuImage& source) {
  Image image = emptyImage(source);
  const std::vector<std::byte> bytes = gpu::readImage(device, source, 4 * sizeof(float));
  std::memcpy(image.rgba.data(), bytes.data(), image.rgba.size() * sizeof(float));
  return image;
}

Image readHalves(gpu::Device& device, gpu::GpuImage& source) {
  Image image = emptyImage(source);
  const std::vector<std::byte> bytes = gpu::readImage(device, source, 4 * sizeof(std::uint16_t));
  std::vector<std::uint16_t> halves(image.rgba.size());
  std::memcpy(halves.data(), bytes.data(), halves.size() * sizeof(std::uint16_t));
  std::transform(halves.begin(), halves.end(), image.rgba.begin(), glm::unpackHalf1x16);
  return image;
}

Image readCoverage(gpu::Device& device, gpu::GpuImage& source) {
  Image image = emptyImage(source);
  const std::vector<std::byte> bytes = gpu::readImage(device, source, sizeof(std::uint32_t));
  for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes[i * sizeof(value)], sizeof(value));
    image.rgba[4 * i + 3] = value != 0 ? 1.0F : 0.0F;
  }
  return image;
}

// Applies `change` to the four values of every pixel of `image` and `other`, which is as large.
template <typename Change>
Image combine(Image image, const Image& other, const Change& change) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) change(&image.rgba[i], &other.rgba[i]);
  return image;
}

void setGrey(float* pixel, float value) {
  std::fill_n(pixel, 3, value);
}

// What a shader reads by linear filtering with clamped coordinates.
void sampleLinear(const Image& map, float u, float v, float* rgba) {
  const float x =
      std::clamp(u * static_cast<float>(map.width) - 0.5F, 0.0F, static_cast<float>(map.width - 1));
  const float y = std::clamp(v * static_cast<float>(map.height) - 0.5F, 0.0F,
                             static_cast<float>(map.height - 1));
  const int x0 = std::min(static_cast<int>(x), std::max(map.width - 2, 0));
  const int y0 = std::min(static_cast<int>(y), std::max(map.height - 2, 0));
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  const int x1 = std::min(x0 + 1, map.width - 1);
  const int y1 = std::min(y0 + 1, map.height - 1);
  for (int c = 0; c < 4; ++c)
    rgba[c] = std::lerp(std::lerp(map.pixel(x0, y0)[c], map.pixel(x1, y0)[c], fx),
                        std::lerp(map.pixel(x0, y1)[c], map.pixel(x1, y1)[c], fx), fy);
}

// The accumulated samples hold colour times coverage.
Image radiance(gpu::Device& device, FrameResources& resources) {
  Image image = readFloats(device, resources.radiance);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    float& coverage = image.rgba[i + 3];
    if (coverage <= 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.rgba[i + c] /= coverage;
    coverage = std::min(coverage, 1.0F);
  }
  return image;
}

Image position(gpu::Device& device, FrameResources& resources) {
  Image image = readFloats(device, resources.surface.position);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    image.rgba[i] = image.rgba[i] > 0 ? 1.0F : 0.0F;
  return image;
}

Image depth(gpu::Device& device, FrameResources& resources, const CameraView& camera) {
  Image image = position(device, resources);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] <= 0) continue;
    const glm::vec3 point(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
    setGrey(&image.rgba[i], glm::dot(point - camera.position, camera.axis));
  }
  return image;
}

Image object(gpu::Device& device, FrameResources& resources) {
  Image image = readFloats(device, resources.surface.position);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const float index = image.rgba[i + 3];
    setGrey(&image.rgba[i], std::max(index - 1, 0.0F));
    image.rgba[i + 3] = index > 0 ? 1.0F : 0.0F;
  }
  return image;
}

Image irradiance(gpu::Device& device, FrameResources& resources) {
  const Image flux = readFloats(device, resources.sources.nearFlux);
  const std::vector<std::byte> bytes =
      gpu::readImage(device, resources.surface.place, sizeof(glm::vec2));
  Image image = position(device, resources);
  for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
    float* pixel = &image.rgba[4 * i];
    if (pixel[3] <= 0) continue;
    glm::vec2 place{};
    std::memcpy(&place, &bytes[i * sizeof(place)], sizeof(place));
    std::array<float, 4> mean{};
    sampleLinear(flux, place.x, place.y, mean.data());
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = mean[3] > 0 ? mean[c] / mean[3] : 0.0F;
  }
  return image;
}

Image withAlphaOf(Image image, const Image& coverage) {
  return combine(std::move(image), coverage,
                 [](float* pixel, const float* covered) { pixel[3] = covered[3]; });
}

}  // namespace

bool needsCentre(Aov aov) {
  switch (aov) {
    case Aov::Exitance:
    case Aov::Irradiance:
    case Aov::Position:
    case Aov::Normal:
    case Aov::Depth:
    case Aov::Object:
      return true;
    default:
      return false;
  }
}

Image readAov(gpu::Device& device, Aov aov, Site site, FrameResources& resources,
              const CameraView& camera) {
  const auto dsm = [&](Image image) {
    return withAlphaOf(std::move(image), readCoverage(device, resources.sources.coverage));
  };
  switch (aov) {
    case Aov::Radiance:
      return radiance(device, resources);
    case Aov::Exitance:
      return withAlphaOf(readFloats(device, visibleExitance(site, resources)),
                         position(device, resources));
    case Aov::Irradiance:
      return irradiance(device, resources);
    case Aov::Position:
      return position(device, resources);
    case Aov::Normal:
      return withAlphaOf(readHalves(device, resources.surface.normal), position(device, resources));
    case Aov::Depth:
      return depth(device, resources, camera);
    case Aov::Object:
      return object(device, resources);
    case Aov::DsmPosition:
      return dsm(readFloats(device, resources.sources.positionArea));
    case Aov::DsmNormal:
      return dsm(readHalves(device, resources.sources.normal));
    case Aov::DsmIrradiance:
      return dsm(readFloats(device, resources.sources.irradianceObject));
    case Aov::DsmArea:
      return combine(readCoverage(device, resources.sources.coverage),
                     readFloats(device, resources.sources.positionArea),
                     [](float* pixel, const float* place) { setGrey(pixel, place[3]); });
  }
  return {};
}

}  // namespace opaline

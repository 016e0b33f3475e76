#include "opaline/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "opaline/error.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace opaline::python {

namespace {

constexpr float most16 = 65535;

/// As picture files store it: what is no whole number goes from 0 to 1.
std::uint16_t storedOf(float value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.F, 1.F) * most16));
}

std::shared_ptr<const TexturePixels> pixelsOf(const py::object& given, const std::string& name) {
  const py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw UsageError("pixels is not an array of numbers.");
  }
  const char kind = array.dtype().kind();
  const auto bytes = array.dtype().itemsize();
  const bool isByte = kind == 'u' && bytes == 1;
  const bool isShort = kind == 'u' && bytes == 2;
  if (kind != 'f' && !isByte && !isShort) {
    throw UsageError(fmt::format("pixels is an array of {}; it must be uint8, uint16 or floats.",
                                 py::str(array.dtype()).cast<std::string>()));
  }
  const Image image = imageOf(array, "pixels");
  auto pixels = std::make_shared<TexturePixels>();
  pixels->width = image.width;
  pixels->height = image.height;
  pixels->name = name;
  pixels->rgba.resize(image.rgba.size());
  const bool hasAlpha = array.shape(2) == 4;
  const float scale = isByte ? 1 / 255.F : isShort ? 1 / most16 : 1;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const bool filledIn = i % 4 == 3 && !hasAlpha;
    if (!std::isfinite(image.rgba[i]))
      throw UsageError("pixels has a value that is infinite or not a number.");
    pixels->rgba[i] =
        filledIn ? std::numeric_limits<std::uint16_t>::max() : storedOf(scale * image.rgba[i]);
  }
  return pixels;
}

TextureWrap wrapOf(const std::string& name) {
  if (name == "repeat") return TextureWrap::Repeat;
  if (name == "mirror") return TextureWrap::MirroredRepeat;
  if (name == "clamp") return TextureWrap::ClampToEdge;
  throw UsageError(
      fmt::format("There is no wrap '{}'; there are 'repeat', 'mirror', 'clamp'.", name));
}

Texture makeTexture(const py::object& pixels, const std::string& wrap, bool interpolated,
                    const py::object& transform, const std::string& name) {
  Texture texture;
  texture.pixels = pixelsOf(pixels, name);
  texture.wrapU = texture.wrapV = wrapOf(wrap);
  texture.interpolated = interpolated;
  if (transform.is_none()) return texture;
  const auto rows = positionsOf(transform, "transform");
  if (rows.size() != 2) throw UsageError("transform must be two rows of three numbers.");
  texture.transform = {rows[0], rows[1]};
  return texture;
}

void bindTexture(py::module_& module) {
  using py::arg;
  py::class_<Texture>(module, "Texture",
                      R"(A picture that varies a number of a material. It never changes.

pixels: array (height, width, 3 or 4), row 0 at the top, uint8, uint16 or floats in [0, 1], as a picture file stores
them: colours sRGB-encoded, all else linear. wrap: "repeat", "mirror" or "clamp"; interpolated: False for sharp texels;
transform: two rows of an affine map from an object's texture_coordinates to the picture, whose upper left corner is (0, 0).)")
      .def(py::init(&makeTexture), arg("pixels"), arg("wrap") = "repeat",
           arg("interpolated") = true, arg("transform") = py::none(), arg("name") = "")
      .def_property_readonly(
          "size",
          [](const Texture& of) { return py::make_tuple(of.pixels->width, of.pixels->height); },
          "Width and height, texels.");
}

using MaybeTexture = std::optional<Texture>;

void bindOpaque(py::module_& module) {
  using py::arg;
  py::class_<OpaqueMaterial>(
      module, "OpaqueMaterial",
      R"(A surface without an inside: metallic-roughness, as glTF has it. It never changes.

A texture multiplies the number beside it. base_color: linear RGB in [0, 1]; metallic, roughness, specular, alpha,
alpha_cutoff: in [0, 1]; ior: in [1, 10]; specular_color: in [0, 1000]; emission: radiance, in [0, 1e30].
metallic_roughness_texture: green is roughness, blue metallic; normal_texture: in tangent space, green up.
diffuse_transmission, in [0, 1]: so much of the diffuse light goes through instead, as through a leaf or paper, in
diffuse_transmission_color; alpha of diffuse_transmission_texture multiplies it.)")
      .def(py::init(
               [](const py::object& baseColor, const MaybeTexture& baseColorTexture, float metallic,
                  float roughness, const MaybeTexture& metallicRoughnessTexture, float ior,
                  float specular, const py::object& specularColor,
                  const MaybeTexture& normalTexture, float normalScale, const py::object& emission,
                  const MaybeTexture& emissionTexture, float alpha, float alphaCutoff, bool unlit,
                  float diffuseTransmission, const MaybeTexture& diffuseTransmissionTexture,
                  const py::object& diffuseTransmissionColor,
                  const MaybeTexture& diffuseTransmissionColorTexture, const std::string& name) {
                 OpaqueMaterial made;
                 made.name = name;
                 made.baseColor = vectorOf(baseColor, "base_color");
                 made.baseColorTexture = baseColorTexture;
                 made.metallic = metallic;
                 made.roughness = roughness;
                 made.metallicRoughnessTexture = metallicRoughnessTexture;
                 made.ior = ior;
                 made.specular = specular;
                 made.specularColor = vectorOf(specularColor, "specular_color");
                 made.normalTexture = normalTexture;
                 made.normalScale = normalScale;
                 made.emission = vectorOf(emission, "emission");
                 made.emissionTexture = emissionTexture;
                 made.alpha = alpha;
                 made.alphaCutoff = alphaCutoff;
                 made.unlit = unlit;
                 made.diffuseTransmission = diffuseTransmission;
                 made.diffuseTransmissionTexture = diffuseTransmissionTexture;
                 made.diffuseTransmissionColor =
                     vectorOf(diffuseTransmissionColor, "diffuse_transmission_color");
                 made.diffuseTransmissionColorTexture = diffuseTransmissionColorTexture;
                 return sound(std::move(made));
               }),
           py::kw_only(), arg("base_color") = py::make_tuple(0.5, 0.5, 0.5),
           arg("base_color_texture") = py::none(), arg("metallic") = 0.F, arg("roughness") = 1.F,
           arg("metallic_roughness_texture") = py::none(), arg("ior") = 1.5F, arg("specular") = 1.F,
           arg("specular_color") = py::make_tuple(1, 1, 1), arg("normal_texture") = py::none(),
           arg("normal_scale") = 1.F, arg("emission") = py::make_tuple(0, 0, 0),
           arg("emission_texture") = py::none(), arg("alpha") = 1.F, arg("alpha_cutoff") = 0.F,
           arg("unlit") = false, arg("diffuse_transmission") = 0.F,
           arg("diffuse_transmission_texture") = py::none(),
           arg("diffuse_transmission_color") = py::make_tuple(1, 1, 1),
           arg("diffuse_transmission_color_texture") = py::none(), arg("name") = "")
      .def_property_readonly(
          "base_color", [](const OpaqueMaterial& of) { return tupleOf(of.baseColor); },
          "Linear RGB.")
      .def_readonly("metallic", &OpaqueMaterial::metallic, "In [0, 1].")
      .def_readonly("roughness", &OpaqueMaterial::roughness, "In [0, 1].")
      .def_readonly("diffuse_transmission", &OpaqueMaterial::diffuseTransmission, "In [0, 1].")
      .def_property_readonly(
          "emission", [](const OpaqueMaterial& of) { return tupleOf(of.emission); }, "Radiance.");
}

void bindSurface(py::module_& module) {
  using py::arg;
  py::class_<TranslucentSurface>(
      module, "TranslucentSurface",
      R"(How rough and uneven the surface of a translucent body is. It never changes.

roughness: of what it mirrors, in [0, 1]; None: render()'s, or 1 beside a texture. Normals also say where light enters. A
texture multiplies the number beside it: green of metallic_roughness_texture is roughness; normal_texture is in tangent
space, green up.)")
      .def(py::init([](std::optional<float> roughness, const MaybeTexture& metallicRoughnessTexture,
                       const MaybeTexture& normalTexture, float normalScale) {
             return sound(TranslucentSurface{roughness, metallicRoughnessTexture, normalTexture,
                                             normalScale});
           }),
           py::kw_only(), arg("roughness") = py::none(),
           arg("metallic_roughness_texture") = py::none(), arg("normal_texture") = py::none(),
           arg("normal_scale") = 1.F)
      .def_readonly("roughness", &TranslucentSurface::roughness, "In [0, 1], or None.");
}

}  // namespace

Material materialFrom(const py::object& medium, const py::object& opaqueColor,
                      const std::optional<OpaqueMaterial>& opaque,
                      const std::optional<Paint>& paint,
                      const std::optional<TranslucentSurface>& surface) {
  Material made{mediumOf(medium), paint, surface, opaque};
  if (!opaqueColor.is_none() && !opaque)
    made.opaque = sound(mattMaterial(vectorOf(opaqueColor, "opaque_color")));
  if (made.opaque && paint) throw UsageError("paint is for bodies that light enters.");
  if (made.opaque && surface) throw UsageError("surface is for bodies that light enters.");
  return made;
}

void bindMaterials(py::module_& module) {
  using py::arg;
  bindTexture(module);
  bindOpaque(module);
  bindSurface(module);
  py::class_<Paint>(module, "Paint",
                    R"(Colours on a translucent body, a layer on its surface. It never changes.

color: share of the light that entered which leaves again in even light, in [0, 100]; color_texture multiplies it. Where
they are brighter than the medium below can be, they are as bright as that.)")
      .def(py::init([](const py::object& color, const MaybeTexture& colorTexture) {
             return sound(Paint{{}, vectorOf(color, "color"), colorTexture});
           }),
           arg("color") = py::make_tuple(1, 1, 1), arg("color_texture") = py::none())
      .def_property_readonly(
          "color", [](const Paint& of) { return tupleOf(of.color); }, "Linear RGB.");
}

}  // namespace opaline::python

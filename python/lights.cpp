#include <string>
#include <utility>
#include <variant>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace opaline::python {

namespace {

template <typename Light>
void bindArea(py::class_<Light>& light) {
  light
      .def_property_readonly(
          "radiance", [](const Light& of) { return tupleOf(of.radiance); }, "Linear RGB.")
      .def_readonly("visible", &Light::visible, "Whether the picture itself shows it.");
}

}  // namespace

void bindLights(py::module_& module) {
  using py::arg;
  const py::tuple white = py::make_tuple(1, 1, 1);
  py::class_<DirectionalLight>(module, "DirectionalLight",
                               R"(Light from infinitely far away. It never changes.

direction_to_light: of any length above 0; irradiance: linear RGB on a surface that faces it, in [0, 1e30];
angular_radius_degrees: of the disc that surfaces mirror, in [0, 10].)")
      .def(py::init([](const py::object& direction, const py::object& irradiance, float radius) {
             return sound(DirectionalLight{unitOf(direction, "direction_to_light"),
                                           vectorOf(irradiance, "irradiance"), radius});
           }),
           arg("direction_to_light"), arg("irradiance") = white, arg("angular_radius_degrees") = 0)
      .def_readonly("angular_radius_degrees", &DirectionalLight::angularRadiusDegrees,
                    "Of the disc that surfaces mirror.")
      .def_property_readonly(
          "direction_to_light",
          [](const DirectionalLight& of) { return tupleOf(of.directionToLight); }, "Unit vector.")
      .def_property_readonly(
          "irradiance", [](const DirectionalLight& of) { return tupleOf(of.irradiance); },
          "Linear RGB.");
  py::class_<PointLight>(module, "PointLight",
                         R"(Light from one point. It never changes.

position_mm; intensity: linear RGB, in [0, 1e30]. Irradiance on a facing surface is intensity / distance², mm.)")
      .def(py::init([](const py::object& position, const py::object& intensity) {
             return sound(
                 PointLight{vectorOf(position, "position_mm"), vectorOf(intensity, "intensity")});
           }),
           arg("position_mm"), arg("intensity") = white)
      .def_property_readonly(
          "position_mm", [](const PointLight& of) { return tupleOf(of.positionMm); }, "mm.")
      .def_property_readonly(
          "intensity", [](const PointLight& of) { return tupleOf(of.intensity); }, "Linear RGB.");
  py::class_<SpotLight>(module, "SpotLight",
                        R"(A point light that shines into a cone. It never changes.

direction: away from the light; intensity: along its axis; as bright as there up to inner_degrees from the axis, dark
from outer_degrees on, in (0, 90].)")
      .def(py::init([](const py::object& position, const py::object& direction,
                       const py::object& intensity, float inner, float outer) {
             return sound(SpotLight{vectorOf(position, "position_mm"),
                                    unitOf(direction, "direction"),
                                    vectorOf(intensity, "intensity"), inner, outer});
           }),
           arg("position_mm"), arg("direction"), arg("intensity") = white,
           arg("inner_degrees") = 0.F, arg("outer_degrees") = 45.F)
      .def_property_readonly(
          "position_mm", [](const SpotLight& of) { return tupleOf(of.positionMm); }, "mm.")
      .def_property_readonly(
          "direction", [](const SpotLight& of) { return tupleOf(of.direction); }, "Unit vector.")
      .def_property_readonly(
          "intensity", [](const SpotLight& of) { return tupleOf(of.intensity); }, "Linear RGB.")
      .def_readonly("inner_degrees", &SpotLight::innerDegrees, "From the axis.")
      .def_readonly("outer_degrees", &SpotLight::outerDegrees, "From the axis.");

  py::class_<RectangleLight> rectangle(
      module, "RectangleLight",
      R"(A parallelogram that shines to the side of u × v. It never changes.

u_mm, v_mm: half its edges; radiance: linear RGB, in [0, 1e30]; two_sided: to the other side too; visible: in the
picture itself.)");
  rectangle
      .def(py::init([](const py::object& centre, const py::object& u, const py::object& v,
                       const py::object& radiance, bool twoSided, bool visible) {
             return sound(RectangleLight{vectorOf(centre, "centre_mm"), vectorOf(u, "u_mm"),
                                         vectorOf(v, "v_mm"), vectorOf(radiance, "radiance"),
                                         twoSided, visible});
           }),
           arg("centre_mm"), arg("u_mm"), arg("v_mm"), arg("radiance") = white,
           arg("two_sided") = false, arg("visible") = false)
      .def_property_readonly(
          "centre_mm", [](const RectangleLight& of) { return tupleOf(of.centreMm); }, "mm.")
      .def_property_readonly(
          "u_mm", [](const RectangleLight& of) { return tupleOf(of.uMm); }, "Half an edge, mm.")
      .def_property_readonly(
          "v_mm", [](const RectangleLight& of) { return tupleOf(of.vMm); }, "Half the other, mm.")
      .def_readonly("two_sided", &RectangleLight::twoSided, "Whether both sides shine.");
  bindArea(rectangle);
  py::class_<DiscLight> disc(module, "DiscLight",
                             R"(A disc that shines to the side of its normal. It never changes.)");
  disc.def(py::init([](const py::object& centre, const py::object& normal, float radius,
                       const py::object& radiance, bool twoSided, bool visible) {
             return sound(DiscLight{vectorOf(centre, "centre_mm"), unitOf(normal, "normal"), radius,
                                    vectorOf(radiance, "radiance"), twoSided, visible});
           }),
           arg("centre_mm"), arg("normal"), arg("radius_mm"), arg("radiance") = white,
           arg("two_sided") = false, arg("visible") = false)
      .def_property_readonly(
          "centre_mm", [](const DiscLight& of) { return tupleOf(of.centreMm); }, "mm.")
      .def_property_readonly(
          "normal", [](const DiscLight& of) { return tupleOf(of.normal); }, "Unit vector.")
      .def_readonly("radius_mm", &DiscLight::radiusMm, "In (0, 1e6].")
      .def_readonly("two_sided", &DiscLight::twoSided, "Whether both sides shine.");
  bindArea(disc);
  py::class_<SphereLight> sphere(module, "SphereLight",
                                 R"(A sphere that shines evenly outwards. It never changes.)");
  sphere
      .def(py::init([](const py::object& centre, float radius, const py::object& radiance,
                       bool visible) {
             return sound(SphereLight{vectorOf(centre, "centre_mm"), radius,
                                      vectorOf(radiance, "radiance"), visible});
           }),
           arg("centre_mm"), arg("radius_mm"), arg("radiance") = white, arg("visible") = false)
      .def_property_readonly(
          "centre_mm", [](const SphereLight& of) { return tupleOf(of.centreMm); }, "mm.")
      .def_readonly("radius_mm", &SphereLight::radiusMm, "In (0, 1e6].");
  bindArea(sphere);
  py::class_<TubeLight> tube(module, "TubeLight",
                             R"(A cylinder that shines evenly outwards. It never changes.)");
  tube.def(py::init([](const py::object& from, const py::object& to, float radius,
                       const py::object& radiance, bool visible) {
             return sound(TubeLight{vectorOf(from, "from_mm"), vectorOf(to, "to_mm"), radius,
                                    vectorOf(radiance, "radiance"), visible});
           }),
           arg("from_mm"), arg("to_mm"), arg("radius_mm"), arg("radiance") = white,
           arg("visible") = false)
      .def_property_readonly(
          "from_mm", [](const TubeLight& of) { return tupleOf(of.fromMm); }, "mm.")
      .def_property_readonly(
          "to_mm", [](const TubeLight& of) { return tupleOf(of.toMm); }, "mm.")
      .def_readonly("radius_mm", &TubeLight::radiusMm, "In (0, 1e6].");
  bindArea(tube);
}

py::tuple lightsOf(const SharedScene& shared) {
  py::list lights;
  const Lighting& lighting = shared.scene.lighting;
  for (const DirectionalLight& light : lighting.directional) lights.append(light);
  for (const PointLight& light : lighting.points) lights.append(light);
  for (const SpotLight& light : lighting.spots) lights.append(light);
  for (const AreaLight& light : lighting.areas) {
    std::visit([&](const auto& kind) { lights.append(kind); }, light);
  }
  return lights;
}

void setLights(SharedScene& shared, const py::iterable& lights) {
  Lighting lighting = shared.scene.lighting;
  lighting.directional.clear();
  lighting.points.clear();
  lighting.spots.clear();
  lighting.areas.clear();
  for (const py::handle& light : lights) {
    if (py::isinstance<DirectionalLight>(light)) {
      lighting.directional.push_back(light.cast<DirectionalLight>());
    } else if (py::isinstance<PointLight>(light)) {
      lighting.points.push_back(light.cast<PointLight>());
    } else if (py::isinstance<SpotLight>(light)) {
      lighting.spots.push_back(light.cast<SpotLight>());
    } else if (py::isinstance<RectangleLight>(light)) {
      lighting.areas.emplace_back(light.cast<RectangleLight>());
    } else if (py::isinstance<DiscLight>(light)) {
      lighting.areas.emplace_back(light.cast<DiscLight>());
    } else if (py::isinstance<SphereLight>(light)) {
      lighting.areas.emplace_back(light.cast<SphereLight>());
    } else if (py::isinstance<TubeLight>(light)) {
      lighting.areas.emplace_back(light.cast<TubeLight>());
    } else {
      throw py::type_error(
          "lights must be DirectionalLight, PointLight, SpotLight, RectangleLight, "
          "DiscLight, SphereLight or TubeLight");
    }
  }
  shared.scene.lighting = sound(std::move(lighting));
}

}  // namespace opaline::python

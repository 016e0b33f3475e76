#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "opaline/environment.h"
#include "opaline/error.h"
#include "opaline/exposure.h"
#include "opaline/image_file.h"
#include "opaline/material.h"
#include "opaline/media.h"
#include "opaline/mesh.h"
#include "opaline/scene.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace opaline::python {

SharedScene::SharedScene(Scene whole) : scene(std::move(whole)) {
  for (Object& object : scene.objects)
    objects.push_back(std::make_shared<Object>(std::move(object)));
  scene.objects.clear();
}

Scene SharedScene::whole() const {
  Scene result = scene;
  for (const auto& object : objects) result.objects.push_back(*object);
  return result;
}

namespace {

void requireOneEach(std::size_t count, std::size_t vertices, const char* name) {
  if (count != vertices) {
    throw UsageError(
        fmt::format("{} has {} rows, but there are {} vertices.", name, count, vertices));
  }
}

void setNormals(Mesh& mesh, const py::object& given) {
  std::vector<Vec3> normals = positionsOf(given, "normals");
  requireOneEach(normals.size(), mesh.positionsMm.size(), "normals");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto& [x, y, z] = normals[i];
    const float length = std::hypot(x, y, z);
    // What has no direction keeps the normal that its triangles give it.
    if (length > 0 && std::isfinite(length)) {
      mesh.normals[i] = {x / length, y / length, z / length};
    }
  }
}

void setTextureCoordinates(Mesh& mesh, const py::object& given) {
  std::vector<Vec2> places = placesOf(given, "texture_coordinates");
  requireOneEach(places.size(), mesh.positionsMm.size(), "texture_coordinates");
  for (const Vec2& place : places) {
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) {
      throw UsageError("texture_coordinates has a value that is infinite or not a number.");
    }
  }
  mesh.textureCoordinates[0] = std::move(places);
}

std::shared_ptr<Object> makeObject(const py::object& positions, const py::object& triangles,
                                   const py::object& medium, const std::string& name,
                                   const py::object& opaqueColor,
                                   const std::optional<OpaqueMaterial>& material,
                                   const std::optional<Paint>& paint,
                                   const std::optional<TranslucentSurface>& surface,
                                   const py::object& normals,
                                   const py::object& textureCoordinates) {
  py::object vertices = positions;
  py::object faces = triangles;
  if (faces.is_none()) {
    if (!py::hasattr(positions, "vertices") || !py::hasattr(positions, "faces")) {
      throw UsageError(
          "An Object is made of positions and triangles, or of a mesh that has "
          "vertices and faces.");
    }
    vertices = positions.attr("vertices");
    faces = positions.attr("faces");
  }
  auto object = std::make_shared<Object>();
  object->name = name;
  object->mesh = makeMesh(positionsOf(vertices, "positions_mm"), trianglesOf(faces, "triangles"));
  giveMaterial(materialFrom(medium, opaqueColor, material, paint, surface), *object);
  if (!normals.is_none()) setNormals(object->mesh, normals);
  if (!textureCoordinates.is_none()) setTextureCoordinates(object->mesh, textureCoordinates);
  return object;
}

std::vector<std::shared_ptr<Object>> objectsOf(const py::iterable& given) {
  std::vector<std::shared_ptr<Object>> objects;
  for (const py::handle& each : given) {
    if (py::isinstance<Object>(each)) {
      objects.push_back(each.cast<std::shared_ptr<Object>>());
    } else {
      objects.push_back(makeObject(py::reinterpret_borrow<py::object>(each), py::none(),
                                   py::str("marble"), "", py::none(), {}, {}, {}, py::none(),
                                   py::none()));
    }
  }
  return objects;
}

LoadOptions loadOptionsOf(const py::object& medium, std::optional<float> diagonalMm,
                          std::optional<std::filesystem::path> morphTo,
                          const std::optional<std::string>& colorModel = {}) {
  LoadOptions options;
  if (colorModel) options.colorModel = colorModelOf(*colorModel);
  options.diagonalMm = diagonalMm;
  options.morphTo = std::move(morphTo);
  if (!medium.is_none()) options.medium = mediumOf(medium);
  options.log = pythonLog();
  return options;
}

template <typename Make>
std::shared_ptr<SharedScene> sceneBy(Make&& make) {
  const py::gil_scoped_release released;
  return std::make_shared<SharedScene>(make());
}

void setEnvironment(SharedScene& shared, const py::object& picture, float intensity,
                    double rotationDegrees) {
  Lighting& lighting = shared.scene.lighting;
  if (picture.is_none()) {
    lighting.environment.reset();
    return;
  }
  if (!(intensity >= 0 && std::isfinite(intensity)) || !std::isfinite(rotationDegrees)) {
    throw UsageError("intensity must be finite and not negative, rotation_degrees finite.");
  }
  if (py::isinstance<py::str>(picture) || py::hasattr(picture, "__fspath__")) {
    const EnvironmentFile file{picture.cast<std::filesystem::path>(), intensity, rotationDegrees};
    const py::gil_scoped_release released;
    lighting.environment = readEnvironment(file);
    return;
  }
  Image image = imageOf(picture, "picture");
  for (float& value : image.rgba) {
    value *= intensity;
    if (!std::isfinite(value) || value < 0) {
      throw UsageError("The radiance of an environment must be finite and not negative.");
    }
  }
  lighting.environment = std::make_shared<const Image>(turned(image, rotationDegrees));
}

void bindObjects(py::module_& module) {
  using py::arg;
  py::class_<Object, std::shared_ptr<Object>>(module, "Object", R"(A body of one medium.

Object(positions_mm, triangles, medium="wax"): positions are an array (N, 3) of any kind of number, triangles an array
(M, 3) of whole numbers, counter-clockwise seen from outside. Object(mesh, medium="wax") takes anything with .vertices
and .faces. medium is a Medium or the name of one. With opaque_color, linear RGB in [0, 1], it is a matt surface that lets
no light in; material, an OpaqueMaterial, says more of it. paint, a Paint, colours a body that light enters, and
surface, a TranslucentSurface, says how rough it is. normals (N, 3) and texture_coordinates (N, 2) are of the vertices; without normals the surface is smooth. A closed mesh has an inside; in
an open one light scatters as in a half-space.)")
      .def(py::init(&makeObject), arg("positions_mm"), arg("triangles") = py::none(),
           arg("medium") = "marble", arg("name") = "", py::kw_only(),
           arg("opaque_color") = py::none(), arg("material") = py::none(),
           arg("paint") = py::none(), arg("surface") = py::none(), arg("normals") = py::none(),
           arg("texture_coordinates") = py::none())
      .def_readwrite("name", &Object::name, "Its name, or an empty text.")
      .def_property(
          "medium", [](const Object& object) { return object.medium; },
          [](Object& object, const py::object& medium) {
            object.medium = mediumOf(medium);
            object.opaque.reset();
          },
          "What it is made of. May be set to a Medium or the name of one; a Renderer that has the\n"
          "scene already keeps what it has, see Renderer.set_medium.")
      .def_property_readonly(
          "is_opaque", [](const Object& object) { return object.opaque.has_value(); },
          "Whether it is a surface that lets no light in.")
      .def_property_readonly(
          "positions_mm", [](const Object& object) { return arrayOf(object.mesh.positionsMm); },
          "Its vertices at rest: array (N, 3), float32, a copy.")
      .def_property_readonly(
          "normals", [](const Object& object) { return arrayOf(object.mesh.normals); },
          "Unit normals of the vertices at rest: array (N, 3), float32, a copy.")
      .def_property_readonly(
          "triangles", [](const Object& object) { return arrayOf(object.mesh.triangles); },
          "Array (M, 3), uint32, a copy.")
      .def("__repr__", [](const Object& object) {
        return fmt::format("<opaline.Object '{}': {} vertices, {} triangles>", object.name,
                           object.mesh.positionsMm.size(), object.mesh.triangles.size());
      });
  py::class_<Camera>(module, "Camera",
                     R"(A pinhole camera, or an orthographic one. It never changes.

position_mm, target_mm: where it stands and what it looks at; vertical_fov_degrees: in [1, 170]; shift_x, shift_y: move
what is seen without turning the camera, in widths of the picture to the right and in heights up;
orthographic_height_mm: if given, lines of sight are parallel and the picture is so high.)")
      .def(py::init([](const py::object& position, const py::object& target, const py::object& up,
                       float fov, float shiftX, float shiftY, std::optional<float> heightMm) {
             return sound(Camera{vectorOf(position, "position_mm"), vectorOf(target, "target_mm"),
                                 vectorOf(up, "up"), fov, shiftX, shiftY, heightMm});
           }),
           arg("position_mm"), arg("target_mm") = py::make_tuple(0, 0, 0),
           arg("up") = py::make_tuple(0, 1, 0), arg("vertical_fov_degrees") = 30.F, py::kw_only(),
           arg("shift_x") = 0.F, arg("shift_y") = 0.F, arg("orthographic_height_mm") = py::none())
      .def_property_readonly(
          "position_mm", [](const Camera& of) { return tupleOf(of.positionMm); }, "mm.")
      .def_property_readonly(
          "target_mm", [](const Camera& of) { return tupleOf(of.targetMm); }, "mm.")
      .def_property_readonly(
          "up", [](const Camera& of) { return tupleOf(of.up); }, "What is up in the picture.")
      .def_readonly("vertical_fov_degrees", &Camera::verticalFovDegrees, "In [1, 170].")
      .def_readonly("shift_x", &Camera::shiftX, "Of what is seen, widths to the right.")
      .def_readonly("shift_y", &Camera::shiftY, "Of what is seen, heights up.")
      .def_readonly("orthographic_height_mm", &Camera::orthographicHeightMm,
                    "Height of an orthographic picture, mm; None of a pinhole camera.");
}

void bindScene(py::module_& module) {
  using py::arg;
  py::class_<SharedScene, std::shared_ptr<SharedScene>>(
      module, "Scene",
      R"(Objects, lights and a camera, as plain data.

Scene(objects): a list of Object, or of anything with .vertices and .faces. Camera and lights are usual ones until they
are set. A Renderer takes what it needs: later changes reach it by its own methods.)")
      .def(py::init([](const py::iterable& objects) {
             auto shared = std::make_shared<SharedScene>();
             shared->objects = objectsOf(objects);
             shared->scene.camera = defaultCamera(shared->whole());
             shared->scene.lighting = defaultLighting();
             return shared;
           }),
           arg("objects"))
      .def_property(
          "objects",
          [](const SharedScene& shared) {
            py::list objects;
            for (const auto& object : shared.objects) objects.append(object);
            return py::tuple(objects);
          },
          [](SharedScene& shared, const py::iterable& objects) {
            shared.objects = objectsOf(objects);
          },
          "Its bodies, a tuple. Set it to a list of others.")
      .def_property("lights", &lightsOf, &setLights,
                    "A tuple of lights, at most 16. Set it to a list of others: changing what it\n"
                    "returns changes nothing.")
      .def_property(
          "ambient",
          [](const SharedScene& shared) { return tupleOf(shared.scene.lighting.ambient); },
          [](SharedScene& shared, const py::object& radiance) {
            Lighting lighting = shared.scene.lighting;
            lighting.ambient = vectorOf(radiance, "ambient");
            shared.scene.lighting = sound(std::move(lighting));
          },
          "Radiance from all directions alike, linear RGB.")
      .def(
          "set_environment", &setEnvironment, arg("picture"), arg("intensity") = 1.F,
          arg("rotation_degrees") = 0.0,
          R"(Light from all around: an .exr or .hdr file, or an array (height, width, 3 or 4) of radiance, latitude by
longitude, whose top row is +y and whose centre column is -z; or None.)")
      .def_property(
          "camera", [](const SharedScene& shared) { return shared.scene.camera; },
          [](SharedScene& shared, const Camera& camera) {
            shared.scene.camera = camera;
            shared.scene.cameraChosen = true;
          },
          "The Camera.")
      .def(
          "look_from",
          [](SharedScene& shared, const py::object& direction, float fov, float distance) {
            Camera camera = defaultCamera(shared.whole(), unitOf(direction, "direction"), fov);
            for (std::size_t i = 0; i < 3; ++i) {
              camera.positionMm[i] = camera.targetMm[i] +
                                     distance / 1.4F * (camera.positionMm[i] - camera.targetMm[i]);
            }
            shared.scene.camera = sound(camera);
            shared.scene.cameraChosen = true;
          },
          arg("direction"), arg("vertical_fov_degrees") = 30.F, arg("diagonals") = 1.93F,
          "Places the camera in a direction from the middle of the scene, so many diagonals of "
          "its\n"
          "box away; 1.93 shows all of it at 30 degrees.")
      .def(
          "add_ground",
          [](SharedScene& shared, const py::object& color, std::optional<float> heightMm) {
            const Ground ground = sound(Ground{vectorOf(color, "color"), heightMm});
            shared.objects.push_back(std::make_shared<Object>(groundUnder(shared.whole(), ground)));
          },
          arg("color") = py::make_tuple(0.5, 0.5, 0.5), arg("height_mm") = py::none(),
          "Adds an opaque plane under all there is, which gives back this share of light.")
      .def_property_readonly(
          "diagonal_mm", [](const SharedScene& shared) { return diagonalMm(shared.whole()); },
          "Length of the diagonal of the box around it, mm.")
      .def_property_readonly(
          "exposure_stops",
          [](const SharedScene& shared) { return automaticExposureStops(shared.whole()); },
          "The exposure that suits its light, stops.")
      .def_property_readonly(
          "clips",
          [](const SharedScene& shared) {
            py::dict clips;
            for (const Clip& clip : shared.scene.clips) clips[clip.name.c_str()] = clip.seconds;
            return clips;
          },
          "Its motions: name -> length in seconds, in their order.")
      .def_property_readonly(
          "repairs",
          [](const SharedScene& shared) {
            py::dict repairs;
            for (const Repair& repair : shared.scene.repairs)
              repairs[repair.what.c_str()] = repair.count;
            return repairs;
          },
          "What was mended when it was loaded: kind -> count.")
      .def_property_readonly(
          "name", [](const SharedScene& shared) { return shared.scene.name; },
          "Of its file, or an empty text.")
      .def("__repr__", [](const SharedScene& shared) {
        const std::size_t count = shared.objects.size();
        return fmt::format("<opaline.Scene '{}': {} object{}>", shared.scene.name, count,
                           count == 1 ? "" : "s");
      });
}

}  // namespace

void bindScenes(py::module_& module) {
  using py::arg;
  bindLights(module);
  bindObjects(module);
  bindScene(module);
  module.def(
      "load",
      [](const std::filesystem::path& file, const py::object& medium,
         std::optional<float> diagonalMm, std::optional<std::filesystem::path> morphTo,
         const std::optional<std::string>& colorModel) {
        const LoadOptions options =
            loadOptionsOf(medium, diagonalMm, std::move(morphTo), colorModel);
        return sceneBy([&] { return loadScene(file, options); });
      },
      arg("file"), arg("medium") = py::none(), arg("diagonal_mm") = py::none(),
      arg("morph_to") = py::none(), arg("color_model") = py::none(),
      R"(Reads a .glb, .gltf, .obj, .ply or .toml file and repairs its meshes.

medium: a Medium or its name, of everything that is no metal; diagonal_mm: length that the diagonal of the box around the
scene is scaled to; morph_to: a file with a mesh of the same topology that the scene turns into; color_model: what colors of media
in the file mean, "observed" or "khr".)");
  module.def(
      "bear",
      [](const py::object& medium, std::optional<float> diagonalMm) {
        const LoadOptions options = loadOptionsOf(medium, diagonalMm, {});
        return sceneBy([&] { return builtInBear(options); });
      },
      arg("medium") = py::none(), arg("diagonal_mm") = py::none(),
      "The built-in gummy bear, 50 mm, of marble unless said otherwise.");
  module.def(
      "teapot",
      [](const py::object& medium, std::optional<float> diagonalMm) {
        const LoadOptions options = loadOptionsOf(medium, diagonalMm, {});
        return sceneBy([&] { return builtInTeapot(options); });
      },
      arg("medium") = py::none(), arg("diagonal_mm") = py::none(),
      "The Utah teapot, 50 mm, of marble unless said otherwise.");
}

}  // namespace opaline::python

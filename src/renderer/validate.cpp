#include "renderer/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "scene/finish.h"
#include "shaders/shared/seen.h"

namespace opaline {

namespace {

template <typename T>
bool finite(const T& values) {
  return std::all_of(values.begin(), values.end(), [](auto v) { return std::isfinite(v); });
}

template <typename Surface>
void requireSound(const std::string& name, const Surface& material) {
  const std::string complaint = complaintAbout(material);
  if (!complaint.empty()) throw Error(fmt::format("object '{}': {}", name, complaint));
}

void validateMesh(const Object& object) {
  const Mesh& mesh = object.mesh;
  if (mesh.normals.size() != mesh.positionsMm.size())
    throw Error(fmt::format("object '{}' has {} normals for {} vertices", object.name,
                            mesh.normals.size(), mesh.positionsMm.size()));
  const auto allFinite = [](const std::vector<Vec3>& list) {
    return std::all_of(list.begin(), list.end(), [](const Vec3& v) { return finite(v); });
  };
  if (!allFinite(mesh.positionsMm) || !allFinite(mesh.normals))
    throw Error(fmt::format("object '{}' has coordinates that are not finite", object.name));
  const auto requireOneEach = [&](std::size_t count, const char* what) {
    if (count != 0 && count != mesh.positionsMm.size())
      throw Error(fmt::format("object '{}' has {} {} for {} vertices", object.name, count, what,
                              mesh.positionsMm.size()));
  };
  for (const std::vector<Vec2>& set : mesh.textureCoordinates) {
    requireOneEach(set.size(), "texture coordinates");
    if (!std::all_of(set.begin(), set.end(), [](const Vec2& v) { return finite(v); }))
      throw Error(
          fmt::format("object '{}' has texture coordinates that are not finite", object.name));
  }
  requireOneEach(mesh.colors.size(), "colors");
  for (const std::array<float, 4>& color : mesh.colors)
    if (!std::all_of(color.begin(), color.end(), [](float value) { return std::isfinite(value); }))
      throw Error(fmt::format("object '{}' has vertex colors that are not finite", object.name));
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle)
      if (index >= mesh.positionsMm.size())
        throw Error(fmt::format("object '{}' has a triangle of vertex {} but only {} vertices",
                                object.name, index, mesh.positionsMm.size()));
}

}  // namespace

void requireObject(std::size_t object, std::size_t count) {
  if (object >= count)
    throw UsageError(fmt::format("there is no object {}: the scene has {}", object, count));
}

void validate(const RenderOptions& options) {
  const std::string complaint = options::complaintAbout(options);
  if (!complaint.empty()) throw UsageError(complaint);
}

void validate(const RenderOptions& options, const std::vector<Aov>& aovs) {
  for (const Aov aov : aovs)
    if (!options::hasName(aov))
      throw UsageError(fmt::format("there is no variable {}", static_cast<int>(aov)));
  if (options.sum == Sum::Pattern &&
      std::find(aovs.begin(), aovs.end(), Aov::Surfels) != aovs.end())
    throw UsageError("the pattern has no surfels to show; the sums tree and all have");
}

void validate(const Medium& medium) {
  const std::string complaint = complaintAbout(medium);
  if (!complaint.empty()) throw Error(fmt::format("medium '{}': {}", medium.name, complaint));
}

void validate(const std::string& object, const Material& material) {
  if (material.opaque)
    requireSound(object, *material.opaque);
  else
    validate(material.medium);
  if (material.paint) requireSound(object, *material.paint);
  if (material.surface) requireSound(object, *material.surface);
}

void validate(const Lighting& lighting) {
  if (std::string complaint = complaintAbout(lighting); !complaint.empty()) throw Error(complaint);
}

void validate(const Camera& camera) {
  const std::string complaint = complaintAbout(camera);
  if (!complaint.empty()) throw Error("the camera: " + complaint);
}

void validate(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Object& object : scene.objects) {
    validateMesh(object);
    validate(object.name, materialOf(object));
    if (object.isGround && (&object != &scene.objects.back() || !object.opaque || object.rig))
      throw Error("a ground must be opaque, have no rig and come after all other objects");
    triangles += object.mesh.triangles.size();
  }
  if (triangles == 0) throw Error(fmt::format("scene '{}' has no triangles", scene.name));
  if (const double diagonal = diagonalMm(scene);
      !(diagonal >= scene::shortestDiagonalMm && diagonal <= scene::longestDiagonalMm))
    throw Error(
        fmt::format("scene '{}' has a diagonal of {:.3g} mm, but must have {:.3g} to {:.3g} mm",
                    scene.name, diagonal, scene::shortestDiagonalMm, scene::longestDiagonalMm));
  if (triangles > shared::maxTriangles)
    throw Error(fmt::format("scene '{}' has {} triangles, but {} are the most there may be",
                            scene.name, triangles, shared::maxTriangles));
  validateMotion(scene);
  validate(scene.lighting);
  validate(scene.camera);
}

}  // namespace opaline

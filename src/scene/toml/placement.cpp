#include "scene/toml/placement.h"

#include <algorithm>
#include <cmath>

#include "scene/matrix.h"
#include "scene/placed_lights.h"

namespace opaline::scene {

namespace {

Matrix4 matrixOf(const Placement& placement) {
  if (placement.rows) {
    std::array<double, 16> columns{};
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) columns[4 * c + r] = (*placement.rows)[4 * r + c];
    }
    return matrixFromColumns(columns);
  }
  const double scale = placement.scale;
  Matrix4 matrix = matrixFromParts({0, 0, 0}, {0, 0, 0, 1}, {scale, scale, scale});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double half = double{placement.rotationDegrees[axis]} * std::acos(-1.0) / 360;
    std::array<double, 4> rotation{0, 0, 0, std::cos(half)};
    rotation[axis] = std::sin(half);
    matrix = matrixFromParts({0, 0, 0}, rotation, {1, 1, 1}) * matrix;
  }
  matrix.column[3] = toDouble(placement.translationMm);
  return matrix;
}

}  // namespace

std::optional<Placement> readPlacement(const TomlTable& table) {
  const bool parts =
      table.has("translation_mm") || table.has("rotation_degrees") || table.has("scale");
  Placement placement;
  if (const auto rows = table.numbers("transform", 16)) {
    if (parts)
      table.fail("transform", "cannot stand beside translation_mm, rotation_degrees, scale");
    if ((*rows)[12] != 0 || (*rows)[13] != 0 || (*rows)[14] != 0 || (*rows)[15] != 1) {
      table.fail("transform", "must end in the row 0, 0, 0, 1");
    }
    std::copy_n(rows->begin(), 16, placement.rows.emplace().begin());
    return placement;
  }
  if (!parts) return std::nullopt;
  placement.translationMm = table.vector("translation_mm").value_or(Vec3{0, 0, 0});
  placement.rotationDegrees = table.vector("rotation_degrees").value_or(Vec3{0, 0, 0});
  placement.scale = table.number("scale", {1e-6, 1e6}).value_or(1);
  return placement;
}

void place(RawObject& object, const Placement& placement, const TomlTable& table) {
  const Matrix4 matrix = matrixOf(placement);
  RawMesh& mesh = object.mesh;
  if (std::abs(matrix.determinant()) < 1e-30) table.fail("", "has a transform that flattens");
  for (Vec3& p : mesh.positions) {
    p = toFloat(matrix.point(toDouble(p)));
    if (!isFinite(p)) table.fail("", "has a transform that leaves the range of a float");
  }
  for (Vec3& n : mesh.normals) {
    const Double3 mapped = matrix.normal(toDouble(n));
    n = toFloat((1 / length(mapped)) * mapped);
  }
  if (matrix.determinant() < 0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  if (!object.rig) return;
  object.rig->toScene = affineFrom(matrix * matrixFrom(object.rig->toScene));
  if (!isFinite(object.rig->toScene)) {
    table.fail("", "has a transform that leaves the range of a float");
  }
}

void place(RawScene& model, const Placement& placement, const TomlTable& table) {
  for (RawObject& object : model.objects) place(object, placement, table);
  const Matrix4 matrix = matrixOf(placement);
  bool finite = placeLights(matrix, model.lighting);
  if (model.camera) finite = placeCamera(matrix, *model.camera) && finite;
  finite = placeChanges(matrix, model.changes) && finite;
  if (!finite) table.fail("", "has a transform that leaves the range of a float");
}

}  // namespace opaline::scene

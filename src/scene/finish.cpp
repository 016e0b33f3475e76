#include "scene/finish.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/error.h"
#include "opaline/media.h"
#include "opaline/options/scene.h"
#include "scene/changes.h"
#include "scene/formats.h"
#include "scene/material.h"
#include "scene/matrix.h"
#include "scene/not_shown.h"
#include "scene/placed_lights.h"
#include "scene/repair/duplicate_objects.h"
#include "scene/repair/repair.h"
#include "scene/rig.h"
#include "scene/text.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

constexpr double assumedDiagonalMm = 50;

struct Box {
  Double3 low{INFINITY, INFINITY, INFINITY};
  Double3 high{-INFINITY, -INFINITY, -INFINITY};

  void add(const Vec3& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], double{p[axis]});
      high[axis] = std::max(high[axis], double{p[axis]});
    }
  }
  Bounds bounds() const {
    return low[0] <= high[0] ? Bounds{toFloat(low), toFloat(high)} : Bounds{};
  }
};

void scalePoint(Vec3& p, double factor) {
  p = toFloat(factor * toDouble(p));
}

bool lostArea(const RawMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Double3 n = areaVector(toDouble(mesh.positions[t[0]]), toDouble(mesh.positions[t[1]]),
                                 toDouble(mesh.positions[t[2]]));
    return !(dot(n, n) > 0);
  });
}

bool scaleRig(Rig& rig, double factor) {
  const Matrix4 scale =
      matrixFromParts({0, 0, 0}, {0, 0, 0, 1}, {factor, factor, factor}) * matrixFrom(rig.toScene);
  rig.toScene = affineFrom(scale);
  return isFinite(rig.toScene);
}

std::string nameIn(const std::string& file, const RawObject& object) {
  return fmt::format("{}, object '{}'", file, object.name);
}

/// A face without area in the rest pose has no place in the atlas, so it stays hidden even where
/// the motion would open it.
void noteLostFaces(const std::vector<Repair>& repairs, const RawObject& object,
                   const std::string& name, const LogCallback& log) {
  if (!object.rig) return;
  std::size_t lost = 0;
  for (const Repair& repair : repairs) {
    if (repair.what == "degenerate triangles" || repair.what == "duplicate faces") {
      lost += repair.count;
    }
  }
  if (lost == 0) return;
  note(log, fmt::format("{}: {} faces that have no area or lie upon others in the rest pose stay "
                        "left out when it moves",
                        nameIn(name, object), lost));
}

/// To be turned changes what a surface encloses, so it is said although it is among the repairs.
void noteTurned(const std::vector<Repair>& repairs, const std::string& name,
                const LogCallback& log) {
  for (const Repair& repair : repairs) {
    if (repair.what != "inward orientation") continue;
    note(log, fmt::format("{}: {} triangles faced inwards and were turned outwards; only a closed "
                          "surface inside another of the same object stays a cavity",
                          name, repair.count));
  }
}

/// Counts in `hidden` what the object's own material has and the medium does not show.
void makeTranslucent(const Medium& medium, std::size_t index, Scene& scene,
                     std::vector<NotShown>& hidden) {
  Object& object = scene.objects[index];
  forgetMaterial(scene.changes, index);
  addReplaced(hidden, object, !object.mesh.colors.empty());
  putMedium(medium, object);
}

Mesh meshOf(RawObject& object) {
  return {.positionsMm = std::move(object.mesh.positions),
          .normals = std::move(object.mesh.normals),
          .triangles = std::move(object.mesh.triangles),
          .facetted = object.mesh.facetted,
          .textureCoordinates = std::move(object.attributes.textureCoordinates),
          .colors = std::move(object.attributes.colors)};
}

}  // namespace

Bounds boundsOf(const RawScene& raw) {
  Box box;
  for (const RawObject& object : raw.objects) {
    for (const Vec3& p : object.mesh.positions) box.add(p);
  }
  return box.bounds();
}

Double3 exactMiddleOf(const Bounds& bounds) {
  return 0.5 * (toDouble(bounds.minMm) + toDouble(bounds.maxMm));
}

double diagonalOf(const Bounds& bounds) {
  return length(toDouble(bounds.maxMm) - toDouble(bounds.minMm));
}

void scaleBy(RawScene& raw, double factor, const std::string& file) {
  bool finite = std::isfinite(factor);
  for (RawObject& object : raw.objects) {
    for (Vec3& p : object.mesh.positions) {
      scalePoint(p, factor);
      finite = finite && isFinite(p);
    }
    if (object.rig) finite = scaleRig(*object.rig, factor) && finite;
  }
  finite = scaleLights(factor, raw.lighting) && finite;
  finite = scaleChanges(factor, raw.changes) && finite;
  if (raw.camera) finite = scaleCamera(factor, *raw.camera) && finite;
  if (!finite) {
    throw Error(fmt::format("{}: in millimetres its coordinates are too large for a float", file));
  }
}

RawScene inMillimetres(RawScene raw, const std::filesystem::path& file, bool noteUnit,
                       const LogCallback& log, std::vector<Repair>& repairs) {
  const std::string name = cleanText(file.string(), 1000);
  if (raw.objects.empty()) {
    throw Error(fmt::format("{}: there is no triangle mesh in it", name));
  }
  std::vector<Repair> ofFile;
  for (RawObject& object : raw.objects) {
    const std::vector<Repair> mended = repairMesh(object.mesh, nameIn(name, object));
    for (const Repair& repair : mended) addRepair(ofFile, repair.what, repair.count);
    noteLostFaces(mended, object, name, log);
  }
  for (const Repair& repair : ofFile) addRepair(repairs, repair.what, repair.count);
  noteTurned(ofFile, name, log);
  double factor = raw.mmPerUnit.value_or(1.0);
  if (!raw.mmPerUnit) {
    factor = assumedDiagonalMm / diagonalOf(boundsOf(raw));
    if (noteUnit) {
      note(log, fmt::format("{} has no unit: scaled to a diagonal of {} mm "
                            "(LoadOptions::diagonalMm sets another)",
                            name, assumedDiagonalMm));
    }
  }
  scaleBy(raw, factor, name);
  raw.mmPerUnit = 1.0;
  std::size_t room = mostRigNumbers;
  for (RawObject& object : raw.objects) {
    // Rounding to float may have flattened a needle.
    if (lostArea(object.mesh)) {
      for (const Repair& repair : repairMesh(object.mesh, nameIn(name, object))) {
        addRepair(repairs, repair.what, repair.count);
      }
    }
    alignRig(object, nameIn(name, object), room);
    alignAttributes(object);
  }
  return raw;
}

void requireSensible(const LoadOptions& options) {
  if (const std::string complaint = options::complaintAboutFields(options); !complaint.empty()) {
    throw UsageError(complaint);
  }
  const auto require = [](const Medium& medium) {
    const std::string complaint = complaintAbout(medium);
    if (!complaint.empty()) {
      throw UsageError(fmt::format("medium '{}': {}", medium.name, complaint));
    }
  };
  if (options.medium) require(*options.medium);
  for (const MediumOfObject& of : options.media) require(of.medium);
}

void setMedia(const LoadOptions& options, Scene& scene) {
  std::vector<NotShown> hidden;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& opaque = scene.objects[i].opaque;
    const bool metal = opaque && isMetal(*opaque);
    if (options.medium && !metal) makeTranslucent(*options.medium, i, scene, hidden);
  }
  std::vector<std::string_view> names;
  for (const Object& object : scene.objects) names.emplace_back(object.name);
  for (const auto& [name, medium] : options.media) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError(fmt::format("there is no object '{}'{}", cleanText(name, 100),
                                   suggestionOrList(name, names)));
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (scene.objects[i].name == name) makeTranslucent(medium, i, scene, hidden);
    }
  }
  noteReplaced(hidden, options.log, scene.notShown);
}

Scene finished(RawScene raw, const std::filesystem::path& file, std::vector<Repair> repairs,
               const LoadOptions& options) {
  if (options.diagonalMm) {
    const std::string name = cleanText(file.string(), 1000);
    const double factor = double{*options.diagonalMm} / diagonalOf(boundsOf(raw));
    if (raw.hasMediaPerMetre && !options.medium && std::abs(factor - 1) > 0.01)
      note(options.log,
           fmt::format("{}: its media keep their mean free paths in mm at {:.3g} times "
                       "its size, so that it looks {} translucent",
                       name, factor, factor < 1 ? "more" : "less"));
    scaleBy(raw, factor, name);
  }
  if (const double diagonal = diagonalOf(boundsOf(raw));
      diagonal < shortestDiagonalMm || diagonal > longestDiagonalMm)
    throw Error(fmt::format(
        "{}: its diagonal is {:.3g} mm, but must be from {:.3g} to {:.3g} mm "
        "(LoadOptions::diagonalMm sets another)",
        cleanText(file.string(), 1000), diagonal, shortestDiagonalMm, longestDiagonalMm));
  Scene scene;
  scene.name = cleanText(file.stem().string());
  scene.repairs = std::move(repairs);
  for (RawObject& object : raw.objects) {
    scene.objects.push_back({.name = std::move(object.name),
                             .mesh = meshOf(object),
                             .medium = std::move(object.medium),
                             .paint = std::move(object.paint),
                             .surface = std::move(object.surface),
                             .rig = std::move(object.rig),
                             .opaque = std::move(object.opaque)});
  }
  scene.nodes = std::move(raw.nodes);
  scene.clips = std::move(raw.clips);
  scene.changes = std::move(raw.changes);
  scene.deformers = std::move(raw.deformers);
  scene.notShown = std::move(raw.notShown);
  setMedia(options, scene);
  if (const std::size_t count = removeDuplicateObjects(scene); count > 0)
    addRepair(scene.repairs, "duplicate objects", count);
  scene.lighting = raw.hasLights ? std::move(raw.lighting) : defaultLighting();
  scene.camera = raw.camera ? *raw.camera : defaultCamera(scene);
  scene.cameraChosen = raw.cameraChosen;
  return scene;
}

}  // namespace opaline::scene

#include "scene/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "opaline/error.h"
#include "scene/matrix.h"
#include "scene/mesh/normals.h"

namespace opaline::scene {

namespace {

using Origins = std::vector<Provenance>;

void gather(std::vector<Vec3>& values, const Origins& origins) {
  if (values.empty()) return;
  std::vector<Vec3> gathered;
  gathered.reserve(origins.size());
  for (const Provenance& of : origins) gathered.push_back(values[of.vertex]);
  values = std::move(gathered);
}

void gatherInfluences(Rig& rig, const Origins& origins) {
  if (rig.firstInfluence.empty()) return;
  std::vector<std::uint32_t> first{0};
  std::vector<Influence> influences;
  for (const Provenance& of : origins) {
    const auto begin = rig.influences.begin();
    influences.insert(influences.end(), begin + rig.firstInfluence[of.vertex],
                      begin + rig.firstInfluence[of.vertex + 1]);
    first.push_back(static_cast<std::uint32_t>(influences.size()));
  }
  rig.firstInfluence = std::move(first);
  rig.influences = std::move(influences);
}

/// Flat triangles of a mesh may name the file's few vertices over and over, and nodes may name the
/// mesh again.
void takeRoom(const Rig& rig, const Origins& origins, const std::string& name, std::size_t& room) {
  std::size_t vectors = origins.size() * (2 + 2 * rig.targets.size());
  if (!rig.firstInfluence.empty()) {
    for (const Provenance& of : origins) {
      vectors += rig.firstInfluence[of.vertex + 1] - rig.firstInfluence[of.vertex];
    }
  }
  if (vectors > room) {
    throw Error(fmt::format(
        "{}: with it the morph targets and influences of the file's vertices are more than {}",
        name, mostRigNumbers));
  }
  room -= vectors;
}

void requireFinite(const Rig& rig, const std::string& name) {
  const auto finite = [](const std::vector<Vec3>& values) {
    return std::all_of(values.begin(), values.end(), [](const Vec3& v) { return isFinite(v); });
  };
  bool all = finite(rig.positions);
  for (const MorphTarget& target : rig.targets) all = all && finite(target.positions);
  for (const Joint& joint : rig.joints) all = all && isFinite(joint.inverseBind);
  if (!all) {
    throw Error(
        fmt::format("{}: its morph targets or inverse bind matrices hold numbers that are "
                    "not finite",
                    name));
  }
}

Vec3 negated(const Vec3& v) {
  return {-v[0], -v[1], -v[2]};
}

/// Smooth normals in the file's space. The normals that the file does give tell which way is out,
/// since a mirrored mesh has had its triangles turned.
void smoothWhereMissing(Rig& rig, const RawMesh& mesh) {
  const auto missing = [&](std::size_t v) {
    return rig.normals[v] == Vec3{0, 0, 0} || mesh.provenance[v].normalSmooth;
  };
  std::vector<std::size_t> wanted;
  for (std::size_t v = 0; v < rig.normals.size(); ++v) {
    if (missing(v)) wanted.push_back(v);
  }
  if (wanted.empty()) return;
  std::vector<Double3> positions(rig.positions.size());
  std::transform(rig.positions.begin(), rig.positions.end(), positions.begin(),
                 [](const Vec3& p) { return toDouble(p); });
  const std::vector<Double3> smooth = smoothNormals(positions, mesh.triangles);
  double agreement = 0;
  for (std::size_t v = 0; v < smooth.size(); ++v) {
    if (!missing(v)) agreement += dot(smooth[v], toDouble(rig.normals[v]));
  }
  for (const std::size_t v : wanted) {
    rig.normals[v] = toFloat((agreement < 0 ? -1.0 : 1.0) * smooth[v]);
  }
}

/// Makes the node the only joint of vertices that follow it.
void nodeAsJoint(Rig& rig) {
  rig.joints = {{rig.node, {}}};
  rig.firstInfluence.resize(rig.positions.size() + 1);
  std::iota(rig.firstInfluence.begin(), rig.firstInfluence.end(), 0U);
  rig.influences.assign(rig.positions.size(), {0, 1});
}

bool sameJoints(const std::vector<Joint>& a, const std::vector<Joint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Joint& x, const Joint& y) {
    return x.node == y.node && x.inverseBind.columns == y.inverseBind.columns;
  });
}

template <typename T>
void extend(std::vector<T>& values, const std::vector<T>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

void startProvenance(RawMesh& mesh) {
  mesh.provenance.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.provenance.size(); ++v) {
    mesh.provenance[v] = {static_cast<std::uint32_t>(v)};
  }
}

void alignRig(RawObject& object, const std::string& name, std::size_t& room) {
  if (!object.rig) return;
  Rig& rig = *object.rig;
  const RawMesh& mesh = object.mesh;
  requireFinite(rig, name);
  takeRoom(rig, mesh.provenance, name, room);
  gather(rig.positions, mesh.provenance);
  gather(rig.normals, mesh.provenance);
  gatherInfluences(rig, mesh.provenance);
  for (MorphTarget& target : rig.targets) {
    gather(target.positions, mesh.provenance);
    gather(target.normals, mesh.provenance);
  }
  for (std::size_t v = 0; v < mesh.provenance.size(); ++v) {
    if (!mesh.provenance[v].normalTurned) continue;
    rig.normals[v] = negated(rig.normals[v]);
    for (MorphTarget& target : rig.targets) {
      if (!target.normals.empty()) target.normals[v] = negated(target.normals[v]);
    }
  }
  smoothWhereMissing(rig, mesh);
}

void appendRig(Rig& rig, Rig&& part) {
  if (rig.joints.empty() != part.joints.empty()) nodeAsJoint(rig.joints.empty() ? rig : part);
  if (!sameJoints(rig.joints, part.joints)) {
    const auto offset = static_cast<std::uint32_t>(rig.joints.size());
    for (Influence& influence : part.influences) influence.joint += offset;
    extend(rig.joints, part.joints);
  }
  if (!part.firstInfluence.empty()) {
    const std::uint32_t offset = rig.firstInfluence.back();
    for (std::size_t v = 1; v < part.firstInfluence.size(); ++v) {
      rig.firstInfluence.push_back(part.firstInfluence[v] + offset);
    }
  }
  extend(rig.influences, part.influences);
  for (std::size_t t = 0; t < rig.targets.size(); ++t) {
    // If one part lacks normals, all normals are taken from the triangles.
    const bool normals = !rig.targets[t].normals.empty() && !part.targets[t].normals.empty();
    extend(rig.targets[t].positions, part.targets[t].positions);
    extend(rig.targets[t].normals, part.targets[t].normals);
    if (!normals) rig.targets[t].normals.clear();
  }
  extend(rig.positions, part.positions);
  extend(rig.normals, part.normals);
}

}  // namespace opaline::scene

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "opaline/types.h"

namespace opaline {

/// An affine map as four columns: what becomes of x, y and z, and where the origin goes.
struct Affine {
  std::array<Vec3, 4> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
};

/// A rotation, x y z w, of unit length.
using Quaternion = std::array<float, 4>;

/// A frame of reference that joints and objects hang on. Scaled, then rotated, then translated, or
/// mapped by a matrix where the file gives one; then by the parent.
struct Node {
  std::string name;
  int parent = -1;  ///< index of an earlier node, or -1
  Vec3 translation{};
  Quaternion rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
  std::optional<Affine> matrix;     ///< instead of the three above; such a node is never animated
  std::vector<float> morphWeights;  ///< of the objects at this node, where no track says otherwise
};

/// glTF 2.0, appendix C.
enum class Interpolation { Step, Linear, CubicSpline };

/// What a track moves.
enum class TrackTarget { Translation, Rotation, Scale, MorphWeights };

/// Keys of one property of one node. Before the first and after the last key its value stands.
struct Track {
  std::uint32_t node = 0;
  TrackTarget target = TrackTarget::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<float> seconds;  ///< of the keys, ascending
  std::vector<float> values;   ///< for each key 3, 4 or as many as there are weights; for
                               ///< CubicSpline in-tangent, value and out-tangent, each as many
};

/// A named motion. A time beyond its end is taken modulo its length.
struct Clip {
  std::string name;
  float seconds = 0;  ///< of its last key
  std::vector<Track> tracks;
};

/// What a morph target adds at weight 1, one per vertex.
struct MorphTarget {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< empty where the file gives none
};

struct Joint {
  std::uint32_t node = 0;
  Affine inverseBind;
};

struct Influence {
  std::uint32_t joint = 0;  ///< index into Rig::joints
  float weight = 0;
};

/// How an object's vertices follow nodes:
/// x = toScene · Σ_j w_j world(j) · inverseBind_j · (position + Σ_t weight_t · target_t).
struct Rig {
  std::uint32_t node = 0;       ///< whose morph weights apply; moves the object if it has no joints
  std::vector<Vec3> positions;  ///< in the file's unit, one per vertex of the object's mesh
  std::vector<Vec3> normals;    ///< unit, one per vertex
  std::vector<MorphTarget> targets;
  std::vector<Joint> joints;
  std::vector<std::uint32_t> firstInfluence;  ///< one per vertex and one more; empty without joints
  std::vector<Influence> influences;          ///< weights of a vertex sum to 1
  Affine toScene;                             ///< from the nodes' common space to mm
};

/// A deformation of everything in a scene, about the vertical axis through the middle of the box
/// around its rest pose, of height H, bottom y₀ and diagonal D. With h = (y − y₀)/H:
enum class DeformerKind {
  Twist,   ///< turns by amount · (h − ½) about the axis; amount in radians
  Bend,    ///< bends the axis into an arc of that angle, towards +x; amount in radians
  Squash,  ///< height times 1 − amount, volume kept; below 0 it stretches
  Wobble,  ///< a wave that travels upwards: x += amount·D·s(h)·sin 2π(h − t/period), z += half of
           ///< that with cos, s(h) = h²(3 − 2h) clamped to [0,1], so that the foot stands still
};

struct Deformer {
  DeformerKind kind = DeformerKind::Twist;
  float amount = 0;  ///< Twist [-100, 100], Bend [-6.28, 6.28], Wobble [-1, 1], Squash [-3, 0.9]
                     ///< and [-0.9, 0.9] where it swings
  /// The amount swings as sin 2πt/period; 0: it stays, but for Wobble it is 1 s. Else [0.001, 1e6].
  float periodSeconds = 0;
};

}  // namespace opaline

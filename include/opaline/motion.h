#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "opaline/types.h"

namespace opaline {

/// An affine map as four columns: the images of the x, y and z axes, and of the origin.
struct Affine {
  std::array<Vec3, 4> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
};

/// A rotation, x y z w, of unit length.
using Quaternion = std::array<float, 4>;

/// A coordinate frame that joints and objects are attached to. Its transform is scale, then
/// rotation, then translation, or a matrix if the file gives one. The parent's transform is applied
/// after it.
struct Node {
  std::string name;
  int parent = -1;  ///< index of an earlier node, or -1
  Vec3 translation{};
  Quaternion rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
  std::optional<Affine> matrix;     ///< replaces the three above; such a node is never animated
  std::vector<float> morphWeights;  ///< of the objects at this node, unless a track animates them
};

/// glTF 2.0, appendix C.
enum class Interpolation { Step, Linear, CubicSpline };

/// The property that a track animates.
enum class TrackTarget { Translation, Rotation, Scale, MorphWeights };

/// Keys of one property of one node. Before the first and after the last key its value is constant.
struct Track {
  std::uint32_t node = 0;
  TrackTarget target = TrackTarget::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<float> seconds;  ///< of the keys, ascending
  std::vector<float> values;   ///< 3, 4 or the number of weights for each key; for CubicSpline an
                               ///< in-tangent, a value and an out-tangent of that length each
};

/// A named motion. A time beyond its end is taken modulo its length.
struct Clip {
  std::string name;
  float seconds = 0;  ///< of its last key
  std::vector<Track> tracks;
};

/// A moment of a scene's motion.
struct SceneTime {
  double seconds = 0;  ///< of clip and deformers, s, in [0, 1e6]
  int clip = 0;        ///< index of the clip that plays; -1: none, nodes as in the file

  bool operator==(const SceneTime&) const = default;
};

/// The offsets that a morph target adds at weight 1, one per vertex.
struct MorphTarget {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< empty: computed from the moved triangles
};

/// A node that moves a rig's vertices, and the map from their rest pose to its frame.
struct Joint {
  std::uint32_t node = 0;
  Affine inverseBind;
};

/// How much a joint moves a vertex.
struct Influence {
  std::uint32_t joint = 0;  ///< index into Rig::joints
  float weight = 0;
};

/// How an object's vertices follow nodes:
/// x = toScene · Σ_j w_j world(j) · inverseBind_j · (position + Σ_t weight_t · target_t).
struct Rig {
  std::uint32_t node = 0;       ///< has the morph weights; moves the object if there are no joints
  std::vector<Vec3> positions;  ///< in the file's unit, one per vertex of the object's mesh
  std::vector<Vec3> normals;    ///< unit, one per vertex
  std::vector<MorphTarget> targets;
  std::vector<Joint> joints;
  std::vector<std::uint32_t> firstInfluence;  ///< one per vertex and one more; empty without joints
  std::vector<Influence> influences;          ///< weights of a vertex sum to 1
  Affine toScene;                             ///< from the nodes' common space to mm
};

/// A deformation of a whole scene about the vertical axis through the middle of the box around its
/// rest pose. The box has height H, bottom y₀ and diagonal D; h = (y − y₀)/H.
enum class DeformerKind {
  Twist,   ///< rotates by amount · (h − ½) about the axis; amount in radians
  Bend,    ///< bends the axis into an arc of that angle, towards +x; amount in radians
  Squash,  ///< scales the height by 1 − amount and keeps the volume; a negative amount stretches
  Wobble,  ///< a wave that travels upwards: x += amount·D·s(h)·sin 2π(h − t/period), z += half of
           ///< that with cos, s(h) = h²(3 − 2h) clamped to [0,1]; the foot stands still
};

/// A deformation of the whole scene that comes and goes with time.
struct Deformer {
  DeformerKind kind = DeformerKind::Twist;
  float amount = 0;  ///< Twist [-100, 100], Bend [-6.28, 6.28], Wobble [-1, 1], Squash [-3, 0.9],
                     ///< or [-0.9, 0.9] with a period
  /// The amount swings as sin 2πt/period. 0: a constant amount, and for Wobble 1 s. Otherwise in
  /// [0.001, 1e6].
  float periodSeconds = 0;

  bool operator==(const Deformer&) const = default;
};

/// The largest number of deformers of a scene.
constexpr std::size_t maxDeformers = 8;

}  // namespace opaline

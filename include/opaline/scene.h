#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "opaline/export.h"
#include "opaline/image.h"
#include "opaline/log.h"
#include "opaline/material.h"
#include "opaline/medium.h"
#include "opaline/motion.h"
#include "opaline/types.h"

namespace opaline {

/// An indexed triangle mesh in scene space. Vertices that share a position but differ in normal are
/// separate vertices.
struct Mesh {
  std::vector<Vec3> positionsMm;
  std::vector<Vec3> normals;  ///< unit, one per position
  std::vector<Triangle> triangles;
  bool facetted = false;  ///< every triangle is flat: its vertices have its normal, also in motion
  /// The two sets that textures read. Each is empty or has one entry per position.
  std::array<std::vector<Vec2>, 2> textureCoordinates;
  std::vector<std::array<float, 4>> colors;  ///< linear RGBA; they multiply the base colour
};

/// One body of one material.
struct Object {
  std::string name;
  Mesh mesh;  ///< in the rest pose
  Medium medium;
  std::optional<Paint> paint;                 ///< if set, `medium` is what lies below it
  std::optional<TranslucentSurface> surface;  ///< of a translucent body; none: smooth, with the
                                              ///< mesh's normals
  std::optional<Rig> rig;                     ///< none: only the scene's deformers move it
  std::optional<OpaqueMaterial> opaque;  ///< if set, light does not enter and `medium` is not used
  bool isGround = false;  ///< stands still, casts no shadow of its own, and counts for no size
  std::vector<std::string> duplicates;  ///< names of objects that a loader left out because they
                                        ///< repeat this one
};

/// What an object is made of.
struct Material {
  Medium medium;
  std::optional<Paint> paint;
  std::optional<TranslucentSurface> surface;
  std::optional<OpaqueMaterial> opaque;

  bool operator==(const Material&) const = default;
};

/// What the object is made of.
OPALINE_API Material materialOf(const Object& object);
/// Gives the object this material; its mesh and motion stay.
OPALINE_API void giveMaterial(const Material& material, Object& object);

/// Light from infinitely far away.
struct DirectionalLight {
  Vec3 directionToLight{0, 0, 1};  ///< unit
  Rgb irradiance{1, 1, 1};         ///< on a surface that faces the light, in [0, 1e30]
  /// Of the disc that surfaces mirror, in [0, 10]; the sun's is 0.27. Shadows are cast from its
  /// centre.
  float angularRadiusDegrees = 0;

  bool operator==(const DirectionalLight&) const = default;
};

/// Light from one point; irradiance on a facing surface is intensity / distance² (distance in mm).
struct PointLight {
  Vec3 positionMm{};
  Rgb intensity{1, 1, 1};  ///< in [0, 1e30]

  bool operator==(const PointLight&) const = default;
};

/// A point light that shines into a cone. Between the inner and the outer angle it falls off as
/// glTF's KHR_lights_punctual prescribes.
struct SpotLight {
  Vec3 positionMm{};
  Vec3 direction{0, 0, -1};  ///< unit, away from the light
  Rgb intensity{1, 1, 1};    ///< along the axis, in [0, 1e30]
  float innerDegrees = 0;    ///< from the axis, in [0, outerDegrees]; full intensity within it
  float outerDegrees = 45;   ///< from the axis, in (0, 90]; dark beyond it

  bool operator==(const SpotLight&) const = default;
};

/// How many shadow maps the light takes: 1 if its outer angle is at most 50 degrees, else 6.
OPALINE_API std::size_t shadowMapsOf(const SpotLight& light);

/// A rectangle, or any parallelogram, that shines evenly to the side of u × v.
struct RectangleLight {
  Vec3 centreMm{};
  Vec3 uMm{10, 0, 0};     ///< half an edge
  Vec3 vMm{0, 10, 0};     ///< half of the other
  Rgb radiance{1, 1, 1};  ///< in [0, 1e30]
  bool twoSided = false;  ///< to the other side too
  bool visible = false;   ///< shown in the picture itself, not only in reflections

  bool operator==(const RectangleLight&) const = default;
};

/// A disc that shines evenly to the side of its normal.
struct DiscLight {
  Vec3 centreMm{};
  Vec3 normal{0, 0, 1};   ///< unit
  float radiusMm = 10;    ///< in (0, 1e6]
  Rgb radiance{1, 1, 1};  ///< in [0, 1e30]
  bool twoSided = false;  ///< to the other side too
  bool visible = false;   ///< shown in the picture itself, not only in reflections

  bool operator==(const DiscLight&) const = default;
};

/// A sphere that shines evenly outwards.
struct SphereLight {
  Vec3 centreMm{};
  float radiusMm = 10;    ///< in (0, 1e6]
  Rgb radiance{1, 1, 1};  ///< in [0, 1e30]
  bool visible = false;   ///< shown in the picture itself, not only in reflections

  bool operator==(const SphereLight&) const = default;
};

/// A cylinder that shines evenly outwards, and not from its ends.
struct TubeLight {
  Vec3 fromMm{};
  Vec3 toMm{0, 100, 0};
  float radiusMm = 5;     ///< in (0, 1e6]
  Rgb radiance{1, 1, 1};  ///< in [0, 1e30]
  bool visible = false;   ///< shown in the picture itself, not only in reflections

  bool operator==(const TubeLight&) const = default;
};

/// A light with an extent. Its shadows are soft, and surfaces mirror its shape. A visible one is
/// seen only from the side it shines to, and casts no shadow.
using AreaLight = std::variant<RectangleLight, DiscLight, SphereLight, TubeLight>;

/// Everything that shines.
struct Lighting {
  /// Limit for lights of all kinds together.
  static constexpr std::size_t maxLights = 16;
  /// Limit for shadow maps: a directional light takes 1, a point light 6, a spot light 1 or 6 and
  /// an area light none.
  static constexpr std::size_t maxShadowMaps = 48;

  std::vector<DirectionalLight> directional;
  std::vector<PointLight> points;
  std::vector<SpotLight> spots;
  std::vector<AreaLight> areas;  ///< not for Sum::Pattern
  Rgb ambient{};                 ///< radiance, the same from all directions, in [0, 1e30]
  /// Radiance, latitude-longitude; the top row is +y, the centre column −z, and u grows towards +x.
  /// Null: no environment. Copies share the picture, and it never changes: another picture is
  /// another object. Up to four suns in it cast shadows; they count towards neither limit above.
  std::shared_ptr<const Image> environment;

  bool operator==(const Lighting&) const = default;
};

/// A pinhole camera, or an orthographic one.
struct Camera {
  Vec3 positionMm{};
  Vec3 targetMm{};
  Vec3 up{0, 1, 0};
  float verticalFovDegrees = 30;  ///< in [1, 170]
  /// Shifts the visible window without turning the camera, as the lens of a view camera does: to
  /// the right in picture widths, up in picture heights, each in [-1000, 1000].
  float shiftX = 0;
  float shiftY = 0;
  /// If set, lines of sight are parallel and this is the picture's height, mm, in (0, 1e6]; the
  /// field of view is not used.
  std::optional<float> orthographicHeightMm;

  bool operator==(const Camera&) const = default;
};

/// Why an environment cannot be rendered, as a sentence; empty if it can. It looks at every value,
/// whereas complaintAbout(Lighting) only counts those of its environment.
OPALINE_API std::string complaintAboutEnvironment(const Image& environment);

/// Why the lights, or the camera, cannot be rendered, as a sentence; empty if they can.
OPALINE_API std::string complaintAbout(const DirectionalLight& light);
OPALINE_API std::string complaintAbout(const PointLight& light);
OPALINE_API std::string complaintAbout(const SpotLight& light);
OPALINE_API std::string complaintAbout(const RectangleLight& light);
OPALINE_API std::string complaintAbout(const DiscLight& light);
OPALINE_API std::string complaintAbout(const SphereLight& light);
OPALINE_API std::string complaintAbout(const TubeLight& light);
OPALINE_API std::string complaintAbout(const AreaLight& light);
OPALINE_API std::string complaintAbout(const Lighting& lighting);
OPALINE_API std::string complaintAbout(const Camera& camera);

/// The keys of one thing in a clip. Between keys its numbers are interpolated linearly; before the
/// first and after the last key they are constant.
template <typename T>
struct Keys {
  std::uint32_t index = 0;     ///< of the thing among the scene's things of its kind
  std::vector<float> seconds;  ///< ascending
  std::vector<T> values;       ///< one per key
};

/// What a clip changes besides nodes. A list holds each thing at most once.
struct ClipChanges {
  std::vector<Keys<DirectionalLight>> directional;
  std::vector<Keys<PointLight>> points;
  std::vector<Keys<SpotLight>> spots;
  std::vector<Keys<Camera>> cameras;  ///< of the scene's only camera
  /// Of opaque objects. Names, pictures of textures and `unlit` stay as the object has them.
  std::vector<Keys<OpaqueMaterial>> surfaces;
  /// Of translucent objects without paint. The index of refraction stays.
  std::vector<Keys<Medium>> media;
};

/// A kind of repair by a loader, and how often it was made.
struct Repair {
  std::string what;
  std::size_t count = 0;
};

/// A kind of thing in the scene's file that Opaline does not show.
struct NotShown {
  std::string what;  ///< in the plural
  std::size_t count = 0;
  std::vector<std::string> names;  ///< names of some of them
};

/// As one line: "base-colour textures (2: skin, hair), vertex colours (1: body)".
OPALINE_API std::string textOf(const std::vector<NotShown>& kinds);

/// A scene, as plain data.
struct Scene {
  std::string name;
  std::vector<Object> objects;
  Lighting lighting;
  Camera camera;
  /// Whether the place or field of view of the camera was chosen. Otherwise it is defaultCamera().
  /// The library renders it as it is. The program moves a camera that was not chosen back until the
  /// scene fits into the picture at every time that is rendered.
  bool cameraChosen = false;
  std::vector<Node> nodes;  ///< parents before children
  std::vector<Clip> clips;
  std::vector<ClipChanges> changes;  ///< one per clip, in their order; the last clips may have none
  std::vector<Deformer> deformers;   ///< applied in this order, after the rigs
  std::vector<Repair> repairs;
  std::vector<NotShown> notShown;
};

/// An axis-aligned box.
struct Bounds {
  Vec3 minMm{};
  Vec3 maxMm{};
};

/// The smallest box around all vertices of all objects except grounds; zero without vertices.
OPALINE_API Bounds boundsOf(const Scene& scene);

/// The middle of a box, mm.
OPALINE_API Vec3 middleOf(const Bounds& bounds);

/// Length of the diagonal of boundsOf(scene), mm.
OPALINE_API float diagonalMm(const Scene& scene);

/// What one object is to be made of.
struct MediumOfObject {
  std::string object;  ///< its name
  Medium medium;
};

/// How a file becomes a scene.
struct LoadOptions {
  std::optional<float> diagonalMm;  ///< scale the bounding-box diagonal to this length, mm, > 0
  std::optional<Medium> medium;     ///< of every object that is not a metal, whatever the file says
  std::vector<MediumOfObject> media;     ///< of single objects; overrides all else
  std::optional<ColorModel> colorModel;  ///< for media that a file gives as colours; none: what a
                                         ///< .toml scene says, else ColorModel::Observed
  /// A model of the same topology that the scene's only object turns into and back, in a clip
  /// "morph" of 4 s; not for built-in scenes.
  std::optional<std::filesystem::path> morphTo;
  LogCallback log;  ///< receives notes, for example about an assumed unit
};

/// Reads a .glb, .gltf, .obj, .ply or .toml scene, repairs its meshes and adds a default camera and
/// lights if the file has none. Throws Error when the file cannot be read or is invalid.
OPALINE_API Scene loadScene(const std::filesystem::path& file, const LoadOptions& options = {});

/// The built-in scene: a gummy bear, closed and smooth, about 50,000 triangles, 50 mm diagonal.
OPALINE_API Scene builtInBear(const LoadOptions& options = {});

/// The Utah teapot (Newell 1975) from its Bézier patches: 2256 triangles, 1177 vertices.
OPALINE_API Scene builtInTeapot(const LoadOptions& options = {});

/// An opaque horizontal plane under the scene, a thousand diagonals wide. It receives light and
/// shadows and reflects light. It hides lights below it.
struct Ground {
  Rgb color{0.5F, 0.5F, 0.5F};    ///< share of light that it reflects, in [0, 1]
  std::optional<float> heightMm;  ///< y; none: the lowest point at rest

  bool operator==(const Ground&) const = default;
};

/// Why the ground cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const Ground& ground);

/// The ground as an object. Add it to the scene's objects to make it part of the scene.
OPALINE_API Object groundUnder(const Scene& scene, const Ground& ground = {});

/// The scene's ground; null if it has none.
OPALINE_API const Object* groundOf(const Scene& scene);

/// Removes the ground, if there is one.
OPALINE_API void removeGround(Scene& scene);

/// The default camera: in the given direction from the centre of the box (default +z), looking at
/// the centre, 1.4 diagonals away. It ignores the picture's aspect ratio and the scene's motion, so
/// parts of the scene may be cut off. From 0.5 / sin(half the field of view) diagonals away, 1.93
/// for 30 degrees, a picture at least as wide as high shows all of a scene at rest.
OPALINE_API Camera defaultCamera(const Scene& scene, Vec3 directionFromCentre = {0, 0, 1},
                                 float verticalFovDegrees = 30);

/// Adapts lights, camera and their keys in clips to objects that were scaled by `factor`. The
/// picture then stays the same, except for light transport inside bodies. Throws UsageError for a
/// factor that is not above 0 or takes something out of the range of a float; the scene then stays
/// as it is.
OPALINE_API void scaleLightsAndCamera(double factor, Scene& scene);

/// Removes the keys of all lights, or of the camera, from every clip, so that new ones stay as they
/// are set.
OPALINE_API void stopLights(Scene& scene);
OPALINE_API void stopCamera(Scene& scene);

/// The default lights: a key light from behind at the side, a weak fill and weak ambient light.
OPALINE_API Lighting defaultLighting();

}  // namespace opaline

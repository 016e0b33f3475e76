#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/environment.h"
#include "opaline/export.h"
#include "opaline/file.h"
#include "opaline/options/picture.h"
#include "opaline/options/scene.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "opaline/types.h"

namespace opaline {

/// Where an object stands, seen from its model: a matrix, or else scaled, turned about x, then y,
/// then z, all fixed axes, and moved.
struct Placement {
  std::optional<std::array<double, 16>> rows;  ///< affine, row by row, lengths in mm
  Vec3 translationMm{};
  Vec3 rotationDegrees{};
  double scale = 1;
};

/// A model and what is done to it before it meets the others.
struct ModelSource {
  std::filesystem::path file;        ///< or builtin:bear, builtin:teapot
  std::optional<double> diagonalMm;  ///< that it is scaled to; none: the file's unit
  std::optional<std::filesystem::path> morphTo;
  std::optional<Placement> placement;  ///< of all of it, its lights and camera too

  /// Whether it names a model that the library carries.
  bool isBuiltIn() const { return file.string().starts_with("builtin:"); }
};

/// What a scene file says of a material.
struct MaterialSource {
  bool isOpaque = false;
  std::optional<std::string> medium;  ///< of a translucent one its name, else its appearance
  options::Chosen<Appearance> appearance;
  options::Chosen<TranslucentSurface> surface;  ///< of a translucent one
  options::Chosen<OpaqueMaterial> opaque;
  std::map<std::string, std::filesystem::path> textures;  ///< by key
  Medium became;  ///< the medium of a translucent one, by all of this
};

/// What a scene file says of an object's own material, whatever that is: other numbers.
struct MaterialNumbers {
  options::Chosen<OpaqueMaterial> opaque;       ///< of an opaque one
  options::Chosen<TranslucentSurface> surface;  ///< of a translucent one

  bool operator==(const MaterialNumbers&) const = default;
};

/// The files a scene was made of and what was done to them. Paths are absolute.
struct SceneSource {
  std::optional<std::filesystem::path> sceneFile;  ///< the .toml that says all of this
  std::vector<ModelSource> models;                 ///< at least one
  std::map<std::string, Placement> placements;  ///< by the object's name; others stand as they are
  std::map<std::string, MaterialSource> materials;
  std::map<std::string, std::string> materialOfObject;  ///< by the object's name, where one is said
  std::map<std::string, MaterialNumbers> numbersOfObject;  ///< by the object's name
  std::optional<EnvironmentFile> environment;
  std::optional<ColorModel> colorModel;  ///< as in LoadOptions
};

/// What a .toml scene says beyond the scene itself: its [render] table.
struct SceneFileSettings {
  options::Chosen<options::PictureSettings> picture;
  options::NamedSettings named;

  bool operator==(const SceneFileSettings&) const = default;
};

/// A scene as a file has it, and what the file says beside.
struct LoadedScene {
  Scene scene;
  SceneFileSettings settings;
  SceneSource source;
  /// Where the model is one; `scene` is its first mesh.
  std::shared_ptr<const MeshSequence> sequence;
};

/// Reads a .toml scene: loadScene() without losing the settings and where all of it came from. For
/// any other file the settings are empty.
OPALINE_API LoadedScene loadSceneFile(const std::filesystem::path& file,
                                      const LoadOptions& options = {});

/// The same of several models in one scene, each as its file has it; a diagonal is that of all
/// together. Throws UsageError for what can only stand alone: a .toml scene, numbered meshes, a
/// morph.
OPALINE_API LoadedScene loadSceneFiles(const std::vector<std::filesystem::path>& files,
                                       const LoadOptions& options = {});

/// Of a scene that is loaded from a model's file with these options, or is built in.
OPALINE_API SceneSource sourceOf(const std::filesystem::path& model, const LoadOptions& options);

/// Every file that a scene was made of, and those that its model names, textures among them,
/// whether or not they are read: what must not be written over. Of numbered meshes none.
OPALINE_API std::vector<std::filesystem::path> filesOf(const SceneSource& source);

/// The colour of the scene's ground and its y; none without one.
OPALINE_API std::optional<Ground> describeGround(const Scene& scene);

/// Everything that a .toml scene can say.
struct SceneDescription {
  /// What an object is made of.
  struct ObjectMedium {
    std::string object;
    Medium medium;
    bool isPainted = false;  ///< with what the object's own material has as colours
  };

  SceneSource source;
  /// The middle of the box around all objects in the rest pose, mm: what the file counts places
  /// from.
  Vec3 centreMm{};
  /// Of every translucent object that is not all that its material in the file is.
  std::vector<ObjectMedium> media;
  bool mediaOfAll = true;  ///< there are no others
  std::vector<DirectionalLight> directional;
  std::vector<PointLight> points;
  std::vector<SpotLight> spots;
  std::vector<AreaLight> areas;
  Rgb ambient{};
  Camera camera;
  std::optional<Ground> ground;  ///< its height from the centre
  std::vector<Deformer> deformers;
  SceneFileSettings settings;
};

/// A scene that was loaded from `source`, whatever became of its media, lights, camera and
/// deformers since. Throws Error for an environment without a file.
OPALINE_API SceneDescription describe(const Scene& scene, SceneSource source,
                                      SceneFileSettings settings);

/// Writes a .toml scene that loads as what is described: every number comes back bit by bit, but
/// for places that are nearer than 1e-8 of the way to the centre to the origin of the coordinates.
/// Paths are relative to its folder but where only the root of the file system is common. Throws
/// UsageError for a name that does not end in .toml, and Error for what no scene file can say, as
/// two objects of one name and different media, or when it cannot be written. Returns
/// where it is.
OPALINE_API std::filesystem::path writeScene(const Target& target,
                                             const SceneDescription& description);

}  // namespace opaline

#pragma once

#include <array>
#include <filesystem>
#include <functional>
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

/// The place of an object relative to its model: a matrix, or else a scale, rotations about the
/// fixed axes x, y and z in this order, and a translation.
struct Placement {
  std::optional<std::array<double, 16>> rows;  ///< affine, row by row, lengths in mm
  Vec3 translationMm{};
  Vec3 rotationDegrees{};
  double scale = 1;
};

/// A model and how it is changed before it joins the others.
struct ModelSource {
  std::filesystem::path file;        ///< or builtin:bear or builtin:teapot
  std::optional<double> diagonalMm;  ///< length its diagonal is scaled to, mm; none: the file's
                                     ///< unit counts
  std::optional<std::filesystem::path> morphTo;
  std::optional<Placement> placement;  ///< of the whole model with its lights and camera

  /// Whether it names a model that the library carries.
  bool isBuiltIn() const { return file.string().starts_with("builtin:"); }
};

/// What a scene file says of a material.
struct MaterialSource {
  bool isOpaque = false;
  std::optional<std::string> medium;  ///< name of a translucent one's medium; none: given by
                                      ///< `appearance`
  options::Chosen<Appearance> appearance;
  options::Chosen<TranslucentSurface> surface;  ///< of a translucent one
  options::Chosen<OpaqueMaterial> opaque;
  std::map<std::string, std::filesystem::path> textures;  ///< by key
  Medium became;  ///< the medium that all of this gives a translucent one
};

/// Numbers by which a scene file changes an object's own material, whatever that is.
struct MaterialNumbers {
  options::Chosen<OpaqueMaterial> opaque;       ///< of an opaque one
  options::Chosen<TranslucentSurface> surface;  ///< of a translucent one

  bool operator==(const MaterialNumbers&) const = default;
};

/// The files a scene was made of and what was done to them. Paths are absolute.
struct SceneSource {
  std::optional<std::filesystem::path> sceneFile;  ///< the .toml that says all of this
  std::vector<ModelSource> models;                 ///< at least one
  std::map<std::string, Placement> placements;     ///< by the object's name; other objects stay in
                                                   ///< place
  std::map<std::string, MaterialSource> materials;
  std::map<std::string, std::string> materialOfObject;  ///< name of a material by the name of its
                                                        ///< object
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

/// A scene from a file, and what else the file says.
struct LoadedScene {
  Scene scene;
  SceneFileSettings settings;
  SceneSource source;
  /// If the model is a sequence of meshes, the sequence; `scene` is then its first mesh.
  std::shared_ptr<const MeshSequence> sequence;
};

/// Reads a .toml scene like loadScene(), and keeps its settings and the origin of its parts. For
/// any other file the settings are empty.
OPALINE_API LoadedScene loadSceneFile(const std::filesystem::path& file,
                                      const LoadOptions& options = {});

/// The same for several models in one scene, each as its file has it. LoadOptions::diagonalMm is
/// the diagonal of all together. Throws UsageError for what cannot be combined: a .toml scene,
/// numbered meshes, a morph.
OPALINE_API LoadedScene loadSceneFiles(const std::vector<std::filesystem::path>& files,
                                       const LoadOptions& options = {});

/// The media under [media] in a .toml scene, by name; none for any other file. Throws Error like
/// loadSceneFile().
OPALINE_API std::map<std::string, Medium, std::less<>> mediaOf(const std::filesystem::path& file);

/// The source of a scene that is loaded from a model's file with these options, or is built in.
OPALINE_API SceneSource sourceOf(const std::filesystem::path& model, const LoadOptions& options);

/// The files that must not be overwritten: every file that a scene was made of, and every file that
/// its model names, such as textures, whether or not they were read. Excludes numbered meshes.
OPALINE_API std::vector<std::filesystem::path> filesOf(const SceneSource& source);

/// The colour and height of the scene's ground; none if it has no ground.
OPALINE_API std::optional<Ground> describeGround(const Scene& scene);

/// Everything that a .toml scene can say.
struct SceneDescription {
  /// What an object is made of.
  struct ObjectMedium {
    std::string object;
    Medium medium;
    bool isPainted = false;  ///< in the colours of the object's own material
  };

  SceneSource source;
  /// The middle of the box around all objects in the rest pose, mm. Places in the file are relative
  /// to it.
  Vec3 centreMm{};
  /// One for every translucent object that differs from its material in the file.
  std::vector<ObjectMedium> media;
  bool mediaOfAll = true;  ///< no object is opaque or painted, or has a material of the file
  std::vector<DirectionalLight> directional;
  std::vector<PointLight> points;
  std::vector<SpotLight> spots;
  std::vector<AreaLight> areas;
  Rgb ambient{};
  Camera camera;
  bool lightsOfModel = false;    ///< the file has no lights, so that clips move those of the model
  bool cameraOfModel = false;    ///< likewise
  std::optional<Ground> ground;  ///< its height is relative to `centreMm`
  std::vector<Deformer> deformers;
  SceneFileSettings settings;
};

/// Describes a scene that was loaded from `source`; its media, lights, camera and deformers may
/// have changed since. Throws Error for an environment that has no file.
OPALINE_API SceneDescription describe(const Scene& scene, SceneSource source,
                                      SceneFileSettings settings);

/// Writes a .toml scene that loads as what is described: every number comes back bit by bit, but
/// for places that are nearer than 1e-8 of the way to the centre to the origin of the coordinates.
/// Options that nothing reads beside the others are left out.
/// Paths are relative to its folder but where only the root of the file system is common. Throws
/// UsageError for a name that does not end in .toml, and Error for what no scene file can say, as
/// two objects of one name and different media, or when it cannot be written. Returns
/// where it is.
OPALINE_API std::filesystem::path writeScene(const Target& target,
                                             const SceneDescription& description);

}  // namespace opaline

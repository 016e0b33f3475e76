#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/motion_options.h"
#include "cli/scene_options.h"
#include "lab/truth_job.h"
#include "opaline/positions.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "opaline/sequence.h"
#include "opaline/tone.h"
#include "viewer/files/file_question.h"
#include "viewer/picture/variable_display.h"

namespace opaline::app::viewer {

/// What an edit affects, so that nothing else is redone.
struct Edits {
  bool camera = false;
  bool lighting = false;
  bool deformers = false;
  bool ground = false;         ///< another ground, or none
  bool picture = false;        ///< options, time: what needs a new picture and nothing else
  std::vector<bool> material;  ///< by object

  bool any() const {
    for (const bool edited : material) {
      if (edited) return true;
    }
    return camera || lighting || deformers || ground || picture;
  }
};

/// What the picture area shows.
enum class Shown { Picture, Truth, HeatMap };

/// What to write.
enum class Save { Nothing, Picture, Exr, Scene, Film, NoFilm };

/// How the animation runs.
struct Playback {
  bool playing = false;
  bool loop = true;
  bool turntable = false;
  float speed = 1;
  double beginSeconds = 0;  ///< where it starts
  double endSeconds = 4;    ///< where it starts again
};

/// What a film shows.
struct FilmSettings {
  double perSecond = 30;
  bool once = true;  ///< the motion once; else from the first frame to the last
  int first = 0;
  int last = 119;

  bool operator==(const FilmSettings&) const = default;
};

/// The form in which to write the truth.
enum class TruthFile { Png, Exr, HeatMap };

/// Everything that can be changed in the window, as plain data. Panels change it and note what they
/// did in `edits`. Nothing here draws or renders.
struct Session {
  SceneOptions asked;  ///< what the user asked to open
  std::string name;
  Scene scene;
  SceneSource source;                            ///< the files it was made of
  std::shared_ptr<const MeshSequence> sequence;  ///< of numbered files, if its model is one
  PositionsByObject positionsMm;                 ///< where the sequence has the body now
  std::shared_ptr<const Image> environment;      ///< as in the source's file, not turned
  std::vector<DirectionalLight> suns;            ///< of the environment as it is shown
  float diagonalMm = 0;                          ///< as loaded
  Vec3 centreMm{};                               ///< as loaded: of the box around all objects
  Lighting lightsAsLoaded;                       ///< without the environment
  std::optional<float> wantedDiagonalMm;         ///< another size, to be loaded
  std::optional<float> draggedDiagonalMm;        ///< another size, while its slider is dragged
  std::vector<std::string> notes;                ///< from loading
  std::vector<std::string> renderNotes;          ///< from rendering

  RenderOptions options;
  SceneTime time;
  ToneOptions tone;
  bool exposesByLight = true;  ///< nobody has said how to expose
  Playback playback;
  FilmSettings film;
  std::optional<std::array<int, 2>> pictureSize;  ///< of saved pictures; none: as in the window
  bool quickWhileMoving = true;  ///< coarser light where the transport is too slow for motion
  bool divided = false;          ///< the paper's method on the left of the divider
  float divider = 0.5F;          ///< in [0, 1]
  Aov aov = Aov::Radiance;
  SurfelIndex surfelIndex = SurfelIndex::Surfel;  ///< which index of Aov::Surfels is shown
  int treeLevel = 4;                              ///< of the nodes
  Shown shown = Shown::Picture;
  std::optional<TruthOrder::Method> wantedTruth;
  bool cancelTruth = false;
  int wantedSteps = 0;                ///< steps through the list of edits: negative is back
  std::optional<FileUse> wantedFile;  ///< a file that the user must choose
  std::optional<TruthFile> wantedTruthFile;
  Save wanted = Save::Nothing;
  std::optional<FileAnswer> saveTo;  ///< for `wanted`; none: a free name after saveName
  std::string saveName;              ///< without its extension
  Save savedByKey = Save::Picture;   ///< a picture or its light
  bool poke = false;                 ///< the mouse pulls bodies instead of turning the camera
  bool scaleBar = true;
  bool gizmos = true;

  std::string refused;  ///< why the last key did nothing

  std::optional<RenderReport> report;  ///< of the last picture

  std::size_t object = 0;  ///< the one whose medium and material are edited
  int light = -1;          ///< the selected one, in the order of viewer/session/light_list.h
  Edits edits;
};

/// Whether the scene is shown as its camera sees it now, and not the truth of an earlier moment or
/// a map.
bool showsScene(const Session& session);

/// Notes diagonal, centre and lights of a scene that was loaded for the session.
void measure(const Scene& loaded, Session& session);

/// A place as scene files, the command line and the panels give it: relative to the middle of the
/// box around all objects at rest.
Vec3 placeInFile(const Vec3& placeMm, const Session& session);
/// The place in the scene's own coordinates.
Vec3 placeInScene(const Vec3& placeInFileMm, const Session& session);

/// Replaces the ground of the session's scene, or removes it.
void setGround(const std::optional<Ground>& ground, Session& session);

/// Sets the exposure by the scene's light, unless somebody chose one.
void exposeByLight(Session& session);

/// The same options for that many pixels.
RenderOptions sized(const RenderOptions& options, int width, int height);

/// The same transport, computed more coarsely, for use while light, medium or body move.
RenderOptions coarser(const RenderOptions& options);
/// The same on a coarser division of the surface than that into so many surfels.
RenderOptions coarselyDivided(const RenderOptions& options, std::size_t surfels);

/// Renders a variable of the session's scene once, as its renderer has it.
Image pictureOf(const Session& session, Renderer& renderer, const RenderOptions& options,
                Aov variable);

/// The method of Gong et al. 2008 for the same picture.
RenderOptions paperOptions(const RenderOptions& options);

/// Why the pattern of 2008 cannot light this scene, in the window's words; empty where nothing is
/// known that speaks against it.
std::string complaintAboutPattern(const Scene& scene);

/// The seconds until numbered files, clips and swinging deformers repeat, or a default.
float lengthOfMotion(const Session& session);

/// Whether the picture depends on the time.
bool movesInTime(const Session& session);
/// The message where it does not.
inline constexpr const char* nothingMoves =
    "Nothing here moves by itself: Motion adds a deformation, and an animated model brings a clip.";

/// The message where the camera cannot be moved.
inline constexpr const char* mapHasNoCamera =
    "The camera does not see the map: another variable in View shows how it moves.";

/// The frames of the session's film.
FrameRange filmFrames(const Session& session);

/// Makes the animation play what the film shows.
void fitPlayback(Session& session);

}  // namespace opaline::app::viewer

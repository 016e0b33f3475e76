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

/// What an edit concerns, so that nothing else is done again.
struct Edits {
  bool camera = false;
  bool lighting = false;
  bool deformers = false;
  bool ground = false;         ///< there is another, or none
  bool picture = false;        ///< options, time: whatever needs a new picture and nothing else
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

/// What is to be written.
enum class Save { Nothing, Picture, Exr, Scene, Film, NoFilm };

/// How the animation runs.
struct Playback {
  bool playing = false;
  bool loop = true;
  bool turntable = false;
  float speed = 1;
  float lengthSeconds = 4;  ///< after which it begins anew
};

/// What a film shows.
struct FilmSettings {
  int perSecond = 30;
  bool once = true;  ///< the motion once; else from the first frame to the last
  int first = 0;
  int last = 119;

  bool operator==(const FilmSettings&) const = default;
};

/// What the truth is to be written as.
enum class TruthFile { Png, Exr, HeatMap };

/// Everything that can be changed in the window, as plain data. Panels change it and note what they
/// did in `edits`; nothing here draws or renders.
struct Session {
  SceneOptions asked;  ///< what was asked to be opened
  std::string name;
  Scene scene;
  SceneSource source;                            ///< the files that it was made of
  std::shared_ptr<const MeshSequence> sequence;  ///< of numbered files, where its model is one
  PositionsByObject positionsMm;                 ///< where these have the body now
  std::shared_ptr<const Image> environment;      ///< as the source's file has it, not turned
  std::vector<DirectionalLight> suns;            ///< of the environment as it is shown
  float diagonalMm = 0;                          ///< as loaded
  std::optional<float> wantedDiagonalMm;         ///< another, to be loaded
  std::optional<float> draggedDiagonalMm;        ///< another, while its slider is being dragged
  std::vector<std::string> notes;                ///< of loading

  RenderOptions options;
  SceneTime time;
  ToneOptions tone;
  bool exposesByLight = true;  ///< nobody has said how to expose
  Playback playback;
  FilmSettings film;
  std::optional<std::array<int, 2>> pictureSize;  ///< of what is saved; none: as in the window
  bool quickWhileMoving = true;  ///< coarser light where the transport is too slow to move with
  bool divided = false;          ///< the paper's method on the left of the divider
  float divider = 0.5F;          ///< in [0, 1]
  Aov aov = Aov::Radiance;
  SurfelIndex surfelIndex = SurfelIndex::Surfel;  ///< of Aov::Surfels, what is shown
  int treeLevel = 4;                              ///< of the nodes
  Shown shown = Shown::Picture;
  std::optional<TruthOrder::Method> wantedTruth;
  bool cancelTruth = false;
  int wantedSteps = 0;                ///< through the list of edits: back below 0, on above
  std::optional<FileUse> wantedFile;  ///< for which the user is to choose one
  std::optional<TruthFile> wantedTruthFile;
  Save wanted = Save::Nothing;
  std::optional<FileAnswer> saveTo;  ///< what is wanted; none: under a free name after saveName
  std::string saveName;              ///< without its ending
  bool poke = false;                 ///< the mouse pulls at bodies instead of turning the camera
  bool scaleBar = true;
  bool gizmos = true;

  std::string refused;  ///< why the last key did nothing, to be said

  std::optional<RenderReport> report;  ///< of the last picture

  std::size_t object = 0;  ///< whose medium and material are edited
  int light = -1;          ///< that is selected, in the order of viewer/session/light_list.h
  Edits edits;
};

/// Whether the scene is shown as its camera sees it now: not the truth of an earlier moment, no
/// map.
bool showsScene(const Session& session);

/// Puts another ground under the session's scene, or none.
void setGround(const std::optional<Ground>& ground, Session& session);

/// Lets the exposure follow the scene's light, where nobody has said how to expose.
void exposeByLight(Session& session);

/// The same picture of that many pixels.
RenderOptions sized(const RenderOptions& options, int width, int height);

/// The same transport, found more coarsely: what is shown while light, medium or body move.
RenderOptions coarser(const RenderOptions& options);
/// And on a surface that is divided more coarsely than into so many surfels.
RenderOptions coarselyDivided(const RenderOptions& options, std::size_t surfels);

/// Renders the session's scene once, as its renderer has it.
Image pictureOf(const Session& session, Renderer& renderer, const RenderOptions& options);

/// The method of Gong et al. 2008 for the same picture.
RenderOptions paperOptions(const RenderOptions& options);

/// Seconds after which numbered files, clips and swinging deformers have come round, or a few.
float lengthOfMotion(const Session& session);

/// Whether a picture of it depends on the time.
bool movesInTime(const Session& session);
/// What to say where it does not.
inline constexpr const char* nothingMoves =
    "Nothing here moves by itself: Motion adds a deformation, and an animated model brings a clip.";

/// Those of its film.
FrameRange filmFrames(const Session& session);

}  // namespace opaline::app::viewer

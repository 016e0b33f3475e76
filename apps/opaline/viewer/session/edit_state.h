#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Everything of a session that edits change, but not how the scene is viewed: neither the camera's
/// place nor the time.
struct EditState {
  std::vector<Material> materials;                 ///< by object
  std::map<std::string, MaterialNumbers> numbers;  ///< as in SceneSource
  Lighting lighting;                               ///< without the environment
  std::optional<EnvironmentFile> environmentFile;
  std::shared_ptr<const Image> environment;  ///< as in the file, not turned
  std::optional<Ground> ground;
  std::vector<Deformer> deformers;
  RenderOptions options;
  int clip = 0;
  ToneOptions tone;
  bool exposesByLight = true;  ///< the tone's exposure is then ignored
  float fovDegrees = 0;
  std::optional<float> diagonalMm;  ///< as asked for; none: as in the file
  float speed = 1;
  double beginSeconds = 0;
  double endSeconds = 0;
  bool loop = true;
  bool quickWhileMoving = true;
  bool divided = false;
  Aov aov = Aov::Radiance;
  SurfelIndex surfelIndex = SurfelIndex::Surfel;
  int treeLevel = 0;
  FilmSettings film;
  std::optional<std::array<int, 2>> pictureSize;
};

EditState editStateOf(const Session& session);

/// Whether the session is in this state. Makes no copy.
bool isStateOf(const EditState& state, const Session& session);

/// Whether the session's model has the state's size. If not, it must be loaded at that size first.
bool hasSizeOf(const EditState& state, const Session& session);

/// Restores the state, which must have the session's size, and notes in the session's edits what
/// that changed.
void restore(const EditState& state, Session& session);

}  // namespace opaline::app::viewer

#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Everything of a session that is edited, and nothing of how one looks at it: not where the camera
/// stands, nor the time that is shown.
struct EditState {
  std::vector<Material> materials;                 ///< by object
  std::map<std::string, MaterialNumbers> numbers;  ///< as in SceneSource
  Lighting lighting;                               ///< but for the environment
  std::optional<EnvironmentFile> environmentFile;
  std::shared_ptr<const Image> environment;  ///< as the file has it, not turned
  std::optional<Ground> ground;
  std::vector<Deformer> deformers;
  RenderOptions options;
  int clip = 0;
  ToneOptions tone;
  bool exposesByLight = true;  ///< what the tone says of exposure then means nothing
  float fovDegrees = 0;
  std::optional<float> diagonalMm;  ///< as asked for; none: as the file has it
  float speed = 1;
  float lengthSeconds = 0;
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

/// Whether it is the session's, without a copy.
bool isStateOf(const EditState& state, const Session& session);

/// Whether the session's model has the state's size: another is loaded first.
bool hasSizeOf(const EditState& state, const Session& session);

/// Brings it back, where the size is the session's, and notes in the session's edits what that
/// changed.
void restore(const EditState& state, Session& session);

}  // namespace opaline::app::viewer

#pragma once

#include <map>
#include <set>
#include <string>

#include "opaline/log.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Puts models into a scene that is still empty; they are in millimetres and in their places. An
/// object whose name an earlier model uses gets a number after it. Clips of one name play together,
/// all lights shine, and the first camera is the scene's.
class JoinedModels {
 public:
  explicit JoinedModels(RawScene& scene) : scene_(scene) {}
  void add(RawScene&& model);

 private:
  void giveOwnNames(RawScene& model);

  RawScene& scene_;
  std::set<std::string> names_;         ///< of objects added so far
  std::map<std::string, int> numbers_;  ///< per name the number to add; all lower ones are taken
};

/// A log that passes each message on once only.
LogCallback eachOnce(const LogCallback& log);

}  // namespace opaline::scene

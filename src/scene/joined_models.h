#pragma once

#include <map>
#include <set>
#include <string>

#include "opaline/log.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Puts models, in millimetres and in their places, into a scene that has nothing yet. An object
/// whose name an earlier model has gets a number behind it. Clips of one name play together; lights
/// shine together; the first camera is the scene's.
class JoinedModels {
 public:
  explicit JoinedModels(RawScene& scene) : scene_(scene) {}
  void add(RawScene&& model);

 private:
  void giveOwnNames(RawScene& model);

  RawScene& scene_;
  std::set<std::string> names_;         ///< of objects that are there
  std::map<std::string, int> numbers_;  ///< behind a name; all lower ones are taken
};

/// What is true of many models is said once.
LogCallback eachOnce(const LogCallback& log);

}  // namespace opaline::scene

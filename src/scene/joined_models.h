#pragma once

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Puts a model, in millimetres and in its place, beside those that are there. An object whose name
/// an earlier model has gets a number behind it. Clips of one name play together; lights shine
/// together; the first camera is the scene's.
void join(RawScene& scene, RawScene&& model);

}  // namespace opaline::scene

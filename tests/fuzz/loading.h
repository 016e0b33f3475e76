#pragma once

#include <functional>
#include <string_view>

#include "opaline/scene.h"
#include "reading.h"
#include "scene/formats.h"

namespace opaline::fuzz {

/// Models "cube.ply", "cube_1.ply", "cube_2.ply" and pictures "sky.hdr" and "texture.png", for what
/// names them: in folder().
void writeNeighbours();

/// The scene is sound, also at some moments of its motion, or an Error is thrown that says why not.
void expectSoundOrRefused(const std::function<Scene()>& load);

/// The same of a model's bytes.
void expectSoundOrRefused(scene::RawScene (*load)(const scene::Input&), std::string_view name,
                          std::string_view bytes);

}  // namespace opaline::fuzz

#pragma once

#include "opaline/sequence.h"
#include "scene/mesh/mesh_files.h"

namespace opaline {

struct MeshSequence::State {
  scene::MeshFiles files;
  Scene scene;
};

}  // namespace opaline

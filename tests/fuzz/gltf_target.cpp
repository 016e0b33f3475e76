#include "loading.h"

// A binary file whose JSON and buffer gltf_mutator.cpp changes apart.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::expectSoundOrRefused(scene::loadGltf, "a.glb", fuzz::textOf(data, size));
  return 0;
}

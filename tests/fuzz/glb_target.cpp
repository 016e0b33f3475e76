#include "loading.h"

// Of the binary or the text format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::expectSoundOrRefused(scene::loadGltf, "a.glb", fuzz::textOf(data, size));
  return 0;
}

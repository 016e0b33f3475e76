#include "loading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::expectSoundOrRefused(scene::loadPly, "a.ply", fuzz::textOf(data, size));
  return 0;
}

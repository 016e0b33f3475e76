#include "loading.h"
#include "opaline/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  const std::filesystem::path file = fuzz::fileOf("scene.toml", fuzz::textOf(data, size));
  fuzz::expectSoundOrRefused([&] { return loadSceneFile(file).scene; });
  return 0;
}

#include "loading.h"

// What follows a line "# mtl" is the file a.mtl.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  constexpr std::string_view mark = "\n# mtl\n";
  const std::string_view text = fuzz::textOf(data, size);
  const std::size_t end = text.find(mark);
  if (end != std::string_view::npos) fuzz::fileOf("a.mtl", text.substr(end + mark.size()));
  fuzz::expectSoundOrRefused(scene::loadObj, "a.obj", text.substr(0, end));
  return 0;
}

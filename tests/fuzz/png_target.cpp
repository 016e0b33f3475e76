#include "opaline/image_file.h"
#include "reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  const std::filesystem::path file = fuzz::fileOf("a.png", fuzz::textOf(data, size));
  fuzz::expectReadOrRefused([&] { readPng(file); });
  fuzz::expectReadOrRefused([&] { readImageNote(file); });
  fuzz::expectReadOrRefused([&] { isWholeImage(file, 8, 8); });
  return 0;
}

#include <span>

#include "core/hdr_readers.h"
#include "reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::expectReadOrRefused(
      [&] { core::readRadiance("a.hdr", std::as_bytes(std::span(data, size))); });
  return 0;
}

#include <fmt/format.h>
#include <stb_image_write.h>

#include <cassert>
#include <limits>
#include <string>

#include "core/file.h"
#include "core/image_file.h"
#include "opaline/error.h"

namespace opaline::core {

void writePng(const std::filesystem::path& file, const Image8& image) {
  constexpr int channels = 4;
  assert(image.width > 0 && image.height > 0);
  assert(image.rgba.size() == std::size_t{channels} * static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height));
  // stb_image_write counts bytes in int; its compressor may need a little more than the pixels.
  if (image.rgba.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4 * 3) {
    throw Error(fmt::format("Cannot write {}: {}x{} pixels are too many for PNG; use EXR.",
                            file.string(), image.width, image.height));
  }
  requireWritable(file);
  std::string encoded;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  const int done = stbi_write_png_to_func(append, &encoded, image.width, image.height, channels,
                                          image.rgba.data(), image.width * channels);
  if (done == 0 || encoded.empty()) {
    throw Error(fmt::format("Cannot write {}: there is not enough memory.", file.string()));
  }
  writeWhole(file, encoded);
}

}  // namespace opaline::core

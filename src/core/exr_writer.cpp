#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>

#include "core/sound_image.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline {

namespace {

void writePixels(Imf::OStream& stream, const Image& image, std::string_view note) {
  constexpr std::array<const char*, 4> names = {"R", "G", "B", "A"};
  constexpr std::size_t pixelBytes = 4 * sizeof(float);
  const std::size_t rowBytes = pixelBytes * static_cast<std::size_t>(image.width);

  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  if (!note.empty()) header.insert("opaline", Imf::StringAttribute(std::string(note)));
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    // The library takes a mutable pointer for reading and for writing; here it only reads.
    char* const base = reinterpret_cast<char*>(const_cast<float*>(image.rgba.data() + c));
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, base, pixelBytes, rowBytes));
  }
  Imf::OutputFile output(stream, header, 0);
  output.setFrameBuffer(frame);
  output.writePixels(image.height);
}

}  // namespace

std::filesystem::path writeExr(const Target& target, const Image& image, std::string_view note) {
  core::requireSound(image);
  return writeWhole(target, [&](const std::filesystem::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    try {
      Imf::StdOFStream exrStream(stream, temporary.c_str());
      writePixels(exrStream, image, note);
    } catch (const Iex::BaseExc&) {
      // The exception's text names the temporary file; the stream's state suffices.
      stream.setstate(std::ios::badbit);
    }
    // The destructor of OutputFile has written the table of lines and swallowed errors.
    stream.close();
    if (!stream) throw std::runtime_error("the disk is full or failed");
  });
}

}  // namespace opaline

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/hdr_readers.h"
#include "opaline/error.h"

namespace opaline::core {

namespace {

/// A header read by OpenEXR's C interface, which takes limits per file and allocates nothing for
/// the pixels. The C++ interface has only limits for the whole process.
class HeaderCheck {
 public:
  explicit HeaderCheck(const std::filesystem::path& file) : file_(file) {
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.max_image_width = largestImageEdge;
    options.max_image_height = largestImageEdge;
    options.max_tile_width = largestImageEdge;
    options.max_tile_height = largestImageEdge;
    options.flags = EXR_CONTEXT_FLAG_SILENT_HEADER_PARSE;
    options.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
    require(exr_start_read(&context_, file.c_str(), &options));
  }
  ~HeaderCheck() { exr_finish(&context_); }
  HeaderCheck(const HeaderCheck&) = delete;
  HeaderCheck& operator=(const HeaderCheck&) = delete;

  void requireBoundedSize() const {
    exr_storage_t storage{};
    require(exr_get_storage(context_, 0, &storage));
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED) {
      failToReadImage(file_, "it holds deep pixels; flatten it");
    }
    exr_attr_box2i_t window{};
    require(exr_get_data_window(context_, 0, &window));
    const long long width = 1LL + window.max.x - window.min.x;
    requireImageSize(file_, width, 1LL + window.max.y - window.min.y);
    requireBoundedChunk(storage, width);
  }

 private:
  /// Before it reads anything, the library allocates memory for one chunk of all channels.
  void requireBoundedChunk(exr_storage_t storage, long long width) const {
    constexpr long long bytesPerSample = 4;
    constexpr long long mostBytes = 1LL << 29;
    const exr_attr_chlist_t* channels = nullptr;
    require(exr_get_channels(context_, 0, &channels));
    long long pixels = 0;
    if (storage == EXR_STORAGE_TILED) {
      std::uint32_t tileWidth = 0;
      std::uint32_t tileHeight = 0;
      require(exr_get_tile_descriptor(context_, 0, &tileWidth, &tileHeight, nullptr, nullptr));
      // The library keeps one row of tiles at a time.
      pixels = (width + tileWidth) * tileHeight;
    } else {
      std::int32_t lines = 0;
      require(exr_get_scanlines_per_chunk(context_, 0, &lines));
      pixels = width * lines;
    }
    if (pixels * bytesPerSample * channels->num_channels > mostBytes) {
      failToReadImage(file_, "its tiles or its number of channels are too large");
    }
  }

  void require(exr_result_t result) const {
    if (result == EXR_ERR_SUCCESS) return;
    failToReadImage(file_, fmt::format("OpenEXR says: {}", exr_get_default_error_message(result)));
  }

  std::filesystem::path file_;
  exr_context_t context_ = nullptr;
};

/// The C++ interface reads a list of channels up to its empty name, wherever the attribute ends.
bool isWholeChannelList(std::string_view bytes) {
  constexpr std::size_t bytesAfterName = 16;
  while (!bytes.empty() && bytes.front() != '\0') {
    const std::size_t name = bytes.find('\0');
    if (name == std::string_view::npos || bytes.size() - name - 1 < bytesAfterName) return false;
    bytes.remove_prefix(name + 1 + bytesAfterName);
  }
  return bytes.size() == 1;
}

/// The C++ interface reads the fixed number of bytes that these types have, whatever the
/// attribute's length.
bool hasBytesOfItsType(std::string_view type, std::string_view bytes) {
  struct Type {
    std::string_view name;
    std::size_t bytes;
  };
  constexpr std::array types{
      Type{"box2f", 16},      Type{"box2i", 16},   Type{"chromaticities", 32},
      Type{"compression", 1}, Type{"double", 8},   Type{"envmap", 1},
      Type{"float", 4},       Type{"int", 4},      Type{"keycode", 28},
      Type{"lineOrder", 1},   Type{"m33d", 72},    Type{"m33f", 36},
      Type{"m44d", 128},      Type{"m44f", 64},    Type{"rational", 8},
      Type{"tiledesc", 9},    Type{"timecode", 8}, Type{"v2d", 16},
      Type{"v2f", 8},         Type{"v2i", 8},      Type{"v3d", 24},
      Type{"v3f", 12},        Type{"v3i", 12},     Type{"deepImageState", 1}};
  if (type == "chlist") return isWholeChannelList(bytes);
  const auto* const known =
      std::find_if(types.begin(), types.end(), [&](const Type& one) { return one.name == type; });
  return known == types.end() || known->bytes == bytes.size();
}

/// For an attribute of unknown type, the C++ interface allocates as many bytes as it claims to have
/// before it reads them. So every claim is first checked against the length of the file.
void requireAttributesFit(const std::filesystem::path& file) {
  constexpr std::streamoff startOfHeader = 8;
  const auto fileBytes = static_cast<std::streamoff>(std::filesystem::file_size(file));
  std::ifstream stream(file, std::ios::binary);
  std::array<unsigned char, startOfHeader> start{};
  stream.read(reinterpret_cast<char*>(start.data()), startOfHeader);
  const bool multiPart = (start[5] & 0x10U) != 0;
  std::string name;
  std::string type;
  std::string value;
  bool afterAttribute = false;
  while (std::getline(stream, name, '\0')) {
    if (name.empty()) {
      // An empty name ends a header; an empty header ends a list of several.
      if (!multiPart || !afterAttribute) return;
      afterAttribute = false;
      continue;
    }
    std::array<unsigned char, 4> bytes{};
    std::getline(stream, type, '\0');
    stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    const std::streamoff size =
        static_cast<std::streamoff>(bytes[3]) << 24U | bytes[2] << 16U | bytes[1] << 8U | bytes[0];
    if (!stream || size > fileBytes - stream.tellg()) break;
    value.resize(static_cast<std::size_t>(size));
    stream.read(value.data(), size);
    if (!hasBytesOfItsType(type, value)) break;
    afterAttribute = true;
  }
  failToReadImage(file, "its header is damaged, or claims more than the file holds");
}

std::string channelNames(const Imf::ChannelList& channels) {
  std::string names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    names += names.empty() ? "" : ", ";
    names += channel.name();
  }
  return names;
}

/// Names of the channels that become R, G, B and A; no name for A if there is no alpha.
std::array<const char*, 4> chooseChannels(const std::filesystem::path& file,
                                          const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  const char* const alpha = has("A") ? "A" : nullptr;
  std::array<const char*, 4> chosen{};
  if (has("R") && has("G") && has("B")) {
    chosen = {"R", "G", "B", alpha};
  } else if (has("Y") && !has("RY") && !has("BY")) {
    chosen = {"Y", "Y", "Y", alpha};
  } else {
    failToReadImage(file, fmt::format("it has no channels R, G and B and no lone Y, but {}",
                                      channelNames(channels)));
  }
  for (const char* name : chosen) {
    if (name == nullptr) continue;
    const Imf::Channel* const channel = channels.findChannel(name);
    if (channel->xSampling != 1 || channel->ySampling != 1) {
      failToReadImage(file, fmt::format("channel {} is subsampled; save it in full", name));
    }
  }
  return chosen;
}

/// Rows [firstRow, firstRow + rows) of the data window into `buffer`, R G B A.
void readRows(Imf::InputFile& input, const std::array<const char*, 4>& channels, int firstRow,
              int rows, std::vector<float>& buffer) {
  const Imath::Box2i& window = input.header().dataWindow();
  const int width = window.max.x - window.min.x + 1;
  const Imath::V2i origin(window.min.x, window.min.y + firstRow);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels[c] == nullptr || (c > 0 && channels[c] == channels[c - 1])) continue;
    frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, buffer.data() + c, origin, width, rows,
                                               4 * sizeof(float)));
  }
  input.setFrameBuffer(frame);
  input.readPixels(origin.y, origin.y + rows - 1);

  const bool grey = channels[0] == channels[1];
  const std::size_t values =
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  for (std::size_t i = 0; i < values; i += 4) {
    if (grey) buffer[i + 1] = buffer[i + 2] = buffer[i];
    if (channels[3] == nullptr) buffer[i + 3] = 1.0F;
  }
}

}  // namespace

Image readExr(const std::filesystem::path& file, Negatives negatives) {
  try {
    requireAttributesFit(file);
    HeaderCheck(file).requireBoundedSize();
    Imf::InputFile input(file.c_str(), 0);
    const Imf::Header& header = input.header();
    if (header.dataWindow() != header.displayWindow()) {
      failToReadImage(file, "its data window differs from its display window; save it uncropped");
    }
    const Imath::V2i size = header.dataWindow().size() + Imath::V2i(1);
    const std::array<const char*, 4> channels = chooseChannels(file, header.channels());

    constexpr int rowsAtOnce = 32;
    RowCollector rows(file, size.x, size.y, std::filesystem::file_size(file), negatives);
    const std::size_t rowFloats = std::size_t{4} * static_cast<std::size_t>(size.x);
    std::vector<float> buffer(rowFloats * rowsAtOnce);
    for (int row = 0; row < size.y; row += rowsAtOnce) {
      const int count = std::min(rowsAtOnce, size.y - row);
      readRows(input, channels, row, count, buffer);
      rows.append(std::span(buffer).first(rowFloats * static_cast<std::size_t>(count)));
    }
    return rows.take();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    std::string reason = failure.what();  // a sentence, or two
    reason.erase(reason.find_last_not_of('.') + 1);
    failToReadImage(file, fmt::format("OpenEXR says: {}", reason));
  }
}

}  // namespace opaline::core

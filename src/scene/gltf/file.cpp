#include "scene/gltf/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/gltf/accepted_json.h"
#include "scene/gltf/decoded.h"
#include "scene/gltf/draco.h"
#include "scene/gltf/meshopt.h"
#include "scene/gltf/prescan.h"
#include "scene/own_folder.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

namespace fs = std::filesystem;

/// The header of a binary file with the head of its first chunk.
constexpr std::size_t headerBytes = 20;

/// Answers the library's requests to the file system.
struct FileAccess {
  std::string folder;  ///< canonical
  GltfPrescan prescan;
  std::size_t bytesRead = 0;
  std::string refusal;  ///< why the last file was not given
};

/// The path relative to the model's folder, if the model may read it.
std::optional<fs::path> allowed(FileAccess& access, const std::string& path) {
  // The library also looks in the working directory.
  if (!path.starts_with(access.folder + "/")) return std::nullopt;
  const std::string name = path.substr(access.folder.size() + 1);
  if (!access.prescan.bufferFiles.contains(name)) return std::nullopt;
  return fileInFolder(access.folder, name, "buffer", access.refusal);
}

bool fileExists(const std::string& path, void* user) {
  return allowed(*static_cast<FileAccess*>(user), path).has_value();
}

bool readWholeFile(std::vector<unsigned char>* out, std::string*, const std::string& path,
                   void* user) {
  auto& access = *static_cast<FileAccess*>(user);
  const auto file = allowed(access, path);
  if (!file) return false;
  try {
    const std::vector<std::byte> bytes = readFile(*file, longestFileBytes - access.bytesRead);
    access.bytesRead += bytes.size();
    out->resize(bytes.size());
    if (!bytes.empty()) std::memcpy(out->data(), bytes.data(), bytes.size());
    return true;
  } catch (const Error& error) {
    access.refusal = error.what();
    return false;
  }
}

/// Sets every callback that the library has. Versions that find one missing use their own, which
/// would read any path. Some versions also ask for sizes first, for a limit that readWholeFile()
/// enforces anyway.
template <typename Callbacks>
Callbacks callbacksOf(FileAccess& access) {
  Callbacks callbacks{};
  callbacks.FileExists = fileExists;
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = readWholeFile;
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  if constexpr (requires { callbacks.GetFileSizeInBytes; })
    callbacks.GetFileSizeInBytes = [](std::size_t* bytes, std::string*, const std::string&, void*) {
      *bytes = 0;
      return true;
    };
  callbacks.user_data = &access;
  return callbacks;
}

bool keepImage(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
               const unsigned char* bytes, int size, void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

std::uint32_t littleEndian32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = (value << 8U) | std::to_integer<std::uint32_t>(bytes[at + i]);
  }
  return value;
}

/// The JSON chunk of a binary file, or the whole of a text file.
std::string_view jsonOf(const Input& input, bool binary) {
  const auto* text = reinterpret_cast<const char*>(input.bytes.data());
  if (!binary) return {text, input.bytes.size()};
  if (input.bytes.size() < headerBytes) failGltf(input, "the file ends inside its header");
  const std::uint32_t version = littleEndian32(input.bytes, 4);
  if (version != 2) failGltf(input, fmt::format("it is of glTF version {}, not 2", version));
  if (littleEndian32(input.bytes, 8) > input.bytes.size()) {
    failGltf(input, "the file is shorter than its header says; it is damaged or incomplete");
  }
  const std::uint32_t size = littleEndian32(input.bytes, 12);
  if (size > input.bytes.size() - headerBytes) {
    failGltf(input, "the JSON chunk is longer than the file");
  }
  return {text + headerBytes, size};
}

std::string word(std::size_t value) {
  std::string bytes(4, '\0');
  for (char& byte : bytes) {
    byte = static_cast<char>(value & 0xffU);
    value >>= 8U;
  }
  return bytes;
}

/// The bytes of the file, or a copy of them in `changed` where the library would refuse them.
std::string_view bytesToRead(const Input& input, const GltfPrescan& prescan, std::string_view json,
                             bool binary, std::string& changed) {
  const std::string_view bytes(reinterpret_cast<const char*>(input.bytes.data()),
                               input.bytes.size());
  std::optional<std::string> text = acceptedJson(prescan, json);
  if (!text) return bytes;
  if (binary) {
    text->resize((text->size() + 3) / 4 * 4, ' ');
    const std::string_view rest = bytes.substr(headerBytes + json.size());
    changed = "glTF" + word(2) + word(headerBytes + text->size() + rest.size()) +
              word(text->size()) + "JSON" + *text;
    changed += rest;
  } else {
    changed = std::move(*text);
  }
  return changed;
}

/// The first sentence of the library's complaints, empty if none is serious. The library reports
/// missing inverse bind matrices, which are optional (glTF 2.0, section 5.28), and goes on.
std::string firstComplaint(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.empty() && line != "'inverseBindMatrices' property is missing in Skin.") {
      return cleanText(line, 200);
    }
  }
  return {};
}

}  // namespace

void failGltf(const Input& input, const std::string& reason) {
  throw Error(fmt::format("{}: {}", cleanText(input.file.string(), 1000), reason));
}

tinygltf::Model readGltf(const Input& input) {
  const std::string_view start(reinterpret_cast<const char*>(input.bytes.data()),
                               std::min<std::size_t>(input.bytes.size(), 4));
  const bool binary = start == "glTF";
  FileAccess access;
  const std::string_view json = jsonOf(input, binary);
  access.prescan = prescanGltf(input, json, binary);
  std::string changed;
  const std::string_view bytes = bytesToRead(input, access.prescan, json, binary, changed);
  access.folder = folderOf(input.file);

  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keepImage, nullptr);
  reader.SetFsCallbacks(callbacksOf<tinygltf::FsCallbacks>(access));
  tinygltf::Model model;
  std::string error;
  std::string warning;
  bool whole = false;
  const auto size = static_cast<unsigned>(bytes.size());
  try {
    whole = binary ? reader.LoadBinaryFromMemory(
                         &model, &error, &warning,
                         reinterpret_cast<const unsigned char*>(bytes.data()), size, access.folder)
                   : reader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size,
                                                access.folder);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    // The JSON has a value of another type than the library expects.
    failGltf(input, fmt::format("its JSON is not glTF: {}", firstComplaint(exception.what())));
  }
  if (!access.refusal.empty()) failGltf(input, access.refusal);
  const std::string complaint = firstComplaint(error);
  if (!whole || !complaint.empty()) {
    failGltf(input, fmt::format("it is not a valid glTF file: {}",
                                complaint.empty() ? "unknown reason" : complaint));
  }
  if (!model.asset.version.starts_with("2.")) {
    failGltf(input, fmt::format("it is of glTF version '{}', not 2.0",
                                cleanText(model.asset.version, 20)));
  }
  GltfDecoded decoded(input, model);
  decodeMeshopt(decoded);
  decodeDraco(decoded);
  return model;
}

}  // namespace opaline::scene

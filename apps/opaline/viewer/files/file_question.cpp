#include "viewer/files/file_question.h"

#include <algorithm>

#include "cli/paths.h"

namespace opaline::app::viewer {

bool FileQuestion::saves() const {
  return use != FileUse::OpenScene && use != FileUse::OpenEnvironment;
}

FileQuestion questionFor(FileUse use) {
  switch (use) {
    case FileUse::OpenScene:
      return {use,
              "Open a model or a scene",
              "models and scenes",
              {".glb", ".gltf", ".obj", ".ply", ".toml"},
              {},
              {}};
    case FileUse::OpenEnvironment:
      return {use, "Open an environment", "environments", {".hdr", ".exr"}, {}, {}};
    case FileUse::SavePicture:
      return {use, "Save the picture", "PNG pictures", {".png"}, {}, {}};
    case FileUse::SaveExr:
      return {use, "Save the picture's light", "OpenEXR pictures", {".exr"}, {}, {}};
    case FileUse::SaveScene:
      return {use, "Save the scene", "scenes", {".toml"}, {}, {}};
    case FileUse::SaveFilm:
      break;
  }
  return {FileUse::SaveFilm, "Save a film", "films", {".mp4"}, {}, {}};
}

std::filesystem::path withExtension(std::filesystem::path file, const FileQuestion& question) {
  const std::vector<std::string>& known = question.extensions;
  if (std::find(known.begin(), known.end(), extensionOf(file)) == known.end()) {
    file += known.front();
  }
  return file;
}

}  // namespace opaline::app::viewer

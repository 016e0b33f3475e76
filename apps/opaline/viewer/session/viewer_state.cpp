#include "viewer/session/viewer_state.h"

#include <algorithm>
#include <string>

#include "cli/json.h"
#include "opaline/error.h"
#include "opaline/file.h"

namespace opaline::app::viewer {

namespace {

std::filesystem::path fileIn(const std::filesystem::path& folder) {
  return folder / "view.json";
}

}  // namespace

ViewerState readState(const std::filesystem::path& folder) {
  ViewerState state;
  if (folder.empty()) return state;
  constexpr std::size_t longest = 1U << 16U;
  try {
    const std::vector<std::byte> bytes = readFile(fileIn(folder), longest);
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    const Json json = Json::parse(text, text + bytes.size());
    ViewerState read;
    read.width = std::clamp(json.at("size").at(0).get<int>(), 320, 16384);
    read.height = std::clamp(json.at("size").at(1).get<int>(), 240, 16384);
    read.panels = json.at("panels").get<bool>();
    read.handles = json.at("handles").get<bool>();
    read.scaleBar = json.at("scale_bar").get<bool>();
    for (const auto& [name, open] : json.at("open").items()) {
      read.openSections[name] = open.get<bool>();
    }
    read.openFolder = json.value("open_folder", std::string());
    return read;
  } catch (const Error&) {
    return state;  // no state was saved yet
  } catch (const Json::exception&) {
    return state;  // not our file, or from another version
  }
}

void writeState(const std::filesystem::path& folder, const ViewerState& state) {
  if (folder.empty()) return;
  Json open = Json::object();
  for (const auto& [name, isOpen] : state.openSections) open[name] = isOpen;
  const Json json{{"size", {state.width, state.height}},
                  {"panels", state.panels},
                  {"handles", state.handles},
                  {"scale_bar", state.scaleBar},
                  {"open", std::move(open)},
                  {"open_folder", state.openFolder.string()}};
  try {
    writeWhole(fileIn(folder), toText(json));
  } catch (const Error&) {
    return;  // failing to save is no reason to complain when the window closes
  }
}

}  // namespace opaline::app::viewer

#include "viewer/session/loader.h"

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "cli/field_names.h"

namespace opaline::app::viewer {

namespace {

// What the command line does by an option, the window does by a control.
std::string withControlNames(std::string_view note) {
  std::string text = withOptionNames(note);
  constexpr std::string_view option = "--diagonal-mm";
  if (const std::size_t at = text.find(option); at != std::string::npos)
    text.replace(at, option.size(), "the size under Medium");
  return text;
}

}  // namespace

Loader::~Loader() {
  if (thread_.joinable()) thread_.join();
}

void Loader::start(const SceneOptions& source) {
  if (thread_.joinable()) thread_.join();
  done_ = false;
  result_ = {.source = source};
  thread_ = std::thread([this] {
    try {
      result_.loaded = result_.source.load([this](LogLevel, std::string_view note) {
        result_.notes.push_back(withControlNames(note));
      });
    } catch (const std::exception& error) {
      result_.error = error.what();
    }
    done_ = true;
    whenDone_();
  });
}

std::optional<Loader::Result> Loader::take() {
  if (!thread_.joinable() || !done_) return std::nullopt;
  thread_.join();
  return std::exchange(result_, {});
}

}  // namespace opaline::app::viewer

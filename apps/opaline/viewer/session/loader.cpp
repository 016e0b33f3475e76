#include "viewer/session/loader.h"

#include <exception>
#include <string_view>
#include <utility>

#include "viewer/session/control_names.h"

namespace opaline::app::viewer {

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

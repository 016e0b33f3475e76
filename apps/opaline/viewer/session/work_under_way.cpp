#include "viewer/session/work_under_way.h"

#include <fmt/format.h>

namespace opaline::app::viewer {

std::optional<std::string> workUnderWay(const Saver& saver, const TruthView& truth) {
  std::string lost;
  if (saver.filming()) {
    lost = fmt::format("A film is being made, {:.0f} % done; stopping now deletes it.",
                       100 * saver.progress());
  }
  if (truth.running()) {
    lost += fmt::format("{}The truth is being computed, {:.0f} % done.", lost.empty() ? "" : " ",
                        100 * truth.progress());
  }
  if (lost.empty()) return std::nullopt;
  return lost;
}

void stopWork(Saver& saver, TruthView& truth) {
  saver.cancelFilm();
  truth.cancel();
}

}  // namespace opaline::app::viewer

#include "viewer/panels/option_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/panels/controls.h"

namespace opaline::app::viewer {

namespace {

template <typename T>
bool chooseOne(const char* name, T& value, const std::vector<T>& all,
               const std::vector<std::string>& names, const char* about) {
  auto chosen = static_cast<int>(std::find(all.begin(), all.end(), value) - all.begin());
  if (!controls::choice(name, chosen, names, about)) return false;
  value = all[static_cast<std::size_t>(chosen)];
  return true;
}

struct Control {
  const char* name;
  const options::Allowed& allowed;
  const char* about;

  bool operator()(bool& on) const { return controls::checkbox(name, on, about); }

  bool operator()(int& number) const {
    const options::Range& range = allowed.range;
    if (allowed.counts.empty())
      return controls::integer(name, number, static_cast<int>(range.least),
                               static_cast<int>(range.most), about);
    std::vector<std::string> names;
    for (const int count : allowed.counts) names.push_back(fmt::format("{}", count));
    return chooseOne(name, number, allowed.counts, names, about);
  }

  bool operator()(float& number) const {
    const options::Range& range = allowed.range;
    const std::string format = fmt::format("%.4g {}", range.unit);
    return controls::slider(name, number, range.leastFloat(), range.mostFloat(), format.c_str(),
                            about);
  }

  bool operator()(std::string& text) const {
    const std::vector<std::string> names{allowed.choices.begin(), allowed.choices.end()};
    return chooseOne(name, text, names, names, about);
  }

  template <typename Other>
  bool operator()(Other&) const {
    return false;  // sizes and colours have controls of their own
  }
};

}  // namespace

bool drawOption(const char* name, RenderOptions& options, std::string_view key, const char* about) {
  const auto& field = options::fieldOf<options::PictureSettings>(key);
  options::PictureSettings settings{.render = options};
  std::optional<options::Value> value = field.get(settings);
  if (!value || !std::visit(Control{name, field.allowed, about}, *value)) return false;
  field.set(settings, *value);
  options = settings.render;
  return true;
}

}  // namespace opaline::app::viewer

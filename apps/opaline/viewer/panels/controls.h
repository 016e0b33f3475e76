#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/values.h"
#include "opaline/types.h"

/// The controls of panels: Dear ImGui's, each with a tooltip. Each notes its place, so that the
/// window can be driven from outside.
namespace opaline::app::viewer::controls {

struct Place {
  std::string name;  ///< of the panel and the control: "Medium/eta"
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;
};

/// Begins the list of places for a frame.
void beginFrame();
/// The controls that were visible since then.
const std::vector<Place>& places();

/// A section that folds. `open` says whether it starts open, unless setOpenSections() decided. Its
/// name is the prefix of its controls' names.
bool section(const char* name, bool open);
using Sections = std::map<std::string, bool>;  ///< by name, whether it is open
Sections openSections();
void setOpenSections(const Sections& sections);

/// For controls outside sections: its name is the prefix of the controls' names while it exists.
class Group {
 public:
  explicit Group(const char* name);
  ~Group();
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

 private:
  std::string before_;
};

/// What the last control is for, as a tooltip.
void tip(const char* text);

/// Text in any script, in lines of any length.
void text(const std::string& shown);

/// The same, paler: what is good to know beside a control.
void hint(const std::string& shown);

/// Continues the line if it has room for a button of that name.
void sameLineFor(const char* next);

bool button(const char* name, const char* about);
bool checkbox(const char* name, bool& on, const char* about);
/// `format` is as for printf, with the unit. Logarithmic where `low` > 0 and `high` ≥ 1000 `low`.
bool slider(const char* name, float& value, float low, float high, const char* format,
            const char* about);
bool slider(const char* name, double& value, double low, double high, const char* format,
            const char* about);
/// A length in a suitable unit.
bool length(const char* name, float& mm, float lowMm, float highMm, const char* about);
/// An exposure.
bool stops(const char* name, float& value, float low, float high, const char* about);
bool integer(const char* name, int& value, int low, int high, const char* about);
/// The whole number that is nearest to what was typed, in [low, high]. None if it is no number.
std::optional<int> wholeNumber(std::string_view text, int low, int high);
/// A typed number. It takes effect on Enter or when the field is left, unless it is none.
bool typed(const char* name, int& value, int low, int high, const char* about);
/// Light of any strength, with separate controls for hue and strength.
bool light(const char* name, Rgb& value, const char* about);
/// A color whose channels are shares, 0 to 1.
bool color(const char* name, Rgb& value, const char* about);
/// One of several names.
bool choice(const char* name, int& chosen, const std::vector<std::string>& names,
            const char* about);

template <typename T>
bool choice(const char* name, T& value, const Choices<T>& choices, const char* about) {
  std::vector<std::string> names;
  int chosen = 0;
  for (const auto& [text, meaning] : choices) {
    if (meaning == value) chosen = static_cast<int>(names.size());
    names.push_back(text);
  }
  if (!choice(name, chosen, names, about)) return false;
  value = choices[static_cast<std::size_t>(chosen)].second;
  return true;
}

/// Records the place of the control drawn last under a name.
void note(const char* name);

}  // namespace opaline::app::viewer::controls

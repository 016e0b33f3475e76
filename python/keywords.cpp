#include "python/keywords.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "opaline/error.h"
#include "opaline/options/picture.h"

namespace opaline::python {

namespace {

using Settings = options::PictureSettings;
using Option = options::Field<Settings>;

/// Said in other ways: as arguments of their own, or when a picture is written.
constexpr std::array<std::string_view, 5> saidElsewhere{"size", "exposure", "tone", "background",
                                                        "seconds"};

bool isKeyword(const Option& option) {
  return std::find(saidElsewhere.begin(), saidElsewhere.end(), option.key) == saidElsewhere.end();
}

/// The Python value as the option's type; nothing where it is another.
std::optional<options::Value> valueOf(const py::handle& given, const options::Value& like) {
  const bool isBool = py::isinstance<py::bool_>(given);
  if (std::holds_alternative<bool>(like)) {
    if (!isBool) return {};
    return given.cast<bool>();
  }
  if (std::holds_alternative<std::string>(like)) {
    if (!py::isinstance<py::str>(given)) return {};
    return given.cast<std::string>();
  }
  if (isBool || !PyNumber_Check(given.ptr())) return {};
  if (std::holds_alternative<int>(like)) {
    if (!PyIndex_Check(given.ptr())) return {};
    return given.cast<int>();
  }
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Float(given.ptr()));
  if (!number) throw py::error_already_set();
  if (std::holds_alternative<float>(like)) return static_cast<float>(number.cast<double>());
  return number.cast<double>();
}

template <typename Enumeration>
Enumeration choiceOf(const std::string& name, const char* what) {
  const std::vector<std::string_view>& names = options::namesOf<Enumeration>();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    std::string all;
    for (const std::string_view known : names) {
      all += fmt::format("{}'{}'", all.empty() ? "" : ", ", known);
    }
    throw UsageError(fmt::format("There is no {} '{}'; there are {}.", what, name, all));
  }
  return options::named<Enumeration>(name);
}

}  // namespace

void applyKeywords(const py::kwargs& keywords, RenderOptions& options) {
  Settings settings;
  settings.render = options;
  for (const auto& [name, given] : keywords) {
    const auto key = name.cast<std::string>();
    const Option* const option = options::findField<Settings>(key);
    if (!option || !isKeyword(*option)) {
      throw py::type_error(
          fmt::format("there is no option '{}'; help(Renderer.render) has all", key));
    }
    const auto value = valueOf(given, option->like);
    if (!value) {
      throw py::type_error(fmt::format(
          "{} is a {}", key, py::str(py::type::of(given).attr("__name__")).cast<std::string>()));
    }
    if (!option->allowed.holds(*value)) {
      throw UsageError(fmt::format("{} {} {}", key, options::textOf(*value),
                                   options::requirement(option->allowed, *value)));
    }
    option->set(settings, *value);
  }
  options = settings.render;
}

std::string keywordHelp() {
  std::string help;
  const Settings standard;
  for (const Option& option : options::fieldsOf<Settings>()) {
    if (!isKeyword(option)) continue;
    const auto value = option.get(standard);
    help += fmt::format("    {}: {}; {} [{}]\n", option.key, option.help,
                        std::holds_alternative<bool>(option.like)
                            ? "True or False"
                            : options::requirement(option.allowed, option.like),
                        value ? options::textOf(*value) : std::string(option.standard));
  }
  return help;
}

Aov aovOf(const std::string& name) {
  return choiceOf<Aov>(name, "variable");
}

Transport transportOf(const std::string& name) {
  return choiceOf<Transport>(name, "transport");
}

std::vector<Aov> aovsOf(const py::handle& names) {
  if (py::isinstance<py::str>(names)) return {aovOf(names.cast<std::string>())};
  std::vector<Aov> aovs;
  for (const py::handle& name : py::reinterpret_borrow<py::iterable>(names)) {
    aovs.push_back(aovOf(name.cast<std::string>()));
  }
  return aovs;
}

std::string nameOf(Aov aov) {
  return options::nameOf(aov);
}

std::string nameOf(Transport transport) {
  return options::nameOf(transport);
}

std::string nameOf(Sum sum) {
  return options::nameOf(sum);
}

}  // namespace opaline::python

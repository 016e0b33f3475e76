#include "cli/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/output.h"
#include "cli/values.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

constexpr std::size_t helpColumn = 30;
constexpr std::size_t helpWidth = 80;

// What follows it are files, even if their names begin with -.
constexpr std::string_view endOfOptions = "--";

/// The number of edits from one word to the other; swapping neighbours counts as one (Damerau
/// 1964).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({replaced, cost[i - 1][j] + 1, cost[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

/// Wraps words to `width`, with `indent` spaces after each line break.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string result;
  std::string line;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      result += line + "\n" + std::string(indent, ' ');
      line.clear();
    }
    line += line.empty() ? word : " " + word;
    begin = end + 1;
  }
  return result + line;
}

std::string helpLine(const std::string& left, const std::string& help) {
  const std::string start = "  " + left;
  if (start.size() + 2 > helpColumn && start.size() + 2 + help.size() <= helpWidth) {
    return start + "  " + help + "\n";
  }
  const std::string gap = start.size() + 2 > helpColumn
                              ? "\n" + std::string(helpColumn, ' ')
                              : std::string(helpColumn - start.size(), ' ');
  return start + gap + wrapped(help, helpWidth - helpColumn, helpColumn) + "\n";
}

/// Whether a word can only be meant as numbers, be they none: "0.5,1,", "nan". A file may have such
/// a name if it has letters.
bool isForNumbers(const std::string& word) {
  constexpr const char* digits = "0123456789.,-+e";
  if (word.find_first_not_of(digits) == std::string::npos) return !word.empty();
  const std::vector<std::string_view> parts = split(word, ',');
  std::error_code none;
  return std::all_of(parts.begin(), parts.end(), isNumber) && !std::filesystem::exists(word, none);
}

std::string spaced(std::string names) {
  const std::size_t comma = names.find(',');
  return comma == std::string::npos ? names : names.replace(comma, 1, ", ");
}

std::string missingValue(const std::string& option, const std::string& placeholder) {
  return fmt::format("{} needs a value, {}", option, placeholder);
}

}  // namespace

std::string suggestion(std::string_view typed, std::span<const std::string> candidates) {
  const std::string_view word = typed.substr(0, 64);
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  const std::string* nearest = nullptr;
  std::size_t least = (letters + 1) / 3 + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = &candidate;
    }
  }
  return nearest == nullptr ? "" : fmt::format("; did you mean {}?", *nearest);
}

std::string suggestion(std::string_view typed, std::span<const std::string> candidates,
                       std::string_view lister) {
  const std::string nearest = suggestion(typed, candidates);
  return fmt::format("{}{} lists all", nearest.empty() ? "; " : nearest + " ", lister);
}

CommandLine::CommandLine(std::string name, std::string summary)
    : name_(std::move(name)), summary_(std::move(summary)), app_(std::make_unique<CLI::App>()) {
  app_->set_help_flag();
  helpFlag_ = app_->add_flag("-h,--help");
  app_->allow_extras();
}

CommandLine::~CommandLine() = default;

void CommandLine::positional(const std::string& name, const std::string& help, Taker take) {
  positionalNames_.push_back(name);
  usage_ += fmt::format(" [{}]", name);
  addValue(name, name, help, std::move(take), false);
}

void CommandLine::positionals(const std::string& name, const std::string& help, Taker take) {
  positionalNames_.push_back(name);
  usage_ += fmt::format(" [{}]...", name);
  addValue(name, name, help, std::move(take), true);
  entries_.back().option->expected(-1);
}

void CommandLine::requiredPositional(const std::string& name, const std::string& help, Taker take) {
  positionalNames_.push_back(name);
  usage_ += " " + name;
  addValue(name, name, help, std::move(take), false);
  entries_.back().required = true;
}

void CommandLine::section(const std::string& title) {
  Entry entry;
  entry.left = title;
  entries_.push_back(std::move(entry));
}

void CommandLine::flag(const std::string& names, const std::string& help, bool& on) {
  flag(names, help, [&on] { on = true; });
}

void CommandLine::flag(const std::string& names, const std::string& help,
                       std::function<void()> take) {
  Entry entry;
  entry.left = entry.names = spaced(names);
  entry.help = help;
  entry.option = app_->add_flag(names)->disable_flag_override();
  entry.repeatable = true;
  flagTakers_.emplace_back([option = entry.option, take = std::move(take)] {
    if (option->count() > 0) take();
  });
  entries_.push_back(std::move(entry));
}

void CommandLine::synonym(const std::string& former, const std::string& option) {
  synonyms_[former] = option;
}

void CommandLine::unavailable(const std::string& option, const std::string& why) {
  unavailable_[option] = why;
}

void CommandLine::outputFlags(const std::string& what, bool& json, bool& quiet) {
  flag("--json", what + "; no notes", json);
  flag("--quiet", "", quiet);
  json_ = &json;
  quiet_ = &quiet;
}

void CommandLine::value(const std::string& names, const std::string& placeholder,
                        const std::string& help, Taker take) {
  addValue(names, placeholder, help, std::move(take), false);
}

void CommandLine::valueOr(const std::string& name, const std::string& placeholder,
                          const std::string& standard, Taker take) {
  standards_.emplace(name, standard);
  addValue(name, placeholder, "", std::move(take), false);
}

void CommandLine::repeated(const std::string& names, const std::string& placeholder,
                           const std::string& help, Taker take) {
  addValue(names, placeholder, help, std::move(take), true);
}

void CommandLine::addValue(const std::string& names, const std::string& placeholder,
                           const std::string& help, Taker take, bool repeatable) {
  Entry entry;
  entry.left = names == placeholder ? names : spaced(names) + " " + placeholder;
  entry.names = spaced(names);
  entry.help = help;
  entry.placeholder = placeholder;
  entry.option =
      app_->add_option(names, CLI::callback_t([](const CLI::results_t&) { return true; }))
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  entry.repeatable = repeatable;
  entry.take = std::move(take);
  entries_.push_back(std::move(entry));
}

bool CommandLine::parse(const std::vector<std::string>& arguments) {
  run(arguments);
  if (helpFlag_->count() > 0) {
    printOut(help());
    return false;
  }
  refuseLeftovers();
  for (const Entry& entry : entries_) {
    if (entry.option == nullptr || !entry.take) continue;
    const std::string name = entry.option->get_name();
    const std::vector<std::string>& given = entry.option->results();
    if (given.empty() && entry.required) {
      throw UsageError(fmt::format("{} needs {}, and {} is missing", name_,
                                   fmt::join(positionalNames_, " and "), name));
    }
    if (given.size() > 1 && !entry.repeatable) {
      throw UsageError(fmt::format("{} is given {} times, with {} and {}; give it once", name,
                                   given.size(), given[0], given[1]));
    }
    for (const std::string& text : given) {
      const bool isOption = name.starts_with('-');
      if (text.empty() && isOption) throw UsageError(missingValue(name, entry.placeholder));
      entry.take({name, text});
    }
  }
  for (const auto& take : flagTakers_) take();
  const bool silent = (json_ != nullptr && *json_) || (quiet_ != nullptr && *quiet_);
  for (const std::string& note : notes_) noteTaker(silent)(LogLevel::Note, note);
  return true;
}

void CommandLine::replaceSynonyms(std::vector<std::string>& arguments) {
  for (std::string& argument : arguments) {
    if (argument == endOfOptions) break;
    const std::string typed = argument.substr(0, argument.find('='));
    const auto found = synonyms_.find(typed);
    if (found == synonyms_.end()) continue;
    argument.replace(0, typed.size(), found->second);
    notes_.push_back(fmt::format("{} is called {} now", typed, found->second));
  }
}

void CommandLine::fillLeftOut(std::vector<std::string>& arguments) const {
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != endOfOptions; ++i) {
    const auto found = standards_.find(arguments[i]);
    if (found == standards_.end()) continue;
    const bool given = i + 1 < arguments.size() && isForNumbers(arguments[i + 1]);
    if (!given) arguments[i] += "=" + found->second;
  }
}

void CommandLine::run(std::vector<std::string> arguments) {
  replaceSynonyms(arguments);
  fillLeftOut(arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI::App expects them in reverse order
  try {
    app_->parse(std::move(arguments));
  } catch (const CLI::ArgumentMismatch& error) {
    // The name ends at a colon, as in "--size: 1 required TEXT missing", or at a blank, as in "json
    // was given a disallowed flag override".
    const std::string message = error.what();
    const std::string name = message.substr(0, message.find_first_of(": "));
    for (const Entry& entry : entries_) {
      if (entry.option == nullptr) continue;
      const std::string option = entry.option->get_name();
      if (option != name && option != "--" + name) continue;
      throw UsageError(entry.placeholder.empty() ? fmt::format("{} takes no value", option)
                                                 : missingValue(option, entry.placeholder));
    }
    throw UsageError(message);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

void CommandLine::refuseLeftovers() const {
  std::vector<std::string> rest = app_->remaining();
  const auto end = std::find(rest.begin(), rest.end(), endOfOptions);
  for (const std::string& argument : std::span(rest.begin(), end)) {
    if (argument.size() > 1 && argument[0] == '-') {
      const std::string option = argument.substr(0, argument.find('='));
      const auto found = unavailable_.find(option);
      if (found != unavailable_.end())
        throw UsageError(fmt::format("{}: {}", option, found->second));
      std::error_code unknown;
      if (!positionalNames_.empty() && std::filesystem::exists(argument, unknown))
        throw UsageError(
            fmt::format("{} has no option {}; the file is ./{}", name_, argument, argument));
      throw UsageError(
          fmt::format("{} has no option {}{}", name_, option, suggestion(option, optionNames())));
    }
  }
  if (end != rest.end()) rest.erase(end);
  if (rest.empty()) return;
  if (positionalNames_.empty()) {
    throw UsageError(fmt::format("{} takes no argument {}", name_, rest[0]));
  }
  throw UsageError(fmt::format("{} takes one {}, and {} is one too many", name_,
                               fmt::join(positionalNames_, " and one "), rest[0]));
}

std::vector<std::string> CommandLine::optionNames() const {
  std::vector<std::string> names{"--help"};
  for (const Entry& entry : entries_) {
    if (entry.option == nullptr) continue;
    for (const std::string& name : entry.option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : entry.option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool CommandLine::hasHelpOfBefore(std::size_t i) const {
  return i < entries_.size() && entries_[i].option != nullptr && entries_[i].help.empty();
}

std::string CommandLine::togetherWithPlaceholders(std::size_t first, std::size_t last) const {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    const bool differs = entries_[i].placeholder != entries_[last].placeholder;
    text += (differs ? entries_[i].left : entries_[i].names) + ", ";
  }
  return text + entries_[last].left;
}

std::string CommandLine::help() const {
  std::string text =
      fmt::format("opaline {}{} [options]\n{}\n", name_, usage_, wrapped(summary_, helpWidth, 0));
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (entry.option == nullptr) {
      text += entry.left + ":\n";
      continue;
    }
    std::size_t last = i;
    while (hasHelpOfBefore(last + 1)) ++last;
    const std::string each = togetherWithPlaceholders(i, last);
    std::string names;
    for (; i < last; ++i) names += entries_[i].names + ", ";
    const bool fits = std::max(each.size() + 4, helpColumn) + entry.help.size() <= helpWidth;
    text += helpLine(fits ? each : names + entries_[last].left, entry.help);
  }
  return text;
}

}  // namespace opaline::app

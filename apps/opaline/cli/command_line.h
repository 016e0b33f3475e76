#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
class Option;
}  // namespace CLI

namespace opaline::app {

/// One value as it was typed, with the option it was typed for.
struct Given {
  std::string option;
  std::string text;
  std::string whole{};  ///< of which the text is a part; none: it is all that was given
};

/// The options of one command: reads the arguments and writes the help, which fits a screen.
class CommandLine {
 public:
  CommandLine(std::string name, std::string summary);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  using Taker = std::function<void(const Given&)>;

  void positional(const std::string& name, const std::string& help, Taker take);
  /// The same for any number of positional arguments.
  void positionals(const std::string& name, const std::string& help, Taker take);
  /// The same for a required argument; parse() reports its absence.
  void requiredPositional(const std::string& name, const std::string& help, Taker take);
  void section(const std::string& title);
  void flag(const std::string& names, const std::string& help, bool& on);
  void flag(const std::string& name, const std::string& help, std::function<void()> take);
  /// An older name of an option: accepted, absent from the help, and noted where it is used.
  void synonym(const std::string& former, const std::string& option);
  /// An option of other commands that this one cannot have: absent from the help, and refused with
  /// the reason.
  void unavailable(const std::string& option, const std::string& why);
  /// --json and --quiet, which every command takes. `what` goes to standard output. --quiet drops
  /// notes and progress, but no warnings.
  void outputFlags(const std::string& what, bool& json, bool& quiet);
  /// An option with an empty `help` shares the help entry of the option before it.
  void value(const std::string& names, const std::string& placeholder, const std::string& help,
             Taker take);
  void repeated(const std::string& names, const std::string& placeholder, const std::string& help,
                Taker take);
  /// A list of numbers that may be left out, which then means `standard`. It shares the help entry
  /// of the option before it.
  void valueOr(const std::string& name, const std::string& placeholder, const std::string& standard,
               Taker take);

  /// Passes every value to its taker, in the order in which the options were declared. False when
  /// help was asked for and printed. Throws UsageError for anything that is not understood.
  bool parse(const std::vector<std::string>& arguments);

  std::string help() const;

 private:
  struct Entry {
    std::string left;  ///< a section's title, or an option with its placeholder
    std::string help;
    std::string names;
    std::string placeholder;
    CLI::Option* option = nullptr;
    bool repeatable = false;
    bool required = false;
    Taker take;
  };

  void addValue(const std::string& names, const std::string& placeholder, const std::string& help,
                Taker take, bool repeatable);
  bool hasHelpOfBefore(std::size_t i) const;
  /// Options that share a help, each with its placeholder where it has not that of the last.
  std::string togetherWithPlaceholders(std::size_t first, std::size_t last) const;
  void replaceSynonyms(std::vector<std::string>& arguments);
  void fillLeftOut(std::vector<std::string>& arguments) const;
  void run(std::vector<std::string> arguments);
  void refuseLeftovers() const;
  std::vector<std::string> optionNames() const;

  std::string name_;
  std::string summary_;
  std::unique_ptr<CLI::App> app_;
  CLI::Option* helpFlag_ = nullptr;
  std::vector<std::string> positionalNames_;
  std::string usage_;  ///< the positional arguments as the help shows them
  std::vector<Entry> entries_;
  std::vector<std::function<void()>> flagTakers_;
  std::map<std::string, std::string> synonyms_;     ///< the option for each older name
  std::map<std::string, std::string> unavailable_;  ///< the reason for each
  std::map<std::string, std::string> standards_;    ///< the default for an option without a value
  std::vector<std::string> notes_;
  const bool* json_ = nullptr;
  const bool* quiet_ = nullptr;
};

/// "; did you mean X?" for the candidate that differs least from what was typed, by at most about a
/// third of its letters, or nothing.
std::string suggestion(std::string_view typed, std::span<const std::string> candidates);

/// The same, and what lists all: "; did you mean X? opaline media lists all".
std::string suggestion(std::string_view typed, std::span<const std::string> candidates,
                       std::string_view lister);

}  // namespace opaline::app

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "command_line.h"
#include "commands.h"
#include "opaline/error.h"
#include "output.h"
#include "table1.h"
#include "values.h"

namespace opaline::app {

namespace {

constexpr const char* suiteName = "table1";

struct BenchCommand {
  std::optional<std::string> suite;
  std::optional<std::filesystem::path> models;
  std::optional<std::string> device;
  int frames = Table1Order{}.frames;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.positional("SUITE", "table1: the paper's Table 1, five models at 1024x1024",
                    [this](const Given& given) {
                      suite = readChoice<std::string>(given, {{suiteName, suiteName}});
                    });
    line.section("Options");
    line.value("--frames", "N", fmt::format("of each measurement, 1 to 1000 [{}]", frames),
               [this](const Given& given) { frames = readInteger(given, 1, 1000); });
    line.value("--models", "FOLDER", "[OPALINE_MODELS, else ../shared/models]",
               [this](const Given& given) { models = given.text; });
    line.value("--device", "NAME|INDEX", "as opaline info lists them [the best]",
               [this](const Given& given) { device = given.text; });
    line.flag("--json", "one JSON object on standard output", json);
    line.flag("--quiet", "no notes on standard error", quiet);
  }

  std::filesystem::path folder() const {
    if (models) return *models;
    const char* const variable = std::getenv("OPALINE_MODELS");
    return variable != nullptr && *variable != '\0' ? variable : "../shared/models";
  }
};

}  // namespace

void runBench(const Arguments& arguments) {
  CommandLine line("bench",
                   "Measures this machine's device as the paper measured its own: every frame is "
                   "gathered and scattered anew. In [] is the default.");
  BenchCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  if (!command.suite) {
    throw UsageError(fmt::format("bench needs the name of a suite; there is {}", suiteName));
  }
  Table1Order order;
  order.models = command.folder();
  order.device = command.device.value_or("");
  order.frames = command.frames;
  order.log = noteTaker(command.quiet);
  const Table1 table = measureTable1(order);
  printOut(command.json ? toText(toJson(table)) : toReadable(table));
}

}  // namespace opaline::app

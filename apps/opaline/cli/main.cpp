#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/output.h"
#include "opaline/error.h"
#include "opaline/version.h"

namespace {

using namespace opaline::app;

struct Command {
  const char* name;
  const char* summary;
  void (*run)(const Arguments&);
};

constexpr std::array commands{
    Command{"render", "a still as PNG or EXR, or a film; needs no window", runRender},
    Command{"film", "a film of numbered pictures, all of which must be whole", runFilm},
#ifdef OPALINE_WITH_VIEWER
    Command{"view", "a window to change light, medium, motion and method", runView},
#endif
    Command{"compare", "error figures between two images, and a heat map", runCompare},
    Command{"reference", "the same pictures on the CPU, exactly, to judge render", runReference},
    Command{"bench", "times, errors and scaling on this machine's device", runBench},
    Command{"info", "contents of a scene, its repairs and atlas; the devices", runInfo},
    Command{"media", "the media, their coefficients and reflectances", runMedia},
    Command{"profile", "diffuse reflectance of a medium by distance", runProfile},
};

std::string helpText() {
  std::string text =
      "opaline COMMAND [SCENE] [options]\n"
      "Renders deformable translucent objects in real time. SCENE is a .glb, .gltf,\n"
      ".obj, .ply or .toml file; without one it is the built-in bear.\n"
      "Commands:\n";
  for (const Command& command : commands) {
    text += fmt::format("  {:<10}{}\n", command.name, command.summary);
  }
  return text +
         "opaline COMMAND --help lists a command's options; opaline --version.\n"
         "Exit status: 0 done, 2 a mistake in the arguments, 1 anything else.\n";
}

void dispatch(const Arguments& arguments) {
  if (arguments.empty()) {
    throw opaline::UsageError("no command is given; opaline --help lists the commands");
  }
  const std::string& name = arguments[0];
  if (name == "--help" || name == "-h" || name == "help") return printOut(helpText());
  if (name == "--version") return printOut("opaline " OPALINE_VERSION "\n");
  std::vector<std::string> names;
  for (const Command& command : commands) {
    if (name == command.name) return command.run({arguments.begin() + 1, arguments.end()});
    names.emplace_back(command.name);
  }
  throw opaline::UsageError(
      fmt::format("there is no command {}{}", name, suggestion(name, names, "opaline --help")));
}

// After an error, our own files are closed and written. The exit handlers of libraries are skipped,
// since a driver that could not start may crash there. Only sanitizers need them.
int end(int status) {
#ifndef OPALINE_SANITIZED
  std::_Exit(status);
#endif
  return status;
}

int fail(const char* sentence, int status) {
  printError(sentence);
  return end(status);
}

}  // namespace

int main(int count, char** values) {
  guardStandardStreams();
  leaveOnlyWholeFilesWhenInterrupted();
  try {
    dispatch({values + (count > 0 ? 1 : 0), values + count});
    return 0;
  } catch (const ReaderLeft&) {
    return end(1);
  } catch (const opaline::UsageError& error) {
    return fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

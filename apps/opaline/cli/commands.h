#pragma once

#include <string>
#include <vector>

namespace opaline::app {

using Arguments = std::vector<std::string>;

// Each returns once everything that was asked for is on disk or printed, and throws otherwise.
void runRender(const Arguments& arguments);
void runFilm(const Arguments& arguments);
void runView(const Arguments& arguments);
void runCompare(const Arguments& arguments);
void runReference(const Arguments& arguments);
void runBench(const Arguments& arguments);
void runInfo(const Arguments& arguments);
void runMedia(const Arguments& arguments);
void runProfile(const Arguments& arguments);

}  // namespace opaline::app

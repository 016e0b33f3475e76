// How the time and memory of each stage that prepares a scene grow with awkward files: exponents of
// the size, 1 where twice the size takes twice as much.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arguments.h"
#include "growth.h"

namespace opaline::bench {

namespace {

constexpr std::uint32_t small = 1U << 14U;
constexpr std::uint32_t factor = 4;
/// What is as quick as this at the larger size shows nothing by its exponent.
constexpr double noticeableSeconds = 0.2;

void run(int /*count*/, char** /*values*/) {
  double worst = 0;
  fmt::print("{} and {} triangles or nodes{:>14}{:>10}{:>10}{:>10}\n", small, factor * small,
             "seconds", "MB", "time^", "memory^");
  for (const Family& family : families()) {
    const std::vector<Cost> few = costsOf(family, small);
    const std::vector<Cost> many = costsOf(family, factor * small);
    for (std::size_t i = 0; i < many.size(); ++i) {
      const double time = exponent(few[i].seconds, many[i].seconds, factor);
      const double memory = exponent(few[i].peakBytes, many[i].peakBytes, factor);
      if (many[i].seconds > noticeableSeconds) worst = std::max(worst, time);
      fmt::print("{:<14}{:<14}{:>18.3f}{:>10.1f}{:>10.2f}{:>10.2f}\n", family.name, many[i].stage,
                 many[i].seconds, many[i].peakBytes / 1e6, time, memory);
    }
  }
  fmt::print("largest exponent of a time above {} s: {:.2f}\n", noticeableSeconds, worst);
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}

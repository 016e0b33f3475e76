// How the time and memory of each stage of scene preparation grow with awkward files, as exponents
// of the size: 1 where twice the size takes twice as much.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.h"
#include "growth.h"
#include "opaline/error.h"

namespace opaline::bench {

namespace {

constexpr std::uint32_t small = 1U << 14U;
constexpr int doublings = 4;
/// A stage this quick at the largest size is too quick for its exponent to matter.
constexpr double noticeableSeconds = 0.2;

/// One stage of a family at all sizes.
struct Growth {
  const Family* family;
  std::string stage;
  std::vector<double> seconds;
  std::vector<double> peakBytes;
};

std::vector<Growth> growthsOf(const Family& family) {
  std::vector<Growth> growths;
  for (int i = 0; i <= doublings; ++i) {
    const std::vector<Cost> costs = costsOf(family, small << static_cast<unsigned>(i));
    if (i == 0)
      for (const Cost& cost : costs) growths.push_back({&family, cost.stage, {}, {}});
    for (std::size_t stage = 0; stage < costs.size(); ++stage) {
      growths[stage].seconds.push_back(costs[stage].seconds);
      growths[stage].peakBytes.push_back(costs[stage].peakBytes);
    }
  }
  return growths;
}

void print(const std::vector<Growth>& growths) {
  fmt::print("{:<14}{:<10}", "family", "stage");
  for (int i = 0; i <= doublings; ++i) fmt::print("{:>8}", small << static_cast<unsigned>(i));
  fmt::print("{:>8}{:>8}{:>9}\n", "MB", "time^", "memory^");
  double worst = 0;
  for (const Growth& growth : growths) {
    fmt::print("{:<14}{:<10}", growth.family->name, growth.stage);
    for (const double seconds : growth.seconds) fmt::print("{:>8.3f}", seconds);
    const double ofTime = exponent(growth.seconds, 2);
    fmt::print("{:>8.1f}{:>8.2f}{:>9.2f}\n", growth.peakBytes.back() / 1e6, ofTime,
               exponent(growth.peakBytes, 2));
    if (growth.seconds.back() > noticeableSeconds) worst = std::max(worst, ofTime);
  }
  fmt::print("largest exponent of a time above {} s: {:.2f}\n", noticeableSeconds, worst);
}

void printJson(const std::vector<Growth>& growths) {
  nlohmann::json list = nlohmann::json::array();
  for (const Growth& growth : growths) {
    nlohmann::json sizes = nlohmann::json::array();
    for (std::size_t i = 0; i < growth.seconds.size(); ++i) sizes.push_back(small << i);
    list.push_back({{"family", growth.family->name},
                    {"stage", growth.stage},
                    {"sizes", sizes},
                    {"seconds", growth.seconds},
                    {"peak_bytes", growth.peakBytes},
                    {"exponent", exponent(growth.seconds, 2)}});
  }
  fmt::print("{}\n", list.dump(1));
}

void run(int count, char** values) {
  bool json = false;
  std::vector<std::string_view> wanted;
  for (int i = 1; i < count; ++i) {
    if (std::string_view(values[i]) == "--json")
      json = true;
    else
      wanted.emplace_back(values[i]);
  }
  const bool all = wanted.empty();
  std::vector<Growth> growths;
  for (const Family& family : families()) {
    if (!all && std::erase(wanted, family.name) == 0) continue;
    for (Growth& growth : growthsOf(family)) growths.push_back(std::move(growth));
  }
  if (!wanted.empty())
    throw UsageError(fmt::format("usage: opaline_growth_bench [--json] [FAMILY…]; {} is unknown",
                                 wanted.front()));
  json ? printJson(growths) : print(growths);
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}

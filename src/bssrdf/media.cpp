#include "opaline/media.h"

#include <algorithm>
#include <vector>

namespace opaline {

namespace {

// Jensen, Marschner, Levoy, Hanrahan 2001, Figure 5: name, σ_s' and σ_a in mm⁻¹, η, R_d; R G B.
const std::vector<MeasuredMedium>& measuredTable() {
  static const std::vector<MeasuredMedium> table = {
      {{"apple", {2.29, 2.39, 1.97}, {.0030, .0034, .046}, 1.3}, {.85, .84, .53}},
      {{"chicken1", {.15, .21, .38}, {.015, .077, .19}, 1.3}, {.31, .15, .10}},
      {{"chicken2", {.19, .25, .32}, {.018, .088, .20}, 1.3}, {.32, .16, .10}},
      {{"cream", {7.38, 5.47, 3.15}, {.0002, .0028, .0163}, 1.3}, {.98, .90, .73}},
      {{"ketchup", {.18, .07, .03}, {.061, .97, 1.45}, 1.3}, {.16, .01, .00}},
      {{"marble", {2.19, 2.62, 3.00}, {.0021, .0041, .0071}, 1.5}, {.83, .79, .75}},
      {{"potato", {.68, .70, .55}, {.0024, .0090, .12}, 1.3}, {.77, .62, .21}},
      {{"skimmilk", {.70, 1.22, 1.90}, {.0014, .0025, .0142}, 1.3}, {.81, .81, .69}},
      {{"skin1", {.74, .88, 1.01}, {.032, .17, .48}, 1.3}, {.44, .22, .13}},
      {{"skin2", {1.09, 1.59, 1.79}, {.013, .070, .145}, 1.3}, {.63, .44, .34}},
      {{"spectralon", {11.6, 20.4, 14.9}, {0, 0, 0}, 1.3}, {1, 1, 1}},
      {{"wholemilk", {2.55, 3.21, 3.77}, {.0011, .0024, .014}, 1.3}, {.91, .88, .76}},
  };
  return table;
}

// Chosen by eye for bodies of about 50 mm. None of them was measured.
const std::vector<Medium>& artisticTable() {
  static const std::vector<Medium> table = {
      {"gummy-green", {.55, .60, .50}, {.040, .0035, .060}, 1.4},
      {"gummy-orange", {.60, .55, .50}, {.0015, .016, .11}, 1.4},
      {"gummy-red", {.60, .50, .50}, {.0025, .090, .11}, 1.4},
      {"jade", {1.10, 1.30, 1.20}, {.022, .0035, .015}, 1.5},
      {"soap", {1.80, 1.90, 2.00}, {.0010, .0016, .0035}, 1.4},
      {"wax", {1.40, 1.50, 1.60}, {.0012, .0045, .018}, 1.4},
  };
  return table;
}

char lower(char character) {
  return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a')
                                              : character;
}

bool sameIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::span<const MeasuredMedium> measuredMedia() {
  return measuredTable();
}

std::span<const Medium> artisticMedia() {
  return artisticTable();
}

std::optional<Medium> findMedium(std::string_view name) {
  for (const MeasuredMedium& row : measuredTable()) {
    if (sameIgnoringCase(row.medium.name, name)) return row.medium;
  }
  for (const Medium& medium : artisticTable()) {
    if (sameIgnoringCase(medium.name, name)) return medium;
  }
  return std::nullopt;
}

}  // namespace opaline

#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace opaline::test {

/// A row of a table with commas, by the names of its columns.
using Row = std::map<std::string, std::string>;

inline double number(const Row& row, const std::string& column) {
  return std::stod(row.at(column));
}

/// None where the file is not there.
inline std::vector<Row> rowsOf(const std::filesystem::path& csv) {
  std::ifstream file(csv);
  std::vector<Row> rows;
  std::vector<std::string> columns;
  for (std::string line; std::getline(file, line);) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    if (columns.empty()) {
      columns = words;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = words.at(i);
  }
  return rows;
}

}  // namespace opaline::test

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "paper/atlas/pack.h"

namespace opaline::atlas {

/// The cells of a grid that a chart touches, in rows from its lowest; each row as runs.
struct Silhouette {
  struct Run {
    int from;
    int to;  // one past the last
  };
  int width = 0;
  int height = 0;
  std::vector<std::vector<Run>> rows;
  std::size_t pieces = 0;  ///< of the chart's borders, cut by rows
};

/// The silhouette of an outline, rotated and scaled to cells, its box in the corner at the origin;
/// `corner` receives where that corner was. None where the box has no room in a square of `size`
/// cells.
std::optional<Silhouette> silhouetteOf(const Outline& outline, double cosine, double sine,
                                       double cellsPerMm, int size, Point2& corner);

/// A square of cells in which silhouettes find room.
class Bitmap {
 public:
  explicit Bitmap(int size);

  struct Cell {
    int x;
    int y;
  };

  /// The lowest, then leftmost place where a silhouette touches nothing and stays below
  /// `highestTop`, looking from row `lowestRow` up. Adds the words of the bitmap that were read.
  std::optional<Cell> findRoom(const Silhouette& silhouette, int lowestRow, int highestTop,
                               std::size_t& wordsRead) const;

  /// Marks a silhouette and `gutter` cells around it.
  void occupy(const Silhouette& silhouette, Cell cell, int gutter);

 private:
  using Word = std::uint64_t;

  Word* row(std::size_t level, int y);
  const Word* row(std::size_t level, int y) const;
  void orShifted(std::vector<Word>& blocked, const Word* source, int shift) const;
  void refreshLevels(int y);

  int size_;
  std::size_t words_;
  std::size_t levels_;
  /// Bit x of level k: whether any of the 2^k cells from x on is taken.
  std::vector<Word> bits_;
};

}  // namespace opaline::atlas

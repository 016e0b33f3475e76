// Which place of its window of so many places across one is, for windows side by side. The width is a power of two.
#ifndef OPALINE_LIB_WINDOW_CELL
#define OPALINE_LIB_WINDOW_CELL

uint cellOf(ivec2 place, int width) {
  ivec2 cell = place & (width - 1);
  return uint(cell.x + width * cell.y);
}

#endif

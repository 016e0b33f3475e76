#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "opaline/atlas.h"
#include "opaline/error.h"
#include "paper/atlas/texel_row.h"

namespace opaline::atlas {
namespace {

constexpr Rgb ground = {.012F, .014F, .018F};
constexpr Rgb outline = {.9F, .9F, .88F};

/// Hues a golden angle apart, so that neighbours in the numbering differ.
Rgb chartColour(std::uint32_t chart) {
  const double hue = std::fmod(.08 + .61803398875 * chart, 1.0) * 6;
  const double value = .55 + .12 * (chart % 3);
  Rgb colour;
  constexpr std::array<double, 3> phase = {0, 4, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = std::fmod(hue + phase[i], 6.0);
    const double wave = std::clamp(std::fabs(x - 3) - 1, 0.0, 1.0);
    colour[i] = static_cast<float>(value * (.28 + .72 * wave));
  }
  return colour;
}

float shadeOf(std::size_t triangle) {
  const auto hash = static_cast<std::uint32_t>(triangle * 2654435761U) >> 24U;
  return .82F + .18F * static_cast<float>(hash) / 255;
}

void paint(Image& image, int x, int y, const Rgb& colour) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  float* pixel = image.pixel(x, y);
  std::copy(colour.begin(), colour.end(), pixel);
  pixel[3] = 1;
}

std::array<Point2, 3> cornersOf(const Atlas& atlas, std::size_t triangle, int size) {
  std::array<Point2, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& uv = atlas.vertices[atlas.triangles[triangle][i]].uv;
    p[i] = {uv[0] * static_cast<double>(size), uv[1] * static_cast<double>(size)};
  }
  return p;
}

double side(const Point2& a, const Point2& b, double x, double y) {
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

void fill(Image& image, const std::array<Point2, 3>& p, const Rgb& colour) {
  const auto [lowY, highY] = std::minmax({p[0][1], p[1][1], p[2][1]});
  for (int y = static_cast<int>(lowY); y <= static_cast<int>(highY); ++y) {
    const auto [from, to] = texelsInRow(p, y, 0, image.width);
    for (int x = from - 1; x <= to; ++x) {
      const double cx = x + .5;
      const double cy = y + .5;
      if (side(p[0], p[1], cx, cy) >= 0 && side(p[1], p[2], cx, cy) >= 0 &&
          side(p[2], p[0], cx, cy) >= 0) {
        paint(image, x, y, colour);
      }
    }
  }
}

void drawLine(Image& image, const Point2& a, const Point2& b) {
  const double longest = std::max(std::fabs(b[0] - a[0]), std::fabs(b[1] - a[1]));
  const int steps = 1 + static_cast<int>(2 * longest);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    paint(image, static_cast<int>(a[0] + t * (b[0] - a[0])),
          static_cast<int>(a[1] + t * (b[1] - a[1])), outline);
  }
}

struct Edge {
  std::uint32_t low, high;
  std::size_t triangle;
  std::size_t corner;
};

/// Edges that only one triangle has.
std::vector<Edge> borderEdges(const Atlas& atlas) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(atlas.triangles[t][i], atlas.triangles[t][(i + 1) % 3]);
      edges.push_back({low, high, t, i});
    }
  }
  const auto key = [](const Edge& e) { return std::pair(e.low, e.high); };
  std::sort(edges.begin(), edges.end(),
            [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
  std::vector<Edge> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool likeLast = i > 0 && key(edges[i]) == key(edges[i - 1]);
    const bool likeNext = i + 1 < edges.size() && key(edges[i]) == key(edges[i + 1]);
    if (!likeLast && !likeNext) result.push_back(edges[i]);
  }
  return result;
}

Image picture(const Atlas& atlas, int size) {
  Image image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) paint(image, x, y, ground);
  }
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    Rgb colour = chartColour(atlas.chartOfTriangle[t]);
    for (float& c : colour) c *= shadeOf(t);
    fill(image, cornersOf(atlas, t, size), colour);
  }
  for (const Edge& edge : borderEdges(atlas)) {
    const auto p = cornersOf(atlas, edge.triangle, size);
    drawLine(image, p[edge.corner], p[(edge.corner + 1) % 3]);
  }
  return image;
}

}  // namespace
}  // namespace opaline::atlas

namespace opaline {

Image drawAtlas(const Atlas& atlas, int size) {
  if (size < 16 || size > 16384)
    throw UsageError("The picture of an atlas must have an edge of 16 to 16384 pixels.");
  return atlas::picture(atlas, size);
}

}  // namespace opaline

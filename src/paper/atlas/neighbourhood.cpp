#include "paper/atlas/neighbourhood.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <queue>
#include <span>

#include "paper/atlas/texel_row.h"
#include "paper/atlas/topology.h"

namespace opaline::atlas {

namespace {

using Corners2 = std::array<Point2, 3>;

// Smallest reach; below it aprons would not even hold a linear filter.
constexpr int minReach = 2;

struct TexelBox {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

// Twice the signed area.
double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Calls visit(x, y, barycentric) for every texel centre inside a triangle and the box.
template <typename Visit>
void rasterise(const Corners2& corner, const TexelBox& box, const Visit& visit) {
  const double whole = area2(corner[0], corner[1], corner[2]);
  if (!(std::abs(whole) > 1e-12)) return;
  const auto [lowY, highY] = std::minmax({corner[0][1], corner[1][1], corner[2][1]});
  const int first = static_cast<int>(std::ceil(std::max(lowY - 0.5, static_cast<double>(box.top))));
  const int last = static_cast<int>(
      std::floor(std::min(highY - 0.5, static_cast<double>(box.top + box.height - 1))));
  const int right = box.left + box.width;
  for (int y = first; y <= last; ++y) {
    const auto [from, to] = texelsInRow(corner, y, box.left, right);
    for (int x = std::max(from - 1, box.left); x < std::min(to + 1, right); ++x) {
      const Point2 centre{x + 0.5, y + 0.5};
      const std::array<double, 3> b{area2(corner[1], corner[2], centre) / whole,
                                    area2(corner[2], corner[0], centre) / whole,
                                    area2(corner[0], corner[1], centre) / whole};
      if (b[0] >= 0 && b[1] >= 0 && b[2] >= 0) visit(x, y, b);
    }
  }
}

// Corners of a triangle in the atlas, in texels.
Corners2 atlasCorners(const Atlas& atlas, std::uint32_t triangle, int mapSize) {
  Corners2 corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& uv = atlas.vertices[atlas.triangles[triangle][i]].uv;
    corners[i] = {static_cast<double>(uv[0]) * mapSize, static_cast<double>(uv[1]) * mapSize};
  }
  return corners;
}

// The triangles of each chart, as one list with a start for each chart.
struct ChartLists {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> triangles;

  explicit ChartLists(const std::vector<std::uint32_t>& chartOfTriangle) {
    std::uint32_t charts = 0;
    for (const std::uint32_t chart : chartOfTriangle) charts = std::max(charts, chart + 1);
    start.assign(charts + 1, 0);
    for (const std::uint32_t chart : chartOfTriangle) ++start[chart + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    triangles.resize(chartOfTriangle.size());
    for (std::uint32_t t = 0; t < chartOfTriangle.size(); ++t)
      triangles[next[chartOfTriangle[t]]++] = t;
  }

  std::size_t count() const { return start.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t chart) const {
    return std::span(triangles).subspan(start[chart], start[chart + 1] - start[chart]);
  }
};

TexelBox boxOfChart(const Atlas& atlas, std::span<const std::uint32_t> triangles, int mapSize) {
  Point2 low{1e30, 1e30};
  Point2 high{-1e30, -1e30};
  for (const std::uint32_t triangle : triangles)
    for (const Point2& corner : atlasCorners(atlas, triangle, mapSize))
      for (std::size_t i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], corner[i]);
        high[i] = std::max(high[i], corner[i]);
      }
  const int left = static_cast<int>(std::floor(low[0]));
  const int top = static_cast<int>(std::floor(low[1]));
  return {left, top, static_cast<int>(std::ceil(high[0])) - left,
          static_cast<int>(std::ceil(high[1])) - top};
}

int roundedUp(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

// Where the tiles lie: shelves of falling height in a square.
struct BoxLayout {
  int size = 0;
  std::vector<TexelBox> tiles;
};

BoxLayout layOutBoxes(const std::vector<TexelBox>& charts, int reach, int alignment) {
  BoxLayout layout;
  double area = 0;
  int widest = 0;
  for (const TexelBox& chart : charts) {
    layout.tiles.push_back({0, 0, roundedUp(chart.width + 2 * reach, alignment),
                            roundedUp(chart.height + 2 * reach, alignment)});
    area += static_cast<double>(layout.tiles.back().width) * layout.tiles.back().height;
    widest = std::max(widest, layout.tiles.back().width);
  }
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return layout.tiles[a].height > layout.tiles[b].height;
  });

  const int width =
      roundedUp(std::max(widest, static_cast<int>(std::ceil(std::sqrt(area * 1.05)))), alignment);
  int x = 0;
  int shelf = 0;
  int next = 0;
  for (const std::size_t i : order) {
    TexelBox& tile = layout.tiles[i];
    if (x + tile.width > width) {
      x = 0;
      shelf = next;
    }
    tile.left = x;
    tile.top = shelf;
    x += tile.width;
    next = std::max(next, shelf + tile.height);
  }
  layout.size = std::max(width, next);
  return layout;
}

// Draws a chart and what lies around it into its tile.
class TilePainter {
 public:
  TilePainter(const Topology& topology, const Atlas& atlas, int mapSize, Neighbourhoods& result)
      : topology_(topology),
        atlas_(atlas),
        mapSize_(mapSize),
        result_(result),
        visitedBy_(topology.triangles.size(), none) {}

  void paint(std::uint32_t chart, std::span<const std::uint32_t> triangles, const TexelBox& tile) {
    chart_ = chart;
    tile_ = tile;
    const std::array<int, 2> shift = result_.shiftOfChart[chart];
    for (const std::uint32_t triangle : triangles) {
      Corners2 corners = atlasCorners(atlas_, triangle, mapSize_);
      for (Point2& corner : corners) corner = {corner[0] + shift[0], corner[1] + shift[1]};
      draw(triangle, corners);
      for (std::size_t edge = 0; edge < 3; ++edge)
        if (isSeam(triangle, edge)) cross(triangle, edge, corners, 0);
    }
    unfold();
  }

 private:
  struct Unfolded {
    double distance;  // from the chart's border, texels
    std::uint32_t triangle;
    Corners2 corners;

    // Ties are broken by index, so that the order is the same everywhere.
    bool operator<(const Unfolded& other) const {
      return distance != other.distance ? distance > other.distance : triangle > other.triangle;
    }
  };

  void draw(std::uint32_t triangle, const Corners2& corners) {
    const Corners2 home = atlasCorners(atlas_, triangle, mapSize_);
    rasterise(corners, tile_, [&](int x, int y, const std::array<double, 3>& b) {
      std::uint32_t& texel =
          result_.source[static_cast<std::size_t>(y) * static_cast<std::size_t>(result_.size) +
                         static_cast<std::size_t>(x)];
      if (texel != Neighbourhoods::nothing) return;
      const auto at = [&](std::size_t axis) {
        const double place = b[0] * home[0][axis] + b[1] * home[1][axis] + b[2] * home[2][axis];
        return static_cast<std::uint32_t>(std::clamp(static_cast<int>(place), 0, mapSize_ - 1));
      };
      texel = at(1) * static_cast<std::uint32_t>(mapSize_) + at(0);
    });
  }

  // Whether the atlas is cut along an edge. Charts may be cut along themselves.
  bool isSeam(std::uint32_t triangle, std::size_t edge) const {
    const std::uint32_t next = topology_.neighbours[triangle][edge];
    if (next == none || atlas_.chartOfTriangle[next] != chart_) return true;
    const Triangle& a = atlas_.triangles[triangle];
    const Triangle& b = atlas_.triangles[next];
    const auto holds = [&](std::uint32_t corner) {
      return std::find(b.begin(), b.end(), corner) != b.end();
    };
    return !holds(a[edge]) || !holds(a[(edge + 1) % 3]);
  }

  // Puts the neighbour across an edge into the queue, laid out in the plane.
  void cross(std::uint32_t triangle, std::size_t edge, const Corners2& corners, double distance) {
    const std::uint32_t next = topology_.neighbours[triangle][edge];
    if (next == none || visitedBy_[next] == chart_) return;
    const Point2& a = corners[edge];
    const Point2& b = corners[(edge + 1) % 3];
    const Corners2 placed = placeBeside(next, topology_.triangles[triangle][edge], a, b);
    const double step =
        std::hypot((placed[0][0] + placed[1][0] + placed[2][0]) / 3 - 0.5 * (a[0] + b[0]),
                   (placed[0][1] + placed[1][1] + placed[2][1]) / 3 - 0.5 * (a[1] + b[1]));
    queue_.push({distance + step, next, placed});
  }

  // Goes on from a triangle of the apron. Other charts do not lead back into the one in the middle.
  void crossEdges(const Unfolded& from) {
    const bool mayEnter = atlas_.chartOfTriangle[from.triangle] == chart_;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t next = topology_.neighbours[from.triangle][edge];
      if (next == none || (!mayEnter && atlas_.chartOfTriangle[next] == chart_)) continue;
      cross(from.triangle, edge, from.corners, from.distance);
    }
  }

  // Lays out the triangle with the shape it has in space, beside an edge. The edge's corner `from`
  // lies at a; its other corner, at b, comes before `from` in the triangle.
  Corners2 placeBeside(std::uint32_t triangle, std::uint32_t from, const Point2& a,
                       const Point2& b) const {
    const Triangle& index = topology_.triangles[triangle];
    std::size_t i = 0;
    while (i < 2 && index[i] != from) ++i;
    const std::size_t before = (i + 2) % 3;
    const std::size_t opposite = (i + 1) % 3;
    const Point3& p = topology_.positions[index[i]];
    const Point3 along = subtract(topology_.positions[index[before]], p);
    const Point3 aside = subtract(topology_.positions[index[opposite]], p);
    const double squared = dot(along, along);
    const double u = squared > 0 ? dot(aside, along) / squared : 0;
    const double v = squared > 0 ? length(atlas::cross(along, aside)) / squared : 0;
    const Point2 edge{b[0] - a[0], b[1] - a[1]};
    // The triangle that was left lies on the left of a → b, so this one lies on the right.
    Corners2 corners{};
    corners[i] = a;
    corners[before] = b;
    corners[opposite] = {a[0] + u * edge[0] + v * edge[1], a[1] + u * edge[1] - v * edge[0]};
    return corners;
  }

  bool touchesTile(const Corners2& c) const {
    const auto [lowX, highX] = std::minmax({c[0][0], c[1][0], c[2][0]});
    const auto [lowY, highY] = std::minmax({c[0][1], c[1][1], c[2][1]});
    return highX > tile_.left && lowX < tile_.left + tile_.width && highY > tile_.top &&
           lowY < tile_.top + tile_.height;
  }

  void unfold() {
    const double limit = 2.0 * result_.reach;
    while (!queue_.empty()) {
      const Unfolded next = queue_.top();
      queue_.pop();
      if (visitedBy_[next.triangle] == chart_ || next.distance > limit) continue;
      if (!touchesTile(next.corners)) continue;
      visitedBy_[next.triangle] = chart_;
      draw(next.triangle, next.corners);
      crossEdges(next);
    }
  }

  const Topology& topology_;
  const Atlas& atlas_;
  int mapSize_;
  Neighbourhoods& result_;
  std::vector<std::uint32_t> visitedBy_;  // the last chart that each triangle was drawn for
  std::priority_queue<Unfolded> queue_;
  std::uint32_t chart_ = 0;
  TexelBox tile_;
};

}  // namespace

Neighbourhoods makeNeighbourhoods(const core::RestSurface& surface, const Atlas& atlas,
                                  const NeighbourhoodOptions& options) {
  assert(options.reach > 0 && options.alignment > 0);
  const ChartLists charts(atlas.chartOfTriangle);
  std::vector<TexelBox> boxes;
  for (std::size_t chart = 0; chart < charts.count(); ++chart)
    boxes.push_back(boxOfChart(atlas, charts.of(chart), options.mapSize));

  Neighbourhoods result;
  result.reach = std::max(options.reach, minReach);
  BoxLayout layout = layOutBoxes(boxes, result.reach, options.alignment);
  while (layout.size > options.maxSize && result.reach > minReach) {
    result.reach = std::max(minReach, result.reach * 4 / 5);
    layout = layOutBoxes(boxes, result.reach, options.alignment);
  }
  result.size = roundedUp(std::max(layout.size, 1), options.alignment);
  for (std::size_t chart = 0; chart < boxes.size(); ++chart)
    result.shiftOfChart.push_back({layout.tiles[chart].left + result.reach - boxes[chart].left,
                                   layout.tiles[chart].top + result.reach - boxes[chart].top});

  result.source.assign(
      static_cast<std::size_t>(result.size) * static_cast<std::size_t>(result.size),
      Neighbourhoods::nothing);
  const Topology topology = makeTopology(surface);
  TilePainter painter(topology, atlas, options.mapSize, result);
  for (std::uint32_t chart = 0; chart < charts.count(); ++chart)
    painter.paint(chart, charts.of(chart), layout.tiles[chart]);
  return result;
}

}  // namespace opaline::atlas

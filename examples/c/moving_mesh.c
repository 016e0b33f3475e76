// A moving mesh of your own in C: a sheet of wax, 4 mm thick, with running waves.
//
//     moving_mesh [frames [picture.png]]
#include <math.h>
#include <opaline/opaline_c.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  edge = 48,  // vertices along an edge
  vertexCount = 2 * edge * edge,
  triangleCount = 4 * (edge - 1) * (edge - 1) + 8 * (edge - 1),
  size = 256
};

// An engine's vertex: positions need not be contiguous.
typedef struct Vertex {
  float position[3];
  float whatever[3];
} Vertex;

static void check(OpalineStatus status) {
  if (status == OpalineOk) return;
  fprintf(stderr, "%s\n", opalineLastError());
  exit(1);
}

// Fills the upper side, then the lower one.
static void moveTo(double seconds, Vertex* vertices) {
  for (int side = 0; side < 2; ++side) {
    for (int y = 0; y < edge; ++y) {
      for (int x = 0; x < edge; ++x, ++vertices) {
        const double u = 40.0 * x / (edge - 1) - 20;
        const double v = 40.0 * y / (edge - 1) - 20;
        vertices->position[0] = (float)u;
        vertices->position[1] = (float)(2 * sin(0.3 * sqrt(u * u + v * v) - 6 * seconds) + (side == 0 ? 2 : -2));
        vertices->position[2] = (float)v;
      }
    }
  }
}

static uint32_t at(int side, int x, int y) {
  return (uint32_t)(side * edge * edge + y * edge + x);
}

static uint32_t* quad(uint32_t* to, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  const uint32_t corners[6] = {a, b, c, a, c, d};
  for (int i = 0; i < 6; ++i) to[i] = corners[i];
  return to + 6;
}

// Counter-clockwise seen from outside. The sheet is closed, so it has an inside.
static void makeTriangles(uint32_t* to) {
  const int last = edge - 1;
  for (int y = 0; y < last; ++y) {
    for (int x = 0; x < last; ++x) {
      to = quad(to, at(0, x, y), at(0, x, y + 1), at(0, x + 1, y + 1), at(0, x + 1, y));
      to = quad(to, at(1, x, y), at(1, x + 1, y), at(1, x + 1, y + 1), at(1, x, y + 1));
    }
  }
  for (int i = 0; i < last; ++i) {
    to = quad(to, at(0, i + 1, 0), at(1, i + 1, 0), at(1, i, 0), at(0, i, 0));
    to = quad(to, at(0, i, last), at(1, i, last), at(1, i + 1, last), at(0, i + 1, last));
    to = quad(to, at(0, 0, i), at(1, 0, i), at(1, 0, i + 1), at(0, 0, i + 1));
    to = quad(to, at(0, last, i + 1), at(1, last, i + 1), at(1, last, i), at(0, last, i));
  }
}

int main(int count, char** words) {
  const int frames = count > 1 ? atoi(words[1]) : 60;
  static Vertex vertices[vertexCount];
  static uint32_t triangles[3 * triangleCount];
  static float rgba[4 * size * size];
  moveTo(0, vertices);
  makeTriangles(triangles);

  OpalineMedium wax = {.size = sizeof wax};
  check(opalineFindMedium("wax", &wax));
  OpalineObject sheet = {.size = sizeof sheet};
  sheet.name = "sheet";
  sheet.positionsMm = vertices[0].position;
  sheet.positionStrideBytes = sizeof(Vertex);
  sheet.vertexCount = vertexCount;
  sheet.triangles = triangles;
  sheet.triangleCount = triangleCount;
  sheet.medium = &wax;

  OpalineScene* scene = NULL;
  check(opalineCreateScene(&scene));
  check(opalineAddObject(scene, &sheet, NULL));
  check(opalineUseDefaultLights(scene));
  OpalineCamera camera = {.size = sizeof camera};
  const float fromAbove[3] = {0, 0.8F, 1};
  check(opalineDefaultCamera(scene, fromAbove, 42, &camera));
  check(opalineSetSceneCamera(scene, &camera));

  OpalineRenderer* renderer = NULL;
  check(opalineCreateRenderer(NULL, &renderer));
  check(opalineSetScene(renderer, scene));
  OpalineRenderOptions options = {.size = sizeof options};
  check(opalineDefaultRenderOptions(&options));
  options.width = options.height = size;
  OpalineView* view = NULL;
  check(opalineCreateView(renderer, &options, &view));

  const OpalineAov radiance = OpalineAovRadiance;
  const OpalineTarget target = {sizeof target, OpalineAovRadiance, rgba, 4 * size * size};
  double all = 0;
  for (int i = 0; i <= frames; ++i) {
    double milliseconds = 0;
    if (i < frames) {
      moveTo(i / 60.0, vertices);
      check(opalineSetPositions(renderer, 0, vertices[0].position, vertexCount, sizeof(Vertex)));
      check(opalineSubmit(view, &radiance, 1));  // returns while the device works
    }
    if (i > 0) check(opalineCollect(view, &target, 1, &milliseconds));  // the previous frame
    all += milliseconds;
  }
  if (frames > 0) {
    check(opalineWritePng(count > 2 ? words[2] : "moving_mesh.png", rgba, size, size, NULL));
    printf("%d frames, %.2f ms each on the device\n", frames, all / frames);
  }

  opalineDestroyView(view);
  opalineDestroyRenderer(renderer);
  opalineDestroyScene(scene);
  return 0;
}

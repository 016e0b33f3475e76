// Usage: draw_c SCENE SECONDS auto|fragment RADIANCE.exr EXITANCE.exr

#include <opaline/opaline_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { width = 96, height = 64, floats = 4 * width * height };

static void check(OpalineStatus status) {
  if (status == OpalineOk) return;
  fprintf(stderr, "draw: %s\n", opalineLastError());
  exit(1);
}

int main(int count, char** values) {
  if (count != 6) return 2;
  OpalineScene* scene = NULL;
  OpalineRenderer* renderer = NULL;
  OpalineView* view = NULL;
  OpalineRenderOptions options = {.size = sizeof options};
  check(opalineLoadScene(values[1], NULL, &scene));
  check(opalineCreateRenderer(NULL, &renderer));
  check(opalineSetScene(renderer, scene));
  opalineDestroyScene(scene);
  check(opalineSetTime(renderer, atof(values[2]), 0));
  check(opalineDefaultRenderOptions(&options));
  options.width = width;
  options.height = height;
  options.maxSurfels = 8192;
  options.maxClusters = 1024;
  if (strcmp(values[3], "fragment") == 0) options.site = OpalineSiteFragment;
  check(opalineCreateView(renderer, &options, &view));
  float* pictures = malloc(2 * floats * sizeof(float));
  if (!pictures) return 1;
  const OpalineTarget targets[] = {
      {sizeof(OpalineTarget), OpalineAovRadiance, pictures, floats},
      {sizeof(OpalineTarget), OpalineAovExitance, pictures + floats, floats}};
  check(opalineRender(view, targets, 2));
  for (int i = 0; i < 2; ++i)
    check(opalineWriteExr(values[4 + i], pictures + (size_t)i * floats, width, height));
  free(pictures);
  opalineDestroyView(view);
  opalineDestroyRenderer(renderer);
  return 0;
}

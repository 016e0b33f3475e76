// A still in C: the built-in bear of jade, lit from behind, as a picture and as numbers.
//
//     still [picture.png [radiance.exr [exitance.exr]]]
#include <opaline/opaline_c.h>
#include <stdio.h>
#include <stdlib.h>

enum { width = 320, height = 320 };

// Every call returns a status. The reason for a failure is one sentence.
static void check(OpalineStatus status) {
  if (status == OpalineOk) return;
  fprintf(stderr, "%s\n", opalineLastError());
  exit(1);
}

static void show(void* context, OpalineLogLevel level, const char* message) {
  (void)context;
  (void)level;
  printf("note: %s\n", message);
}

static OpalineScene* makeScene(void) {
  OpalineMedium jade = {.size = sizeof jade};  // every struct begins with its size
  check(opalineFindMedium("jade", &jade));

  OpalineLoadOptions load = {.size = sizeof load};
  load.diagonalMm = 50;
  load.medium = &jade;
  OpalineScene* scene = NULL;
  check(opalineCreateBear(&load, &scene));  // or opalineLoadScene("file.glb", &load, &scene)

  const float fromBehind[3] = {0.6F, 0, -0.8F};
  const float bright[3] = {6, 6, 5};
  const float fromAbove[3] = {0, 1, 0};
  const float weak[3] = {0.5F, 0.5F, 0.6F};
  const float ambient[3] = {0.05F, 0.05F, 0.05F};
  check(opalineClearLights(scene));
  check(opalineAddDirectionalLight(scene, fromBehind, bright));
  check(opalineAddDirectionalLight(scene, fromAbove, weak));
  check(opalineSetAmbientLight(scene, ambient));
  return scene;
}

int main(int count, char** words) {
  const char* const pictureFile = count > 1 ? words[1] : "still.png";
  const char* const radianceFile = count > 2 ? words[2] : "still.exr";
  const char* const exitanceFile = count > 3 ? words[3] : "still_exitance.exr";

  OpalineRendererOptions device = {.size = sizeof device};
  check(opalineDefaultRendererOptions(&device));
  device.log = show;
  OpalineRenderer* renderer = NULL;
  check(opalineCreateRenderer(&device, &renderer));

  OpalineScene* scene = makeScene();
  check(opalineSetScene(renderer, scene));

  OpalineRenderOptions options = {.size = sizeof options};
  check(opalineDefaultRenderOptions(&options));
  options.width = width;
  options.height = height;
  OpalineView* view = NULL;
  check(opalineCreateView(renderer, &options, &view));

  static float radiance[4 * width * height];
  static float exitance[4 * width * height];
  const OpalineTarget targets[] = {
      {sizeof(OpalineTarget), OpalineAovRadiance, radiance, 4 * width * height},
      {sizeof(OpalineTarget), OpalineAovExitance, exitance, 4 * width * height},
  };
  check(opalineRender(view, targets, 2));

  // A picture to look at needs an exposure and a tone curve.
  OpalineTone tone = {.size = sizeof tone};
  check(opalineDefaultTone(&tone));
  check(opalineAutomaticExposure(scene, &tone.exposureStops));
  const float background[3] = {0.02F, 0.02F, 0.02F};
  tone.background = background;
  check(opalineWritePng(pictureFile, radiance, width, height, &tone));
  check(opalineWriteExr(radianceFile, radiance, width, height));
  check(opalineWriteExr(exitanceFile, exitance, width, height));

  const float* const middle = exitance + 4 * (width * (height / 2) + width / 2);
  printf("exitance in the middle: %g %g %g\n", middle[0], middle[1], middle[2]);

  opalineDestroyScene(scene);
  opalineDestroyView(view);  // before its renderer
  opalineDestroyRenderer(renderer);
  return 0;
}

#pragma once

/// Renderers and views in C; part of opaline/opaline_c.h.

#include "opaline/c/log.h"
#include "opaline/c/media.h"
#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

struct OpalineGivenVulkan;

/// A device with one scene at a time.
typedef struct OpalineRenderer OpalineRenderer;

/// How many Vulkan devices this machine has.
OPALINE_API OpalineStatus opalineDeviceCount(size_t* count);
/// The name of a device, truncated if it has no room.
OPALINE_API OpalineStatus opalineDeviceName(size_t device, char* name, size_t nameBytes);

/// Which device a renderer uses, and how.
typedef struct OpalineRendererOptions {
  size_t size;         ///< sizeof(OpalineRendererOptions)
  const char* device;  ///< index or part of a name; NULL: the best there is
  int32_t validation;  ///< 1: run Vulkan's validation layer
  int32_t
      rayQueries;    ///< 1: with; 0: without; -1: with, if the device has them and is not software
  OpalineLog log;    ///< may be NULL
  void* logContext;  ///< for the log
  float memoryLimitMegabytes;  ///< limit on device memory, in [64, 1e7]; 0: all that there is
  const struct OpalineGivenVulkan* given;  ///< a device of the caller's; NULL: none
  const void* pipelineCache;               ///< what opalinePipelineCache gave in an earlier run
  size_t pipelineCacheBytes;               ///< 0 without one
  const char* const* instanceExtensions;   ///< Vulkan extensions that the caller needs, as for
                                           ///< windows
  size_t instanceExtensionCount;
  const char* const* deviceExtensions;  ///< the same
  size_t deviceExtensionCount;
} OpalineRendererOptions;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultRendererOptions(OpalineRendererOptions* options);

/// `options` may be NULL.
OPALINE_API OpalineStatus opalineCreateRenderer(const OpalineRendererOptions* options,
                                                OpalineRenderer** renderer);
/// Also destroys the renderer's remaining views and soft bodies.
OPALINE_API void opalineDestroyRenderer(OpalineRenderer* renderer);

/// Bytes of the device's memory that the renderer and its views occupy now.
OPALINE_API OpalineStatus opalineMemoryInUse(const OpalineRenderer* renderer, uint64_t* bytes);

/// Messages of the validation layer so far; 0 without `validation`.
OPALINE_API OpalineStatus opalineValidationMessages(const OpalineRenderer* renderer,
                                                    uint64_t* count);

/// Copies the pipelines that were compiled so far to `data`, which has room for `*bytes`, and sets
/// `*bytes` to their size. If `data` is NULL, only sets `*bytes`.
OPALINE_API OpalineStatus opalinePipelineCache(const OpalineRenderer* renderer, void* data,
                                               size_t* bytes);

/// Copies what it needs of the scene, which may be changed or destroyed afterwards.
OPALINE_API OpalineStatus opalineSetScene(OpalineRenderer* renderer, const OpalineScene* scene);

/// Edits of what is rendered, from the next frame on. Each remakes only what depends on it.
OPALINE_API OpalineStatus opalineSetTime(OpalineRenderer* renderer, double seconds, int32_t clip);
OPALINE_API OpalineStatus opalineSetCamera(OpalineRenderer* renderer, const OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSetMedium(OpalineRenderer* renderer, size_t object,
                                           const OpalineMedium* medium);
/// Takes over what the object of that index in `scene` is made of: medium, paint and surface, or
/// opaque material. An opaque object has to stay opaque and a translucent one translucent.
OPALINE_API OpalineStatus opalineSetMaterial(OpalineRenderer* renderer, size_t object,
                                             const OpalineScene* scene);
/// Replace all lights, or all deformers, by those of `scene`.
OPALINE_API OpalineStatus opalineSetLights(OpalineRenderer* renderer, const OpalineScene* scene);
OPALINE_API OpalineStatus opalineSetDeformers(OpalineRenderer* renderer, const OpalineScene* scene);

/// New positions of an object's vertices in their order: three floats each, which are copied.
/// Normals follow. `strideBytes` is the distance from one position to the next; 0: 12.
OPALINE_API OpalineStatus opalineSetPositions(OpalineRenderer* renderer, size_t object,
                                              const float* positionsMm, size_t vertexCount,
                                              size_t strideBytes);
/// Undoes opalineSetPositions.
OPALINE_API OpalineStatus opalineRestorePositions(OpalineRenderer* renderer, size_t object);

/// How light travels in bodies; see Transport in opaline/render_options.h.
typedef enum OpalineTransport {
  OpalineTransportDipole = 0,
  OpalineTransportBetterDipole = 1,
  OpalineTransportBoundary = 2
} OpalineTransport;

/// The sources of the sum; see Sum there.
typedef enum OpalineSum { OpalineSumPattern = 0, OpalineSumTree = 1, OpalineSumAll = 2 } OpalineSum;

/// Where the sum is evaluated; see Site there.
typedef enum OpalineSite {
  OpalineSiteAuto = 0,
  OpalineSiteVertex = 1,
  OpalineSiteFragment = 2
} OpalineSite;

/// What a picture shows; see Aov in opaline/render_options.h.
typedef enum OpalineAov {
  OpalineAovRadiance = 0,
  OpalineAovExitance = 1,
  OpalineAovIrradiance = 2,
  OpalineAovPosition = 3,
  OpalineAovNormal = 4,
  OpalineAovDepth = 5,
  OpalineAovEvaluations = 6,
  OpalineAovObject = 7,
  OpalineAovSurfels = 8,
  // The diffusion source map, which OpalineSumPattern makes.
  OpalineAovDsmPosition = 9,
  OpalineAovDsmNormal = 10,
  OpalineAovDsmIrradiance = 11,
  OpalineAovDsmArea = 12
} OpalineAov;

/// Options of OpalineSumPattern and its map alone; see PatternOptions and `dsmSize` there.
typedef struct OpalinePattern {
  size_t size;  ///< sizeof(OpalinePattern)
  int32_t nearRings;
  float nearSpacing;
  float farDistance;
  int32_t dsmSize;  ///< edge of the map, texels
} OpalinePattern;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultPattern(OpalinePattern* pattern);

/// How a picture is made; see RenderOptions in opaline/render_options.h for ranges and defaults.
typedef struct OpalineRenderOptions {
  size_t size;  ///< sizeof(OpalineRenderOptions)
  int32_t width;
  int32_t height;
  OpalineTransport transport;
  OpalineSum sum;
  OpalineSite site;
  float tolerance;
  int32_t maxSurfels;
  int32_t maxClusters;
  int32_t bounces;
  int32_t ambientOcclusion;  ///< 1 or 0
  int32_t shadowSize;
  int32_t specular;  ///< 1 or 0
  float roughness;
  int32_t antialias;
  int32_t environmentBehind;      ///< 1 or 0
  const OpalinePattern* pattern;  ///< NULL: as opalineDefaultPattern() has it
  int32_t treeLevel;              ///< of OpalineAovSurfels
} OpalineRenderOptions;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultRenderOptions(OpalineRenderOptions* options);

/// A picture that is made again and again. It keeps its images, so that frames allocate nothing.
typedef struct OpalineView OpalineView;

/// `options` may be NULL. Destroying the renderer destroys the view, too.
OPALINE_API OpalineStatus opalineCreateView(OpalineRenderer* renderer,
                                            const OpalineRenderOptions* options,
                                            OpalineView** view);
OPALINE_API void opalineDestroyView(OpalineView* view);

/// Takes effect with the next frame. Another size makes new images.
OPALINE_API OpalineStatus opalineSetViewOptions(OpalineView* view,
                                                const OpalineRenderOptions* options);
/// NULL returns to the scene's camera.
OPALINE_API OpalineStatus opalineSetViewCamera(OpalineView* view, const OpalineCamera* camera);

/// The camera of a program that also draws by itself; see CameraMatrices in opaline/view.h.
typedef struct OpalineCameraMatrices {
  size_t size;            ///< sizeof(OpalineCameraMatrices)
  float worldToView[16];  ///< from millimetres, in column-major order
  float viewToClip[16];   ///< to Vulkan's clip space
  float jitterPixels[2];  ///< to the right and down, unless viewToClip contains it
} OpalineCameraMatrices;

/// Replaces the camera until opalineSetViewCamera().
OPALINE_API OpalineStatus opalineSetViewMatrices(OpalineView* view,
                                                 const OpalineCameraMatrices* matrices);

/// Where a variable of a frame goes: linear R G B A, rows from top to bottom, A is coverage.
typedef struct OpalineTarget {
  size_t size;  ///< sizeof(OpalineTarget)
  OpalineAov aov;
  float* rgba;        ///< 4 · width · height floats; of the map 4 · dsmSize²
  size_t floatCount;  ///< how many floats `rgba` has room for, at least that many
} OpalineTarget;

/// Renders one frame and waits for it.
OPALINE_API OpalineStatus opalineRender(OpalineView* view, const OpalineTarget* targets,
                                        size_t targetCount);

/// Submits one frame with the variables that opalineCollect() is to return, and returns while the
/// device works. At most two frames wait to be collected.
OPALINE_API OpalineStatus opalineSubmit(OpalineView* view, const OpalineAov* aovs, size_t aovCount);

/// What a frame is to deliver, and how; see FrameOrder in opaline/view.h.
typedef struct OpalineFrameOrder {
  size_t size;             ///< sizeof(OpalineFrameOrder)
  const OpalineAov* aovs;  ///< for opalineCollect()
  size_t aovCount;
  int32_t reuseLight;  ///< 1: reuse what has not changed; see FrameOrder::reuseLight in view.h
  int32_t impatient;   ///< 1: do not wait for new surfels after a change of media
} OpalineFrameOrder;

/// Like opalineSubmit(), with more options.
OPALINE_API OpalineStatus opalineSubmitOrder(OpalineView* view, const OpalineFrameOrder* order);

/// Waits for the oldest submitted frame and copies its variables, in the order in which they were
/// requested. If the targets are for other variables or too small, the next call returns the same
/// frame again. A frame without variables has no targets. `milliseconds` is the device's time and
/// may be NULL; opaline/c/reports.h has more.
OPALINE_API OpalineStatus opalineCollect(OpalineView* view, const OpalineTarget* targets,
                                         size_t targetCount, double* milliseconds);

OPALINE_C_END

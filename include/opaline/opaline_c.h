#pragma once

/// The C interface, C11. Handles are opaque, no exception leaves a call, and structs keep their
/// layout: a struct begins with its own size, so that later versions can add members at its end.
///
/// Fill a struct that has defaults in this way, and then change what you like:
///
///     OpalineRenderOptions options = {.size = sizeof options};
///     opalineDefaultRenderOptions(&options);
///
/// Every call that can fail returns a status; opalineLastError() has the reason. A handle is made
/// by one call and destroyed by another, which takes NULL too. Unless said otherwise pointers are
/// needed only during the call, texts are UTF-8 and end with a zero byte, and lengths are
/// millimetres. Calls with different renderers may come from different threads; those with one
/// renderer, or a view of it, come from one thread at a time, as do those with one scene.

#include <stddef.h>
#include <stdint.h>

#include "opaline/export.h"
#include "opaline/version.h"

/// Grows when the layout of a struct or the meaning of a call changes, so that programs that were
/// compiled before no longer fit.
#define OPALINE_C_ABI 2

#ifdef __cplusplus
extern "C" {
#endif

struct OpalineGivenVulkan;

/// What a call came to.
typedef enum OpalineStatus {
  OpalineOk = 0,
  OpalineFailed = 1,    ///< bad input, a file that cannot be read or written, a failed device
  OpalineBadUse = 2,    ///< an unknown name, a value out of range, a null pointer, a wrong size
  OpalineNoMemory = 3,  ///< the host has too little memory
  OpalineDefect = 4     ///< an error in the library itself
} OpalineStatus;

/// Why the last call of this thread that failed did so: one sentence for the user, empty before the
/// first. Lives until the thread's next failure.
OPALINE_API const char* opalineLastError(void);

/// Of the library at hand, which may be newer than these headers. `abi` is its OPALINE_C_ABI. Any
/// of them may be NULL.
OPALINE_API void opalineVersion(int32_t* major, int32_t* minor, int32_t* patch, int32_t* abi);

/* ------------------------------------------------------------------------------------- media */

/// What a body is made of; see opaline/medium.h.
typedef struct OpalineMedium {
  size_t size;                 ///< sizeof(OpalineMedium)
  double sigmaSPrimePerMm[3];  ///< reduced scattering, mm⁻¹, in (0, 1e6]
  double sigmaAPerMm[3];       ///< absorption, mm⁻¹, in [0, 1e6]
  double eta;                  ///< relative index of refraction, in [1.01, 3]
  double g;                    ///< mean cosine of scattering, in [-0.99, 0.99]
} OpalineMedium;

/// A medium by its name, such as "marble", in any case.
OPALINE_API OpalineStatus opalineFindMedium(const char* name, OpalineMedium* medium);

/// How many media have names, and their names. NULL beyond the last; others live for ever.
OPALINE_API size_t opalineMediumCount(void);
OPALINE_API const char* opalineMediumName(size_t index);

/// The medium that looks like this from outside: colour in even light in [0, 1], mean free path in
/// mm, mean cosine of scattering g in [-0.99, 0.99], index of refraction in [1.01, 1.6].
OPALINE_API OpalineStatus opalineMediumOfAppearance(const double color[3],
                                                    const double meanFreePathMm[3], double g,
                                                    double eta, OpalineMedium* medium);

/* ------------------------------------------------------------------------------------ scenes */

/// Objects, lights and a camera, as plain data in the host's memory.
typedef struct OpalineScene OpalineScene;

/// How a scene is read.
typedef struct OpalineLoadOptions {
  size_t size;                  ///< sizeof(OpalineLoadOptions)
  float diagonalMm;             ///< that the scene is scaled to; 0: as the file says
  const OpalineMedium* medium;  ///< of all that is no metal; NULL: as the file says
} OpalineLoadOptions;

/// A scene without anything in it.
OPALINE_API OpalineStatus opalineCreateScene(OpalineScene** scene);

/// A .glb, .gltf, .obj, .ply or .toml file, repaired. `options` may be NULL. It has a camera and
/// lights in any case.
OPALINE_API OpalineStatus opalineLoadScene(const char* file, const OpalineLoadOptions* options,
                                           OpalineScene** scene);

/// The built-in gummy bear and teapot, 50 mm and of marble without `options`.
OPALINE_API OpalineStatus opalineCreateBear(const OpalineLoadOptions* options,
                                            OpalineScene** scene);
OPALINE_API OpalineStatus opalineCreateTeapot(const OpalineLoadOptions* options,
                                              OpalineScene** scene);

/// Renderers that have it set keep what they took of it.
OPALINE_API void opalineDestroyScene(OpalineScene* scene);

/// A body to be added to a scene. What it points to is copied.
typedef struct OpalineObject {
  size_t size;                 ///< sizeof(OpalineObject)
  const char* name;            ///< may be NULL
  const float* positionsMm;    ///< three floats a vertex
  size_t positionStrideBytes;  ///< from one vertex to the next; 0: 12
  size_t vertexCount;
  const uint32_t* triangles;  ///< three indices each, counter-clockwise seen from outside
  size_t triangleCount;
  const OpalineMedium* medium;  ///< NULL: marble
  const float* opaqueColor;     ///< three floats: a matt surface that lets no light in; else NULL
} OpalineObject;

/// `index` may be NULL.
OPALINE_API OpalineStatus opalineAddObject(OpalineScene* scene, const OpalineObject* object,
                                           size_t* index);

/// An opaque plane under all that the scene has, which gives back this share of light.
OPALINE_API OpalineStatus opalineAddGround(OpalineScene* scene, const float color[3]);

/// What is known of an object.
typedef struct OpalineObjectFacts {
  size_t size;       ///< sizeof(OpalineObjectFacts)
  const char* name;  ///< lives until the scene changes
  size_t vertexCount;
  size_t triangleCount;
} OpalineObjectFacts;

/// How many objects a scene has, and what is known of each.
OPALINE_API OpalineStatus opalineObjectCount(const OpalineScene* scene, size_t* count);
OPALINE_API OpalineStatus opalineObjectFacts(const OpalineScene* scene, size_t object,
                                             OpalineObjectFacts* facts);

/// The vertices at rest, three floats each, `vertexCount` of the object's facts.
OPALINE_API OpalineStatus opalineObjectPositions(const OpalineScene* scene, size_t object,
                                                 float* positionsMm, size_t vertexCount);

/// What an object is made of. Setting it makes an opaque one translucent.
OPALINE_API OpalineStatus opalineObjectMedium(const OpalineScene* scene, size_t object,
                                              OpalineMedium* medium);
OPALINE_API OpalineStatus opalineSetObjectMedium(OpalineScene* scene, size_t object,
                                                 const OpalineMedium* medium);

/// A pinhole camera.
typedef struct OpalineCamera {
  size_t size;  ///< sizeof(OpalineCamera)
  float positionMm[3];
  float targetMm[3];
  float up[3];
  float verticalFovDegrees;  ///< in [1, 170]
} OpalineCamera;

/// A camera that looks at the middle of the scene from a direction, such as 0, 0, 1.
OPALINE_API OpalineStatus opalineDefaultCamera(const OpalineScene* scene,
                                               const float directionFromCentre[3],
                                               float verticalFovDegrees, OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSceneCamera(const OpalineScene* scene, OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSetSceneCamera(OpalineScene* scene, const OpalineCamera* camera);

/* ------------------------------------------------------------------------------------ lights */

// At most 16 in all; see opaline/scene.h. Radiance, irradiance and intensity are linear RGB, in
// [0, 1e30]; directions have unit length.

/// Away with all lights, ambient light and environment.
OPALINE_API OpalineStatus opalineClearLights(OpalineScene* scene);

/// A key light from behind at the side, a weak fill and weak ambient light, instead of all others.
OPALINE_API OpalineStatus opalineUseDefaultLights(OpalineScene* scene);

/// Lights without size; a spot shines fully inside of the inner angle and not beyond the outer one,
/// both from its axis.
OPALINE_API OpalineStatus opalineAddDirectionalLight(OpalineScene* scene,
                                                     const float directionToLight[3],
                                                     const float irradiance[3]);
OPALINE_API OpalineStatus opalineAddPointLight(OpalineScene* scene, const float positionMm[3],
                                               const float intensity[3]);
OPALINE_API OpalineStatus opalineAddSpotLight(OpalineScene* scene, const float positionMm[3],
                                              const float direction[3], const float intensity[3],
                                              float innerDegrees, float outerDegrees);
/// A parallelogram; u and v are half its edges, and it shines to the side of u × v.
OPALINE_API OpalineStatus opalineAddRectangleLight(OpalineScene* scene, const float centreMm[3],
                                                   const float uMm[3], const float vMm[3],
                                                   const float radiance[3]);
OPALINE_API OpalineStatus opalineAddDiscLight(OpalineScene* scene, const float centreMm[3],
                                              const float normal[3], float radiusMm,
                                              const float radiance[3]);
OPALINE_API OpalineStatus opalineAddSphereLight(OpalineScene* scene, const float centreMm[3],
                                                float radiusMm, const float radiance[3]);
OPALINE_API OpalineStatus opalineAddTubeLight(OpalineScene* scene, const float fromMm[3],
                                              const float toMm[3], float radiusMm,
                                              const float radiance[3]);
/// The same radiance from all directions.
OPALINE_API OpalineStatus opalineSetAmbientLight(OpalineScene* scene, const float radiance[3]);
/// A latitude-longitude picture, .exr or .hdr, times `intensity`, turned about +y.
OPALINE_API OpalineStatus opalineSetEnvironment(OpalineScene* scene, const char* file,
                                                float intensity, double rotationDegrees);
/// The same from memory: 4 · width · height floats, linear R G B and one that is not read, copied.
OPALINE_API OpalineStatus opalineSetEnvironmentPixels(OpalineScene* scene, const float* rgba,
                                                      int32_t width, int32_t height,
                                                      float intensity, double rotationDegrees);

/* --------------------------------------------------------------------------------- rendering */

/// A device with one scene at a time.
typedef struct OpalineRenderer OpalineRenderer;

/// How much a message matters.
typedef enum OpalineLogLevel {
  OpalineDebug = 0,
  OpalineNote = 1,
  OpalineWarning = 2
} OpalineLogLevel;

/// Receives all messages; the library prints nothing. Called on the thread that called the library.
typedef void (*OpalineLog)(void* context, OpalineLogLevel level, const char* message);

/// How many Vulkan devices this machine has.
OPALINE_API OpalineStatus opalineDeviceCount(size_t* count);
/// The name of one, cut off where it has no room.
OPALINE_API OpalineStatus opalineDeviceName(size_t device, char* name, size_t nameBytes);

/// Which device a renderer uses, and how.
typedef struct OpalineRendererOptions {
  size_t size;         ///< sizeof(OpalineRendererOptions)
  const char* device;  ///< index or part of a name; NULL: the best there is
  int32_t validation;  ///< 1: run Vulkan's validation layer
  int32_t
      rayQueries;    ///< 1 or 0: with or without; -1: where the device has them and is no software
  OpalineLog log;    ///< may be NULL
  void* logContext;  ///< for the log
  float memoryLimitMegabytes;              ///< of the device, in [64, 1e7]; 0: what the device has
  const struct OpalineGivenVulkan* given;  ///< a device of the caller's, see below; NULL: its own
  const void* pipelineCache;               ///< what opalinePipelineCache gave in an earlier run
  size_t pipelineCacheBytes;               ///< 0 without one
} OpalineRendererOptions;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultRendererOptions(OpalineRendererOptions* options);

/// `options` may be NULL.
OPALINE_API OpalineStatus opalineCreateRenderer(const OpalineRendererOptions* options,
                                                OpalineRenderer** renderer);
/// Its views are destroyed before it.
OPALINE_API void opalineDestroyRenderer(OpalineRenderer* renderer);

/// Bytes of the device's memory that the renderer and its views take now.
OPALINE_API OpalineStatus opalineMemoryInUse(const OpalineRenderer* renderer, uint64_t* bytes);

/// Copies the pipelines that were compiled so far to `data`, which has room for `*bytes`, and says
/// in `*bytes` how many they are; only that if `data` is NULL.
OPALINE_API OpalineStatus opalinePipelineCache(const OpalineRenderer* renderer, void* data,
                                               size_t* bytes);

/// Takes what it needs of the scene, which may be changed or destroyed afterwards.
OPALINE_API OpalineStatus opalineSetScene(OpalineRenderer* renderer, const OpalineScene* scene);

/// Edits of what is rendered, from the next frame on. They remake only what depends on them.
OPALINE_API OpalineStatus opalineSetTime(OpalineRenderer* renderer, double seconds, int32_t clip);
OPALINE_API OpalineStatus opalineSetCamera(OpalineRenderer* renderer, const OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSetMedium(OpalineRenderer* renderer, size_t object,
                                           const OpalineMedium* medium);
/// All lights of a scene instead of those at hand.
OPALINE_API OpalineStatus opalineSetLights(OpalineRenderer* renderer, const OpalineScene* scene);

/// Where an object's vertices are, in their order: three floats each, copied. Normals follow.
/// `strideBytes` is from one to the next; 0: 12.
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
  OpalineAovSurfels = 8
} OpalineAov;

/// See RenderOptions in opaline/render_options.h, which has ranges and defaults.
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
  int32_t environmentBehind;  ///< 1 or 0
} OpalineRenderOptions;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultRenderOptions(OpalineRenderOptions* options);

/// A picture that is made again and again. It keeps its images, so that frames allocate nothing.
typedef struct OpalineView OpalineView;

/// `options` may be NULL. The renderer must outlive the view.
OPALINE_API OpalineStatus opalineCreateView(OpalineRenderer* renderer,
                                            const OpalineRenderOptions* options,
                                            OpalineView** view);
OPALINE_API void opalineDestroyView(OpalineView* view);

/// From the next frame on. Another size makes new images.
OPALINE_API OpalineStatus opalineSetViewOptions(OpalineView* view,
                                                const OpalineRenderOptions* options);
/// NULL: the scene's again.
OPALINE_API OpalineStatus opalineSetViewCamera(OpalineView* view, const OpalineCamera* camera);

/// A camera as programs have it that draw by themselves; see CameraMatrices in opaline/view.h.
typedef struct OpalineCameraMatrices {
  size_t size;            ///< sizeof(OpalineCameraMatrices)
  float worldToView[16];  ///< from millimetres, one column after the other
  float viewToClip[16];   ///< to Vulkan's clip space
  float jitterPixels[2];  ///< to the right and down, if viewToClip does not have it yet
} OpalineCameraMatrices;

/// Instead of a camera, until opalineSetViewCamera().
OPALINE_API OpalineStatus opalineSetViewMatrices(OpalineView* view,
                                                 const OpalineCameraMatrices* matrices);

/// Where a variable of a frame goes: linear R G B A, rows from top to bottom, A is coverage.
typedef struct OpalineTarget {
  size_t size;  ///< sizeof(OpalineTarget)
  OpalineAov aov;
  float* rgba;        ///< 4 · width · height floats
  size_t floatCount;  ///< how many floats there is room for, at least as many
} OpalineTarget;

/// Renders one frame and waits for it.
OPALINE_API OpalineStatus opalineRender(OpalineView* view, const OpalineTarget* targets,
                                        size_t targetCount);

/// Submits one frame with the variables that opalineCollect() is to give, and returns while the
/// device works. At most two frames wait to be collected.
OPALINE_API OpalineStatus opalineSubmit(OpalineView* view, const OpalineAov* aovs, size_t aovCount);

/// Waits for the oldest submitted frame and copies its variables, in the order of opalineSubmit().
/// `milliseconds`, of the device, may be NULL.
OPALINE_API OpalineStatus opalineCollect(OpalineView* view, const OpalineTarget* targets,
                                         size_t targetCount, double* milliseconds);

/* ------------------------------------------------------------------- the caller's Vulkan device */

// There if <vulkan/vulkan.h> was included before. What the parts mean, and the rules for layouts,
// stages, lifetimes and threads, stand beside the same parts in opaline/vulkan.h.
#ifdef VULKAN_CORE_H_

/// What the library needs of a device; see VulkanNeeds. All of it lives as long as the process.
typedef struct OpalineVulkanNeeds {
  size_t size;  ///< sizeof(OpalineVulkanNeeds)
  uint32_t apiVersion;
  const char* const* requiredExtensions;
  size_t requiredExtensionCount;
  const char* const* optionalExtensions;
  size_t optionalExtensionCount;
  const VkPhysicalDeviceFeatures2* requiredFeatures;
  const VkPhysicalDeviceFeatures2* optionalFeatures;
} OpalineVulkanNeeds;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineVulkanNeeds(OpalineVulkanNeeds* needs);

/// Why the library cannot use the device, cut off where it has no room; empty if it can.
OPALINE_API OpalineStatus opalineWhatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice,
                                               char* sentence, size_t sentenceBytes);

/// A device for OpalineRendererOptions; see GivenVulkan.
typedef struct OpalineGivenVulkan {
  size_t size;  ///< sizeof(OpalineGivenVulkan)
  VkInstance instance;
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  uint32_t queueFamily;
  VkQueue queue;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr;  ///< NULL: the loader that the library links
  const char* const* enabledExtensions;
  size_t enabledExtensionCount;
  const VkPhysicalDeviceFeatures2* enabledFeatures;
  void (*lockQueue)(void* context);    ///< NULL where nobody else uses the queue
  void (*unlockQueue)(void* context);  ///< the same
  void* lockContext;                   ///< for both
} OpalineGivenVulkan;

/// See DevicePositions.
typedef struct OpalineDevicePositions {
  size_t size;  ///< sizeof(OpalineDevicePositions)
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
  uint32_t strideBytes;  ///< 0: 12
} OpalineDevicePositions;

/// As opalineSetPositions(), from a buffer that every frame reads again.
OPALINE_API OpalineStatus opalineSetDevicePositions(OpalineRenderer* renderer, size_t object,
                                                    const OpalineDevicePositions* positions);

/// A value of a timeline semaphore.
typedef struct OpalineTimelinePoint {
  size_t size;  ///< sizeof(OpalineTimelinePoint)
  VkSemaphore semaphore;
  uint64_t value;
} OpalineTimelinePoint;

/// See DeviceTarget.
typedef struct OpalineDeviceTarget {
  size_t size;  ///< sizeof(OpalineDeviceTarget)
  VkImage image;
  VkImageView view;
  VkFormat format;
  VkImageLayout layout;
} OpalineDeviceTarget;

/// See Composition.
typedef struct OpalineComposition {
  size_t size;  ///< sizeof(OpalineComposition)
  const OpalineDeviceTarget* color;
  const OpalineDeviceTarget* depth;  ///< may be NULL
  float radianceScale;
} OpalineComposition;

/// See DeviceExitance.
typedef struct OpalineDeviceExitance {
  size_t size;  ///< sizeof(OpalineDeviceExitance)
  size_t object;
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
} OpalineDeviceExitance;

/// A frame on the caller's device; see FrameSubmission, FrameRecording and FrameOrder.
typedef struct OpalineDeviceFrame {
  size_t size;                        ///< sizeof(OpalineDeviceFrame)
  const OpalineTimelinePoint* waits;  ///< none for a recorded frame
  size_t waitCount;
  const OpalineTimelinePoint* signals;  ///< of a recorded frame one: what its submission signals
  size_t signalCount;
  VkCommandBuffer commands;        ///< of a recorded frame
  const OpalineComposition* over;  ///< may be NULL
  const OpalineDeviceExitance* exitances;
  size_t exitanceCount;
  int32_t onDevice;        ///< 1: leave the radiance, for opalineViewPicture()
  int32_t exitance;        ///< 1: leave the exitance of vertices, for opalineViewExitance()
  const OpalineAov* aovs;  ///< for opalineCollect()
  size_t aovCount;
} OpalineDeviceFrame;

/// Makes all that such a frame needs, so that opalineRecordFrame() submits nothing.
OPALINE_API OpalineStatus opalinePrepareFrame(OpalineView* view, const OpalineDeviceFrame* frame);
OPALINE_API OpalineStatus opalineSubmitFrame(OpalineView* view, const OpalineDeviceFrame* frame);
OPALINE_API OpalineStatus opalineRecordFrame(OpalineView* view, const OpalineDeviceFrame* frame);

/// See DeviceImage.
typedef struct OpalineDeviceImage {
  size_t size;  ///< sizeof(OpalineDeviceImage)
  VkImage image;
  VkImageView view;
  VkFormat format;
  VkImageLayout layout;
  uint32_t width;
  uint32_t height;
} OpalineDeviceImage;

/// Of the last frame that was to leave it.
OPALINE_API OpalineStatus opalineViewPicture(const OpalineView* view, OpalineDeviceImage* picture);

/// See DeviceBuffer.
typedef struct OpalineDeviceBuffer {
  size_t size;  ///< sizeof(OpalineDeviceBuffer)
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
  VkDeviceSize bytes;
} OpalineDeviceBuffer;

/// Of the last frame that was to leave it.
OPALINE_API OpalineStatus opalineViewExitance(const OpalineView* view, size_t object,
                                              OpalineDeviceBuffer* exitance);

#endif  // VULKAN_CORE_H_

/* ---------------------------------------------------------------------------------- pictures */

/// How radiance becomes colour.
typedef struct OpalineTone {
  size_t size;              ///< sizeof(OpalineTone)
  float exposureStops;      ///< in [-32, 32]
  int32_t neutral;          ///< 1: Khronos PBR Neutral; 0: clip at 1
  const float* background;  ///< three floats, linear; NULL: alpha is coverage
} OpalineTone;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultTone(OpalineTone* tone);

/// The exposure that suits a scene's light, in stops.
OPALINE_API OpalineStatus opalineAutomaticExposure(const OpalineScene* scene, float* stops);

/// 4 · width · height floats, as opalineRender() gives them. `tone` may be NULL.
OPALINE_API OpalineStatus opalineWritePng(const char* file, const float* rgba, int32_t width,
                                          int32_t height, const OpalineTone* tone);
OPALINE_API OpalineStatus opalineWriteExr(const char* file, const float* rgba, int32_t width,
                                          int32_t height);

/// An .exr or .hdr file.
typedef struct OpalineImage OpalineImage;
OPALINE_API OpalineStatus opalineReadImage(const char* file, OpalineImage** image);
OPALINE_API void opalineDestroyImage(OpalineImage* image);
OPALINE_API int32_t opalineImageWidth(const OpalineImage* image);
OPALINE_API int32_t opalineImageHeight(const OpalineImage* image);
/// 4 · width · height floats that live as long as the image.
OPALINE_API const float* opalineImagePixels(const OpalineImage* image);

/// How far image A is from B, over the pixels that both cover. What is relative is over the mean
/// of |B|.
typedef struct OpalineDifference {
  size_t size;  ///< sizeof(OpalineDifference)
  uint64_t coveredPixels;
  double relRmse;
  double relBias;  ///< mean of A - B
  double p95Rel;   ///< 95th percentile of |A - B|
  double maxAbs;
  double psnrDb;
} OpalineDifference;

/// Both of 4 · width · height floats.
OPALINE_API OpalineStatus opalineCompare(const float* rgbaOfA, const float* rgbaOfB, int32_t width,
                                         int32_t height, OpalineDifference* difference);

#ifdef __cplusplus
}
#endif

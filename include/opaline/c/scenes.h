#pragma once

/// Scenes, objects and cameras in C; part of opaline/opaline_c.h.

#include "opaline/c/log.h"
#include "opaline/c/media.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// Objects, lights and a camera, as plain data in the host's memory.
typedef struct OpalineScene OpalineScene;

/// How a scene is read.
typedef struct OpalineLoadOptions {
  size_t size;                  ///< sizeof(OpalineLoadOptions)
  float diagonalMm;             ///< length the scene's diagonal is scaled to; 0: as the file says
  const OpalineMedium* medium;  ///< of all objects that are not metals; NULL: as the file says
  const OpalineColorModel* colorModel;  ///< for media that a file gives as colours; NULL: as the
                                        ///< file says
  const char* morphTo;  ///< a model of the same topology that a clip turns the scene into; NULL:
                        ///< none
  OpalineLog log;       ///< receives notes, such as what in a file is not shown; may be NULL
  void* logContext;     ///< for the log
} OpalineLoadOptions;

/// A scene without anything in it.
OPALINE_API OpalineStatus opalineCreateScene(OpalineScene** scene);

/// Reads a .glb, .gltf, .obj, .ply or .toml file and repairs its meshes. `options` may be NULL. The
/// scene gets a default camera and lights if the file has none.
OPALINE_API OpalineStatus opalineLoadScene(const char* file, const OpalineLoadOptions* options,
                                           OpalineScene** scene);

/// The built-in gummy bear and teapot; without `options` 50 mm and of marble.
OPALINE_API OpalineStatus opalineCreateBear(const OpalineLoadOptions* options,
                                            OpalineScene** scene);
OPALINE_API OpalineStatus opalineCreateTeapot(const OpalineLoadOptions* options,
                                              OpalineScene** scene);

/// Renderers that use the scene have their own copy of what they need.
OPALINE_API void opalineDestroyScene(OpalineScene* scene);

/// An object to be added to a scene. What it points to is copied.
typedef struct OpalineObject {
  size_t size;                 ///< sizeof(OpalineObject)
  const char* name;            ///< may be NULL
  const float* positionsMm;    ///< three floats per vertex
  size_t positionStrideBytes;  ///< distance from one vertex to the next; 0: 12
  size_t vertexCount;
  const uint32_t* triangles;  ///< three indices each, counter-clockwise seen from outside
  size_t triangleCount;
  const OpalineMedium* medium;  ///< NULL: marble
  const float* opaqueColor;     ///< three floats: a matt surface that lets no light in; else NULL
} OpalineObject;

/// `index` may be NULL.
OPALINE_API OpalineStatus opalineAddObject(OpalineScene* scene, const OpalineObject* object,
                                           size_t* index);

/// Adds an opaque plane under the scene that reflects this share of light.
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

/// The positions of an object's vertices at rest, three floats each; `vertexCount` is that of its
/// facts.
OPALINE_API OpalineStatus opalineObjectPositions(const OpalineScene* scene, size_t object,
                                                 float* positionsMm, size_t vertexCount);

/// An object's triangles, three indices each; `triangleCount` is that of its facts.
OPALINE_API OpalineStatus opalineObjectTriangles(const OpalineScene* scene, size_t object,
                                                 uint32_t* triangles, size_t triangleCount);

/// The medium of an object. Setting it makes an opaque object translucent.
OPALINE_API OpalineStatus opalineObjectMedium(const OpalineScene* scene, size_t object,
                                              OpalineMedium* medium);
OPALINE_API OpalineStatus opalineSetObjectMedium(OpalineScene* scene, size_t object,
                                                 const OpalineMedium* medium);

/// A pinhole camera, or an orthographic one; see Camera in opaline/scene.h.
typedef struct OpalineCamera {
  size_t size;  ///< sizeof(OpalineCamera)
  float positionMm[3];
  float targetMm[3];
  float up[3];
  float verticalFovDegrees;    ///< in [1, 170]
  float shiftX;                ///< of the visible window: to the right in picture widths
  float shiftY;                ///< and up in picture heights, each in [-1000, 1000]
  float orthographicHeightMm;  ///< height of an orthographic picture, in (0, 1e6]; 0: pinhole
} OpalineCamera;

/// A camera that looks at the middle of the scene from a direction, such as 0, 0, 1.
OPALINE_API OpalineStatus opalineDefaultCamera(const OpalineScene* scene,
                                               const float directionFromCentre[3],
                                               float verticalFovDegrees, OpalineCamera* camera);
/// The given camera, moved until it just sees all points, three floats each. `aspect` is the
/// picture's width divided by its height. `margin`, in [0, 1), is the part of its half width and
/// half height that stays free. `strideBytes` is the distance from one point to the next; 0: 12.
/// See Framing in opaline/framing.h.
OPALINE_API OpalineStatus opalineCameraThatSees(const OpalineCamera* camera, double aspect,
                                                double margin, const float* pointsMm,
                                                size_t pointCount, size_t strideBytes,
                                                OpalineCamera* moved);
OPALINE_API OpalineStatus opalineSceneCamera(const OpalineScene* scene, OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSetSceneCamera(OpalineScene* scene, const OpalineCamera* camera);

OPALINE_C_END

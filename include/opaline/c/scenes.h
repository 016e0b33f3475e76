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
  size_t size;                          ///< sizeof(OpalineLoadOptions)
  float diagonalMm;                     ///< that the scene is scaled to; 0: as the file says
  const OpalineMedium* medium;          ///< of all that is no metal; NULL: as the file says
  const OpalineColorModel* colorModel;  ///< of media that files give by colour; NULL: as they say
  const char* morphTo;  ///< a model of the same topology that a clip turns it into; NULL: none
  OpalineLog log;       ///< receives notes, as of what a file has and is not shown; may be NULL
  void* logContext;     ///< for the log
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

/// Its triangles, three indices each, `triangleCount` of its facts.
OPALINE_API OpalineStatus opalineObjectTriangles(const OpalineScene* scene, size_t object,
                                                 uint32_t* triangles, size_t triangleCount);

/// What an object is made of. Setting it makes an opaque one translucent.
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
  float shiftX;                ///< of what is seen, in widths of the picture to the right
  float shiftY;                ///< and in its heights up, each in [-1000, 1000]
  float orthographicHeightMm;  ///< of an orthographic camera's picture, in (0, 1e6]; 0: pinhole
} OpalineCamera;

/// A camera that looks at the middle of the scene from a direction, such as 0, 0, 1.
OPALINE_API OpalineStatus opalineDefaultCamera(const OpalineScene* scene,
                                               const float directionFromCentre[3],
                                               float verticalFovDegrees, OpalineCamera* camera);
/// The camera that just sees all of some points, three floats each, looking as the given one looks.
/// `aspect` is the picture's width over its height, of which the part `margin` stays free at each
/// side, in [0, 1). `strideBytes` is from one point to the next; 0: 12. See Framing in
/// opaline/framing.h.
OPALINE_API OpalineStatus opalineCameraThatSees(const OpalineCamera* camera, double aspect,
                                                double margin, const float* pointsMm,
                                                size_t pointCount, size_t strideBytes,
                                                OpalineCamera* moved);
OPALINE_API OpalineStatus opalineSceneCamera(const OpalineScene* scene, OpalineCamera* camera);
OPALINE_API OpalineStatus opalineSetSceneCamera(OpalineScene* scene, const OpalineCamera* camera);

OPALINE_C_END

#pragma once

/// Clips, deformers and sequences of meshes in C; part of opaline/opaline_c.h.

#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// What is known of a clip.
typedef struct OpalineClipFacts {
  size_t size;       ///< sizeof(OpalineClipFacts)
  const char* name;  ///< lives until the scene changes
  double seconds;    ///< length; a time beyond it is taken modulo it
} OpalineClipFacts;

/// How many clips a scene has, and what is known of each.
OPALINE_API OpalineStatus opalineClipCount(const OpalineScene* scene, size_t* count);
OPALINE_API OpalineStatus opalineClipFacts(const OpalineScene* scene, size_t clip,
                                           OpalineClipFacts* facts);

/// See DeformerKind in opaline/motion.h.
typedef enum OpalineDeformerKind {
  OpalineTwist = 0,
  OpalineBend = 1,
  OpalineSquash = 2,
  OpalineWobble = 3
} OpalineDeformerKind;

/// Adds a deformer of the whole scene, which applies after those that it has; see Deformer in
/// opaline/motion.h.
OPALINE_API OpalineStatus opalineAddDeformer(OpalineScene* scene, OpalineDeformerKind kind,
                                             float amount, float periodSeconds);
OPALINE_API OpalineStatus opalineClearDeformers(OpalineScene* scene);

/// Positions of an object's vertices at a time, three floats each, computed without a device.
/// `vertexCount` is that of its facts; `clip` is -1 for none.
OPALINE_API OpalineStatus opalinePositionsAt(const OpalineScene* scene, double seconds,
                                             int32_t clip, size_t object, float* positionsMm,
                                             size_t vertexCount);

/// Meshes of one topology in numbered files; see opaline/sequence.h.
typedef struct OpalineSequence OpalineSequence;

/// `pattern` has one %d or %0Nd in its last part, such as frame_%04d.ply. `options` may be NULL.
OPALINE_API OpalineStatus opalineOpenSequence(const char* pattern,
                                              const OpalineLoadOptions* options,
                                              OpalineSequence** sequence);
OPALINE_API void opalineDestroySequence(OpalineSequence* sequence);

/// The numbers of the first and last file. There is a file for every number in between.
OPALINE_API OpalineStatus opalineSequenceNumbers(const OpalineSequence* sequence, int32_t* first,
                                                 int32_t* last);

/// A scene with the first mesh as its only object, which the caller destroys.
OPALINE_API OpalineStatus opalineSequenceScene(const OpalineSequence* sequence,
                                               OpalineScene** scene);

/// The positions in a file, three floats per vertex of that object, for opalineSetPositions(). May
/// be called from several threads at once.
OPALINE_API OpalineStatus opalineReadSequence(const OpalineSequence* sequence, int32_t number,
                                              float* positionsMm, size_t vertexCount);

OPALINE_C_END

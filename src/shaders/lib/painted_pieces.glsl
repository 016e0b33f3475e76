// Means of a paint over pieces of surfels. Needs, before it, BINDING_PAINT_TABLES, BINDING_PIECES and what
// lib/material.glsl and lib/opaque_material.glsl need.
#ifndef OPALINE_LIB_PAINTED_PIECES
#define OPALINE_LIB_PAINTED_PIECES
#include "lib/material.glsl"
#include "lib/paint_table.glsl"
#include "lib/piece_material.glsl"

layout(std430, set = 0, binding = BINDING_PIECES) readonly buffer Pieces { SurfelPiece pieces[]; };

// False, and nothing found, where none of them has an area.
bool meanPaint(MediumData medium, uint first, uint end, out PaintEntry mean) {
  OpaqueData material = opaques[medium.tables.y];
  mean = PaintEntry(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  float count = 0.0;
  for (uint k = first; k < end; ++k) {
    SurfelPiece piece = pieces[k];
    if (piece.fraction <= 0.0) continue;
    PaintEntry found = paintOf(medium, baseColorAt(material, placeOfPiece(piece, material)).rgb);
    mean.thickness += found.thickness;
    mean.entering += found.entering;
    mean.layer += found.layer;
    mean.leaving += found.leaving;
    mean.takenOff += found.takenOff;
    mean.source += found.source;
    mean.deep += found.deep;
    count += 1.0;
  }
  if (count == 0.0) return false;
  mean = PaintEntry(mean.thickness / count, mean.entering / count, mean.layer / count, mean.leaving / count,
                    mean.takenOff / count, mean.source / count, mean.deep / count);
  return true;
}

#endif

// Means of a paint over pieces of surfels by their areas at rest. Needs, before it, BINDING_PAINT_TABLES, BINDING_PIECES and what
// lib/material.glsl and lib/opaque_material.glsl need.
#ifndef OPALINE_LIB_PAINTED_PIECES
#define OPALINE_LIB_PAINTED_PIECES
#include "lib/material.glsl"
#include "lib/paint_table.glsl"
#include "lib/piece_at.glsl"
#include "lib/piece_material.glsl"


// Returns false, with nothing found, where none of them has an area.
bool meanPaint(MediumData medium, uint first, uint end, out PaintEntry mean) {
  OpaqueData material = opaques[medium.tables.y];
  mean = PaintEntry(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  float area = 0.0;
  for (uint k = first; k < end; ++k) {
    SurfelPiece piece = pieceAt(k);
    if (piece.areaMm2 <= 0.0) continue;
    PaintEntry found = paintOf(medium, baseColorAt(material, placeOfPiece(piece, material)).rgb);
    mean.thickness += piece.areaMm2 * found.thickness;
    mean.entering += piece.areaMm2 * found.entering;
    mean.layer += piece.areaMm2 * found.layer;
    mean.leaving += piece.areaMm2 * found.leaving;
    mean.takenOff += piece.areaMm2 * found.takenOff;
    mean.source += piece.areaMm2 * found.source;
    mean.deep += piece.areaMm2 * found.deep;
    area += piece.areaMm2;
  }
  if (area == 0.0) return false;
  mean = PaintEntry(mean.thickness / area, mean.entering / area, mean.layer / area, mean.leaving / area,
                    mean.takenOff / area, mean.source / area, mean.deep / area);
  return true;
}

#endif

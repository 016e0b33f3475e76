#pragma once

#include "opaline/scene.h"

namespace opaline::builtin {

/// A gummy bear that faces +z and stands on y = 0: closed, smooth, genus 0, about 50,000 triangles,
/// bounding-box diagonal 50 mm.
Mesh bearMesh();

/// The Utah teapot in the units of its patches, y up, welded: 1177 vertices, 2256 triangles.
Mesh teapotMesh();

/// Scales a mesh about the origin so that the diagonal of its bounding box has the given length.
void scaleToDiagonal(Mesh& mesh, float diagonalMm);

}  // namespace opaline::builtin

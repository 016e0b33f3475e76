#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <vector>

#include "opaline/image.h"
#include "opaline/types.h"

namespace opaline::python {

namespace py = pybind11;

/// Numbers of any shape that Python has for three, as a colour or a place.
Vec3 vectorOf(const py::handle& values, const char* name);
std::array<double, 3> tripleOf(const py::handle& values, const char* name);
/// The same as a direction: a unit vector along it. Throws UsageError where it has no length.
Vec3 unitOf(const py::handle& values, const char* name);

/// An array (N, 3) of any kind of number and any strides.
std::vector<Vec3> positionsOf(const py::handle& values, const char* name);

/// An array (N, 2).
std::vector<Vec2> placesOf(const py::handle& values, const char* name);

/// An array (M, 3) of whole numbers.
std::vector<Triangle> trianglesOf(const py::handle& values, const char* name);

/// An array (height, width, 3 or 4); with three channels all is covered.
Image imageOf(const py::handle& values, const char* name);

/// Arrays that own their numbers, without a copy where there is no need of one.
py::array arrayOf(Image image);
py::array arrayOf(const std::vector<Vec3>& values);
py::array arrayOf(const std::vector<Triangle>& values);
py::array arrayOf(const Image8& image);

/// Three numbers that cannot be changed in place, since that would change a copy.
py::array fixedArrayOf(const std::array<double, 3>& values);
py::tuple tupleOf(const Vec3& values);

/// "(4, 3)"
std::string shapeText(const py::array& array);

}  // namespace opaline::python

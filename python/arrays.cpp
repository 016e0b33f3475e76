#include "python/arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "opaline/error.h"

namespace opaline::python {

namespace {

using Doubles = py::array_t<double, py::array::forcecast>;
using Floats = py::array_t<float, py::array::forcecast>;

/// Whatever NumPy makes of it; what has no numbers is refused.
py::array numbersOf(const py::handle& values, const char* name) {
  py::array array = py::array::ensure(values);
  if (!array) {
    PyErr_Clear();
    throw UsageError(fmt::format("{} is not an array of numbers.", name));
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw UsageError(fmt::format("{} is an array of {}; it must hold numbers.", name,
                                 py::str(array.dtype()).cast<std::string>()));
  }
  return array;
}

template <typename Array>
Array castOf(const py::array& array, const char* name) {
  Array cast = Array::ensure(array);
  if (!cast) {
    PyErr_Clear();
    throw UsageError(fmt::format("{} cannot be read as an array of numbers.", name));
  }
  return cast;
}

py::array rowsOf(const py::handle& values, const char* name) {
  py::array array = numbersOf(values, name);
  if (array.ndim() == 2 && array.shape(1) == 3) return array;
  if (array.size() == 0) return array.reshape({0, 3});
  throw UsageError(fmt::format("{} has the shape {}; it must be (N, 3).", name, shapeText(array)));
}

/// Frees what an array refers to together with it.
template <typename T>
py::capsule ownerOf(std::unique_ptr<T> owned) {
  return py::capsule(owned.release(), [](void* memory) { delete static_cast<T*>(memory); });
}

template <typename Row>
py::array rowsArray(const std::vector<Row>& values) {
  using Number = typename Row::value_type;
  const auto count = static_cast<py::ssize_t>(values.size());
  py::array_t<Number> array(std::vector<py::ssize_t>{count, 3});
  for (py::ssize_t i = 0; i < count; ++i) {
    const Row& row = values[static_cast<std::size_t>(i)];
    std::copy(row.begin(), row.end(), array.mutable_data(i, 0));
  }
  return array;
}

}  // namespace

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

std::array<double, 3> tripleOf(const py::handle& values, const char* name) {
  py::array array = numbersOf(values, name);
  if (array.size() != 3) {
    throw UsageError(
        fmt::format("{} has the shape {}; it must be three numbers.", name, shapeText(array)));
  }
  const auto numbers = castOf<Doubles>(array.reshape({3}), name);
  const auto at = numbers.unchecked<1>();
  return {at(0), at(1), at(2)};
}

Vec3 vectorOf(const py::handle& values, const char* name) {
  const auto triple = tripleOf(values, name);
  return {static_cast<float>(triple[0]), static_cast<float>(triple[1]),
          static_cast<float>(triple[2])};
}

std::vector<Vec3> positionsOf(const py::handle& values, const char* name) {
  const auto numbers = castOf<Floats>(rowsOf(values, name), name);
  const auto at = numbers.unchecked<2>();
  std::vector<Vec3> positions(static_cast<std::size_t>(at.shape(0)));
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    positions[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1), at(i, 2)};
  }
  return positions;
}

std::vector<Vec2> placesOf(const py::handle& values, const char* name) {
  const py::array array = numbersOf(values, name);
  if (array.ndim() != 2 || array.shape(1) != 2) {
    throw UsageError(
        fmt::format("{} has the shape {}; it must be (N, 2).", name, shapeText(array)));
  }
  const auto numbers = castOf<Floats>(array, name);
  const auto at = numbers.unchecked<2>();
  std::vector<Vec2> places(static_cast<std::size_t>(at.shape(0)));
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    places[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1)};
  }
  return places;
}

std::vector<Triangle> trianglesOf(const py::handle& values, const char* name) {
  const py::array rows = rowsOf(values, name);
  if (rows.size() > 0 && rows.dtype().kind() == 'f') {
    throw UsageError(fmt::format("{} is an array of {}; it must hold whole numbers.", name,
                                 py::str(rows.dtype()).cast<std::string>()));
  }
  const auto numbers = castOf<py::array_t<std::int64_t, py::array::forcecast>>(rows, name);
  const auto at = numbers.unchecked<2>();
  std::vector<Triangle> triangles(static_cast<std::size_t>(at.shape(0)));
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const std::int64_t vertex = at(i, corner);
      if (vertex < 0 || vertex > std::numeric_limits<std::uint32_t>::max()) {
        throw UsageError(fmt::format("{} names vertex {} in row {}.", name, vertex, i));
      }
      triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(corner)] =
          static_cast<std::uint32_t>(vertex);
    }
  }
  return triangles;
}

Image imageOf(const py::handle& values, const char* name) {
  constexpr py::ssize_t largest = 16384;
  const py::array array = numbersOf(values, name);
  const bool fits = array.ndim() == 3 && (array.shape(2) == 3 || array.shape(2) == 4) &&
                    array.shape(0) >= 1 && array.shape(1) >= 1 && array.shape(0) <= largest &&
                    array.shape(1) <= largest;
  if (!fits) {
    throw UsageError(
        fmt::format("{} has the shape {}; it must be (height, width, 4) or (height, "
                    "width, 3), of at most {} pixels each way.",
                    name, shapeText(array), largest));
  }
  const auto numbers = castOf<Floats>(array, name);
  const auto at = numbers.unchecked<3>();
  Image image(static_cast<int>(at.shape(1)), static_cast<int>(at.shape(0)));
  for (py::ssize_t y = 0; y < at.shape(0); ++y) {
    for (py::ssize_t x = 0; x < at.shape(1); ++x) {
      float* const pixel = image.pixel(static_cast<int>(x), static_cast<int>(y));
      pixel[3] = 1;
      for (py::ssize_t c = 0; c < at.shape(2); ++c) pixel[c] = at(y, x, c);
    }
  }
  return image;
}

py::array arrayOf(Image image) {
  auto owned = std::make_unique<std::vector<float>>(std::move(image.rgba));
  float* const values = owned->data();
  return py::array_t<float>(std::vector<py::ssize_t>{image.height, image.width, 4}, values,
                            ownerOf(std::move(owned)));
}

py::array arrayOf(const Image8& image) {
  py::array_t<std::uint8_t> array(std::vector<py::ssize_t>{image.height, image.width, 4});
  std::copy(image.rgba.begin(), image.rgba.end(), array.mutable_data());
  return array;
}

py::array arrayOf(const std::vector<Vec3>& values) {
  return rowsArray(values);
}

py::array arrayOf(const std::vector<Triangle>& values) {
  return rowsArray(values);
}

py::array fixedArrayOf(const std::array<double, 3>& values) {
  py::array_t<double> array(3);
  std::copy(values.begin(), values.end(), array.mutable_data());
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::tuple tupleOf(const Vec3& values) {
  return py::make_tuple(values[0], values[1], values[2]);
}

Vec3 unitOf(const py::handle& values, const char* name) {
  const auto given = tripleOf(values, name);
  const double length = std::hypot(given[0], given[1], given[2]);
  if (!(length > 0) || !std::isfinite(length)) {
    throw UsageError(fmt::format("{} must have a length that is finite and above 0.", name));
  }
  return {static_cast<float>(given[0] / length), static_cast<float>(given[1] / length),
          static_cast<float>(given[2] / length)};
}

}  // namespace opaline::python

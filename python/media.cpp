#include "opaline/media.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "opaline/error.h"
#include "opaline/options/scene.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace opaline::python {

namespace {

Medium named(const std::string& name) {
  const auto found = findMedium(name);
  if (!found)
    throw UsageError(fmt::format("There is no medium '{}'; opaline.media() has all.", name));
  return *found;
}

Medium sound(Medium medium) {
  std::string complaint = complaintAbout(medium);
  // Scene files and the command line call the reduced coefficient by a shorter name.
  constexpr std::string_view shorter = "sigma_s_per_mm";
  if (complaint.starts_with(shorter)) complaint.replace(0, shorter.size(), "sigma_s_prime_per_mm");
  if (!complaint.empty()) throw UsageError(complaint);
  return medium;
}

Medium mediumBy(const py::object& name, const py::object& sigmaSPrime, const py::object& sigmaA,
                const py::object& eta, const py::object& g) {
  Medium medium;
  const bool isNamed = !name.is_none();
  if (isNamed && sigmaSPrime.is_none() && sigmaA.is_none()) {
    medium = named(name.cast<std::string>());
  } else {
    if (sigmaSPrime.is_none() || sigmaA.is_none()) {
      throw UsageError(
          "A medium has a name that opaline.media() knows, or sigma_s_prime_per_mm and "
          "sigma_a_per_mm.");
    }
    if (isNamed) medium.name = name.cast<std::string>();
    medium.sigmaSPrimePerMm = tripleOf(sigmaSPrime, "sigma_s_prime_per_mm");
    medium.sigmaAPerMm = tripleOf(sigmaA, "sigma_a_per_mm");
  }
  if (!eta.is_none()) medium.eta = eta.cast<double>();
  if (!g.is_none()) medium.g = g.cast<double>();
  return sound(medium);
}

Medium looking(const py::object& color, const py::object& meanFreePathMm, double g, double eta,
               const std::string& colorModel, double ballMm) {
  const Appearance appearance{tripleOf(color, "color"),
                              tripleOf(meanFreePathMm, "mean_free_path_mm"),
                              g,
                              eta,
                              colorModelOf(colorModel),
                              ballMm};
  const std::string complaint = complaintAbout(appearance);
  if (!complaint.empty()) throw UsageError(complaint);
  return opaline::mediumOf(appearance);
}

std::string textOf(const Medium& medium) {
  const auto& s = medium.sigmaSPrimePerMm;
  const auto& a = medium.sigmaAPerMm;
  return fmt::format(
      "Medium({}sigma_s_prime_per_mm=({}, {}, {}), sigma_a_per_mm=({}, {}, {}), eta={}, g={})",
      medium.name.empty() ? "" : fmt::format("'{}', ", medium.name), s[0], s[1], s[2], a[0], a[1],
      a[2], medium.eta, medium.g);
}

}  // namespace

ColorModel colorModelOf(const std::string& name) {
  const auto& names = options::namesOf<ColorModel>();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw UsageError(
        fmt::format("color_model '{}' must be one of {}", name, fmt::join(names, ", ")));
  return options::named<ColorModel>(name);
}

Medium mediumOf(const py::handle& given) {
  if (py::isinstance<py::str>(given)) return named(given.cast<std::string>());
  return given.cast<Medium>();
}

void bindMedia(py::module_& module) {
  py::class_<Medium>(module, "Medium",
                     R"(What a body is made of, for red, green and blue. It never changes.

Medium("marble") is one of opaline.media(). Medium(sigma_s_prime_per_mm=(a, b, c), sigma_a_per_mm=(d, e, f),
eta=1.4, g=0) is one of your own: reduced scattering in 1/mm, in (0, 1e6]; absorption in 1/mm, in [0, 1e6]; relative
index of refraction, in [1.01, 3]; mean cosine of scattering, in [-0.99, 0.99]. A named one may have another g.)")
      .def(py::init(&mediumBy), py::arg("name") = py::none(), py::kw_only(),
           py::arg("sigma_s_prime_per_mm") = py::none(), py::arg("sigma_a_per_mm") = py::none(),
           py::arg("eta") = py::none(), py::arg("g") = py::none())
      .def_static("from_appearance", &looking, py::arg("color"), py::arg("mean_free_path_mm"),
                  py::arg("g") = 0.0, py::arg("eta") = 1.4, py::arg("color_model") = "observed",
                  py::arg("ball_mm") = 0.0,
                  R"(The medium that looks like this.

color: of a thick body in even light, three numbers in [0, 1]; mean_free_path_mm: three numbers in [1e-6, 1e6];
g: mean cosine of scattering, in [-0.99, 0.99]; eta: in [1.01, 1.6]; color_model: "observed", or "khr" where the color is
the albedo of KHR_materials_volume_scatter; ball_mm: diameter of the ball that has the color in even light, in [0, 1e9],
0: a body without end.)")
      .def_readonly("name", &Medium::name, "Its name, or an empty text.")
      .def_property_readonly(
          "sigma_s_prime_per_mm",
          [](const Medium& medium) { return fixedArrayOf(medium.sigmaSPrimePerMm); },
          "Reduced scattering, 1/mm: array (3,), float64, not writeable.")
      .def_property_readonly(
          "sigma_a_per_mm", [](const Medium& medium) { return fixedArrayOf(medium.sigmaAPerMm); },
          "Absorption, 1/mm: array (3,), float64, not writeable.")
      .def_readonly("eta", &Medium::eta, "Relative index of refraction.")
      .def_readonly("g", &Medium::g, "Mean cosine of scattering.")
      .def("__eq__",
           [](const Medium& a, const py::object& b) {
             return py::isinstance<Medium>(b) && a == b.cast<Medium>();
           })
      .def("__repr__", &textOf);
  module.def(
      "media",
      [] {
        py::dict all;
        for (const MeasuredMedium& measured : measuredMedia()) {
          all[measured.medium.name.c_str()] = measured.medium;
        }
        for (const Medium& medium : artisticMedia()) all[medium.name.c_str()] = medium;
        return all;
      },
      "All media that have names: name -> Medium. Twelve were measured by Jensen et al. 2001.");
}

}  // namespace opaline::python

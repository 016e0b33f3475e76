#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "opaline/render_options.h"

namespace opaline::python {

namespace py = pybind11;

/// Sets what keywords say, by the table of options. Throws UsageError for what is not allowed, and
/// TypeError for unknown names and values of another type.
void applyKeywords(const py::kwargs& keywords, RenderOptions& options);

/// The options that applyKeywords() knows, a line each: name, what is allowed, default, meaning.
std::string keywordHelp();

/// A variable by its name, or several.
std::vector<Aov> aovsOf(const py::handle& names);

Aov aovOf(const std::string& name);
Transport transportOf(const std::string& name);

std::string nameOf(Aov aov);
std::string nameOf(Transport transport);
std::string nameOf(Sum sum);

}  // namespace opaline::python

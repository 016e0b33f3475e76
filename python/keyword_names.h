#pragma once

#include <string>
#include <string_view>

namespace opaline::python {

/// What the library says, with the names that its fields have as keywords: "RenderOptions::bounces"
/// becomes "bounces", "RenderOptions::maxClusters" becomes "max_clusters".
std::string withKeywordNames(std::string_view sentence);

}  // namespace opaline::python

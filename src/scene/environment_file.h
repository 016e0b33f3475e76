#pragma once

#include "opaline/environment.h"
#include "opaline/options/field.h"

namespace opaline::options {

template <>
const std::vector<Field<EnvironmentFile>>& fieldsOf();

}  // namespace opaline::options

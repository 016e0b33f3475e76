#pragma once

#include <optional>
#include <string>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/options/field.h"
#include "opaline/render_options.h"
#include "opaline/renderer.h"
#include "opaline/tone.h"

namespace opaline::options {

/// What decides a picture beside the scene.
struct PictureSettings {
  RenderOptions render;
  SceneTime time;
  ToneOptions tone;
};

template <>
OPALINE_API const std::vector<Field<PictureSettings>>& fieldsOf();

/// What is chosen by a name that only the machine or the model knows.
struct NamedSettings {
  std::optional<std::string> device;
  std::optional<std::string> clip;

  bool operator==(const NamedSettings&) const = default;
};

template <>
OPALINE_API const std::vector<Field<NamedSettings>>& fieldsOf();

template <>
OPALINE_API const std::vector<Field<RendererOptions>>& fieldsOf();

template <>
OPALINE_API const std::vector<std::string_view>& namesOf<Transport>();
template <>
OPALINE_API const std::vector<std::string_view>& namesOf<Sum>();
template <>
OPALINE_API const std::vector<std::string_view>& namesOf<Site>();
template <>
OPALINE_API const std::vector<std::string_view>& namesOf<ToneCurve>();
template <>
OPALINE_API const std::vector<std::string_view>& namesOf<Aov>();

/// As chosen, of what the library renders.
OPALINE_API void apply(const Chosen<PictureSettings>& chosen, RenderOptions& options);

/// Why no picture can be made so, as a sentence; empty where one can.
OPALINE_API std::string complaintAbout(const RenderOptions& options);

/// Why there is no such time, as a sentence; empty where there is.
OPALINE_API std::string complaintAbout(const SceneTime& time);

}  // namespace opaline::options

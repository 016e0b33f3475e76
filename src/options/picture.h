#pragma once

#include <optional>
#include <string>

#include "opaline/motion.h"
#include "opaline/render_options.h"
#include "opaline/renderer.h"
#include "opaline/tone.h"
#include "options/field.h"

namespace opaline::options {

/// What decides a picture beside the scene.
struct PictureSettings {
  RenderOptions render;
  SceneTime time;
  ToneOptions tone;
};

template <>
const std::vector<Field<PictureSettings>>& fieldsOf();

/// What is chosen by a name that only the machine or the model knows.
struct NamedSettings {
  std::optional<std::string> device;
  std::optional<std::string> clip;

  bool operator==(const NamedSettings&) const = default;
};

template <>
const std::vector<Field<NamedSettings>>& fieldsOf();

template <>
const std::vector<Field<RendererOptions>>& fieldsOf();

template <>
const std::vector<std::string_view>& namesOf<Transport>();
template <>
const std::vector<std::string_view>& namesOf<Sum>();
template <>
const std::vector<std::string_view>& namesOf<Site>();
template <>
const std::vector<std::string_view>& namesOf<ToneCurve>();
template <>
const std::vector<std::string_view>& namesOf<Aov>();

/// As chosen, of what the library renders.
void apply(const Chosen<PictureSettings>& chosen, RenderOptions& options);

/// Why no picture can be made so, as a sentence; empty where one can.
std::string complaintAbout(const RenderOptions& options);

/// Why there is no such time, as a sentence; empty where there is.
std::string complaintAbout(const SceneTime& time);

}  // namespace opaline::options

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

/// What a picture depends on besides the scene.
struct PictureSettings {
  RenderOptions render;
  SceneTime time;
  ToneOptions tone;
};

template <>
OPALINE_API const std::vector<Field<PictureSettings>>& fieldsOf();

/// Options whose names depend on the machine or the model.
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

/// How an interface says that an option has a value, as it is typed or stands in a file.
using Spelling = std::string (*)(const Field<PictureSettings>& field, const Value& value);

/// An option that was chosen, but that nothing reads beside the others.
struct Unused {
  std::string_view key;
  std::string why;  ///< goes on after the option's name: "limits surfels and needs" this or that
};

/// The first of the chosen options that is unused in `options`, which have all of them and others.
OPALINE_API std::optional<Unused> findUnused(const Chosen<PictureSettings>& chosen,
                                             const RenderOptions& options, Spelling spelling);

/// The transport for a sum where nobody chose one: the pattern alone means the paper's.
OPALINE_API void chooseTransport(RenderOptions& options);

/// As chosen, of what the library renders.
OPALINE_API void apply(const Chosen<PictureSettings>& chosen, RenderOptions& options);

/// Why no picture can be made with these options, as a sentence; empty if one can.
OPALINE_API std::string complaintAbout(const RenderOptions& options);

/// Why the time is not valid, as a sentence; empty if it is.
OPALINE_API std::string complaintAbout(const SceneTime& time);

}  // namespace opaline::options

#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "opaline/export.h"
#include "opaline/options/range.h"
#include "opaline/types.h"

namespace opaline::options {

/// Width and height, pixels.
using Size = std::array<int, 2>;

/// The value of an option. A text is a name.
using Value = std::variant<bool, int, float, double, std::string, Size, Rgb, std::array<double, 3>>;

/// What values an option takes.
struct OPALINE_API Allowed {
  Range range{0, 0};  ///< of a number, or of each number of several
  /// Texts that are allowed; empty: any text but an empty one. For options of other types, names
  /// that may take the place of a value.
  std::vector<std::string_view> choices = {};
  std::vector<int> counts = {};  ///< whole numbers that are allowed; empty: all in the range

  /// Whether a value is allowed.
  bool holds(const Value& value) const;
};

/// What a value has to be, as the end of a sentence: "must be from 0 to 8".
OPALINE_API std::string requirement(const Allowed& allowed, const Value& like);

/// The same where people type it, with the forms that textOf() has: "must be WIDTHxHEIGHT, …".
OPALINE_API std::string typedRequirement(const Allowed& allowed, const Value& like);

/// The value as people write it: "0.01", "1,1,0.5", "1024x768".
OPALINE_API std::string textOf(const Value& value);

/// One option of an Owner, with all that the command line, scene files, the window and the checks
/// need to know about it.
template <typename Owner>
struct Field {
  std::string_view key;        ///< in scene files; on the command line with dashes
  std::string_view formerKey;  ///< an older name that is still understood, or empty
  std::string_view help;       ///< a few words, not about allowed values or the default
  std::string_view standard;   ///< the default in words if a value cannot express it, or empty
  Allowed allowed;
  std::optional<Value> (*get)(const Owner&);  ///< nothing if the option has no value
  void (*set)(Owner&, const Value&);          ///< takes the type of `like`, or a choice
  Value like;                                 ///< a value of the option's type
  /// What messages to all callers call it, where its key has a form of its own; empty: the key.
  std::string_view words = {};
};

/// All options of an Owner, in the order in which they are shown.
template <typename Owner>
const std::vector<Field<Owner>>& fieldsOf();

/// The field with that key, current or former; null if there is none.
template <typename Owner>
const Field<Owner>* findField(std::string_view key) {
  for (const Field<Owner>& field : fieldsOf<Owner>())
    if (field.key == key || (!field.formerKey.empty() && field.formerKey == key)) return &field;
  return nullptr;
}

/// The field with a key that is known to exist.
template <typename Owner>
const Field<Owner>& fieldOf(std::string_view key) {
  const Field<Owner>* const found = findField<Owner>(key);
  assert(found != nullptr);
  return *found;
}

/// A complaint about an option whose value is not allowed, as a sentence; empty if it is.
template <typename Owner>
std::string complaintAboutField(const Field<Owner>& field, const Owner& owner) {
  const std::optional<Value> value = field.get(owner);
  if (!value || field.allowed.holds(*value)) return {};
  return std::string(field.words.empty() ? field.key : field.words) + " " + textOf(*value) + ": " +
         requirement(field.allowed, *value);
}

/// The same about the first of all options.
template <typename Owner>
std::string complaintAboutFields(const Owner& owner) {
  for (const Field<Owner>& field : fieldsOf<Owner>())
    if (std::string complaint = complaintAboutField(field, owner); !complaint.empty())
      return complaint;
  return {};
}

/// Values that were chosen for some of an Owner's options.
template <typename Owner>
class Chosen {
 public:
  /// Chooses a value, in place of any earlier one for the field.
  void set(const Field<Owner>& field, Value value) {
    values_.insert_or_assign(field.key, std::move(value));
  }
  /// Removes, looks for and finds the value chosen for a key. find() returns null if there is none.
  void erase(std::string_view key) { values_.erase(key); }
  bool has(std::string_view key) const { return values_.contains(key); }
  const Value* find(std::string_view key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? nullptr : &found->second;
  }
  /// Whether nothing was chosen.
  bool empty() const { return values_.empty(); }

  /// Sets the members that were chosen.
  void applyTo(Owner& owner) const {
    for (const Field<Owner>& field : fieldsOf<Owner>())
      if (const Value* value = find(field.key)) field.set(owner, *value);
  }

  bool operator==(const Chosen&) const = default;

 private:
  std::map<std::string_view, Value> values_;  // keys are the fields' own
};

/// Everything that an Owner's options are set to.
template <typename Owner>
Chosen<Owner> chosenIn(const Owner& owner) {
  Chosen<Owner> chosen;
  for (const Field<Owner>& field : fieldsOf<Owner>())
    if (std::optional<Value> value = field.get(owner)) chosen.set(field, *std::move(value));
  return chosen;
}

/// The field, also known by an older key.
template <typename Owner>
Field<Owner> formerly(std::string_view formerKey, Field<Owner> field) {
  field.formerKey = formerKey;
  return field;
}

/// The field, called so in messages to all callers.
template <typename Owner>
Field<Owner> called(std::string_view words, Field<Owner> field) {
  field.words = words;
  return field;
}

/// For the library: where a name stands among others. Throws UsageError where it does not.
OPALINE_API std::size_t indexOf(std::string_view name, std::span<const std::string_view> names);

/// The names of an enumeration's values, in their order.
template <typename Enumeration>
const std::vector<std::string_view>& namesOf();

/// Whether a value is one of its enumeration, for a cast makes a value of any number.
template <typename Enumeration>
bool hasName(Enumeration value) {
  return static_cast<std::size_t>(value) < namesOf<Enumeration>().size();
}

/// The value's name in files and on the command line; the number of a value without a name.
template <typename Enumeration>
std::string nameOf(Enumeration value) {
  if (!hasName(value)) return std::to_string(static_cast<int>(value));
  return std::string(namesOf<Enumeration>()[static_cast<std::size_t>(value)]);
}

/// The value of that name. Throws UsageError where there is none.
template <typename Enumeration>
Enumeration named(std::string_view name) {
  return static_cast<Enumeration>(indexOf(name, namesOf<Enumeration>()));
}

/// The member at the end of a path of members.
template <auto first, auto... rest, typename Owner>
auto& memberOf(Owner& owner) {
  if constexpr (sizeof...(rest) == 0)
    return owner.*first;
  else
    return memberOf<rest...>(owner.*first);
}

/// For the library: whether a member may be without a value.
template <typename T>
struct IsOptional : std::false_type {};
/// For the library: whether a member may be without a value.
template <typename T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// For the library: the value of a member; nothing if it has none.
template <typename T>
std::optional<Value> valueOf(const T& member) {
  if constexpr (IsOptional<T>::value)
    return member ? valueOf(*member) : std::nullopt;
  else if constexpr (std::is_enum_v<T>)
    return nameOf(member);
  else
    return member;
}

/// For the library: sets a member to a value of its kind.
template <typename T>
void assign(const Value& value, T& member) {
  if constexpr (IsOptional<T>::value)
    assign(value, member.emplace());
  else if constexpr (std::is_enum_v<T>)
    member = named<T>(std::get<std::string>(value));
  else
    member = std::get<T>(value);
}

/// For the library: some value of the type that a member has.
template <typename T>
Value valueLike() {
  if constexpr (IsOptional<T>::value)
    return valueLike<typename T::value_type>();
  else if constexpr (std::is_enum_v<T>)
    return std::string();
  else
    return T{};
}

/// For the library: what a value of that kind may be called; empty where it has no name.
template <typename T>
std::vector<std::string_view> namesLike() {
  if constexpr (IsOptional<T>::value)
    return namesLike<typename T::value_type>();
  else if constexpr (std::is_enum_v<T>)
    return namesOf<T>();
  else
    return {};
}

/// The option that is the member at the end of `path`.
template <typename Owner, auto... path>
Field<Owner> field(std::string_view key, Allowed allowed, std::string_view help,
                   std::string_view standard = {}) {
  using Member = std::remove_cvref_t<decltype(memberOf<path...>(std::declval<Owner&>()))>;
  if (auto names = namesLike<Member>(); !names.empty()) allowed.choices = std::move(names);
  return {key,
          {},
          help,
          standard,
          std::move(allowed),
          [](const Owner& owner) { return valueOf(memberOf<path...>(owner)); },
          [](Owner& owner, const Value& value) { assign(value, memberOf<path...>(owner)); },
          valueLike<Member>()};
}

}  // namespace opaline::options

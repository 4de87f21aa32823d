#pragma once

#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// The candidate nearest to @p name by edit distance, or empty when none is near enough to be meant.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" with the nearest candidate, or empty.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// The names separated by ", ".
std::string joined(const std::vector<std::string>& names);

/// A number for a message, with up to 9 digits.
std::string number_text(double value);

/// A number for a person: 4 significant digits.
std::string short_number(double value);

/// A value of an enum and its spelling in files and on command lines.
template <typename Enum>
struct EnumName {
    Enum value;
    const char* name;
};

/// The names of all values of an enum, in the order in which messages list them. Specialized next to the enum:
///
///     template <>
///     inline constexpr auto kEnumNames<Guard> = std::to_array<EnumName<Guard>>({{Guard::none, "none"}, ...});
template <typename Enum>
inline constexpr std::array<EnumName<Enum>, 0> kEnumNames{};

/// An enum with kEnumNames.
template <typename Enum>
concept NamedEnum = !std::empty(kEnumNames<Enum>);

/// The names of all values of an enum.
template <NamedEnum Enum>
std::vector<std::string> names_of()
{
    std::vector<std::string> names;
    for (const EnumName<Enum>& entry : kEnumNames<Enum>)
        names.emplace_back(entry.name);
    return names;
}

/// The name of a value; empty for a number that is none of the values.
template <NamedEnum Enum>
std::string to_string(Enum value)
{
    for (const EnumName<Enum>& entry : kEnumNames<Enum>)
        if (entry.value == value)
            return entry.name;
    return {};
}

/// Where @p name is in @p names.
/// @throws InputError  "'x' is none of a, b, c", with the nearest
std::size_t index_of_name(std::string_view name, const std::vector<std::string>& names);

/// The value of that name.
/// @throws InputError  as index_of_name()
template <NamedEnum Enum>
Enum from_string(std::string_view name)
{
    return kEnumNames<Enum>[index_of_name(name, names_of<Enum>())].value;
}

} // namespace morph

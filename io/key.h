#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contact/case.h"
#include "dynamics/machine.h"
#include "io/units.h"

namespace tricontact::io {

/// Place in a case that a key fills; empty where the key does not apply to the case at hand.
using Field =
    std::variant<std::monostate, std::string*, std::vector<std::string>*, double*,
                 std::optional<double>*, std::optional<std::string>*, int*, bool*,
                 contact::Case::Shape*, contact::Case::AmplitudeReference*, contact::Case::Steps*,
                 contact::Case::Until*, contact::Case::VtkOutput*, contact::Case::VolumeOutput*,
                 contact::Case::Base*, contact::Case::Sides*, contact::Case::Press*,
                 contact::Case::Kinematics*, contact::Relaxation::Bulk*, dynamics::Machine::Model*,
                 std::vector<double>*>;

/// Admissible numbers, in the key's SI unit.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;

    bool contains(double value) const;
};

/// A word a key may take, and the enumerator it stands for (-1: the word itself is stored).
struct Choice {
    std::string_view word;
    int enumerator = -1;
};

/// Declaration of one key of an input file: reader, writer and reference all use it.
struct Key {
    enum class Kind {
        text,
        choice,
        choice_list,
        number,
        integer,
        boolean,
        quantity,
        quantity_list,
        number_list
    };

    std::string_view path;  ///< "section.key", or "key" at the top; sections may have dots
    Kind kind = Kind::text;
    Dimension dimension = Dimension::none;  ///< of a quantity, or each of a list
    bool bare = false;  ///< a list of one may stand, and is written, without brackets
    Range range = {};
    std::string_view reason = {};  ///< for the range, where it does not speak for itself
    std::vector<Choice> choices = {};
    std::string_view default_value = {};  ///< TOML; empty: none
    bool required = false;                ///< in its section, if the section is there
    int alternative = 0;          ///< keys of the same number > 0: exactly one, or the default
    std::string_view needs = {};  ///< key or section without which this one says nothing
    std::string_view example;     ///< TOML
    std::string_view text;        ///< what it means, one line

    std::string_view section() const;  ///< "" at the top
    std::string_view name() const;
};

/// "a.b" of "a.b.key", "" of "key". A quoted key, as a document shows it, may hold dots.
std::string_view section_of(std::string_view path);
/// "key" of both.
std::string_view name_of_key(std::string_view path);
/// Most elements of a list of quantities or numbers.
inline constexpr std::size_t longest_list = 50;

constexpr Range above_zero(double high) {
    return {0, high, false, true};
}
constexpr Range from_zero(double high) {
    return {0, high, true, true};
}

template <class T>
Choice choice(std::string_view word, T enumerator) {
    return {word, static_cast<int>(enumerator)};
}

/// Place of a member of a part that the case at hand may lack.
template <class Part, class Member>
Field in(std::optional<Part>& part, Member Part::*member) {
    return part ? Field(&(*part.*member)) : Field();
}

}  // namespace tricontact::io

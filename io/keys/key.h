#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/keys/units.h"

namespace tricontact::io {

/// Place of an enumerator of any type that int holds.
class EnumPlace {
  public:
    template <class T>
    requires std::is_enum_v<T> EnumPlace(T* place)
        : place_(place),
          get_([](const void* at) { return static_cast<int>(*static_cast<const T*>(at)); }),
          set_([](void* at, int value) { *static_cast<T*>(at) = static_cast<T>(value); }) {}
    int get() const { return get_(place_); }
    void set(int value) const { set_(place_, value); }

  private:
    void* place_;
    int (*get_)(const void*);
    void (*set_)(void*, int);
};

/// Place in a case that a key fills; empty where the key does not apply to the case at hand.
using Field = std::variant<std::monostate, std::string*, std::vector<std::string>*, double*,
                           std::vector<double>*, std::optional<double>*,
                           std::optional<std::string>*, int*, bool*, EnumPlace>;

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

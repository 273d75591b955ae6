#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/keys/units.h"

// Declarations of keys by what they hold: path, what is admissible, example, meaning.
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

/// What few keys have.
struct KeyExtras {
    std::string_view reason = {};         ///< for the range, where it does not speak for itself
    std::string_view default_value = {};  ///< TOML; empty: none
    bool required = false;                ///< in its section, if the section is there
    int alternative = 0;          ///< keys of the same number > 0: exactly one, or the default
    std::string_view needs = {};  ///< key or section without which this one has no effect
    /// Another key that this one says in other words: at most one of both, and what needs that one
    /// is content with this one.
    std::string_view stands_for = {};
};

/// "a.b" of "a.b.key", "" of "key". A quoted key, as a document shows it, may hold dots.
std::string_view section_of(std::string_view path);
/// "key" of both.
std::string_view name_of_key(std::string_view path);

/// Declaration of one key of an input file: reader, writer and reference all use it.
struct Key : KeyExtras {
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
    std::string_view example;  ///< TOML
    std::string_view text;     ///< what it means, one line
    Range range = {};
    Dimension dimension = Dimension::none;  ///< of a quantity, or each of a list
    std::vector<Choice> choices = {};
    bool bare = false;  ///< a list of one may stand, and is written, without brackets

    std::string_view section() const { return section_of(path); }  ///< "" at the top
    std::string_view name() const { return name_of_key(path); }
};

/// Declaration of a key with its place in what the file describes.
template <class Input>
struct PlacedKey : Key {
    Field (*field)(Input&) = nullptr;
};

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

/// Place of the member of a member ... of a part; none where an optional on the way is empty.
template <class Part, class... Members>
Field in(Part& part, Members... members) {
    if constexpr (sizeof...(members) == 0)
        return &part;
    else if constexpr (requires { part.has_value(); })
        return part ? in(*part, members...) : Field();
    else
        return [&](auto first, auto... rest) { return in(part.*first, rest...); }(members...);
}

/// The same as the place of a PlacedKey.
template <auto... members, class Input>
Field at(Input& input) {
    return in(input, members...);
}

inline Key text_key(std::string_view path, std::string_view example, std::string_view text,
                    const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::text, example, text};
}
inline Key boolean_key(std::string_view path, std::string_view example, std::string_view text,
                       const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::boolean, example, text};
}
inline Key choice_key(std::string_view path, const std::vector<Choice>& choices,
                      std::string_view example, std::string_view text,
                      const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::choice, example, text, {}, Dimension::none, choices};
}
inline Key integer_key(std::string_view path, const Range& range, std::string_view example,
                       std::string_view text, const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::integer, example, text, range};
}
inline Key number_key(std::string_view path, const Range& range, std::string_view example,
                      std::string_view text, const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::number, example, text, range};
}
inline Key quantity_key(std::string_view path, Dimension dimension, const Range& range,
                        std::string_view example, std::string_view text,
                        const KeyExtras& extras = {}) {
    return {extras, path, Key::Kind::quantity, example, text, range, dimension};
}
/// A length above zero.
inline Key length_key(std::string_view path, std::string_view example, std::string_view text,
                      const KeyExtras& extras = {}) {
    return quantity_key(path, Dimension::length, above_zero(1e6), example, text, extras);
}
/// Young's or shear modulus.
inline Key modulus_key(std::string_view path, std::string_view example, std::string_view text,
                       const KeyExtras& extras = {}) {
    return quantity_key(path, Dimension::pressure, above_zero(1e15), example, text, extras);
}
/// Poisson's ratio.
inline Key poisson_key(std::string_view path, std::string_view example, std::string_view text,
                       const KeyExtras& extras = {}) {
    return number_key(path, {-1, 0.5, false, true}, example, text, extras);
}

/// A list of what the key of a choice, number or quantity holds.
inline Key list_of(Key one) {
    using enum Key::Kind;
    one.kind = one.kind == choice ? choice_list : one.kind == number ? number_list : quantity_list;
    return one;
}
/// The same, of which one may stand without brackets.
inline Key bare_list_of(Key one) {
    one.bare = true;
    return list_of(one);
}

/// All keys of a kind of input file, in the order in which they are written.
class KeyList {
  public:
    /// Of keys that are declared elsewhere.
    KeyList(std::vector<const Key*> keys, std::string_view reference)
        : keys_(std::move(keys)), reference_(reference) {}
    /// `keys` shall outlive the list. `reference`: the document that explains them.
    template <class Declared>
    KeyList(const std::vector<Declared>& keys, std::string_view reference) : reference_(reference) {
        for (const Key& key : keys) keys_.push_back(&key);
    }

    std::span<const Key* const> keys() const { return keys_; }
    std::string_view reference() const { return reference_; }

    const Key* find(std::string_view path) const;
    bool has_section(std::string_view name) const;
    std::vector<std::string_view> paths() const;
    /// Sections, in alphabetical order.
    std::vector<std::string_view> sections() const;
    /// The keys that exclude each other with this one, itself included where they are a group; none
    /// if it has no alternative.
    std::vector<const Key*> alternatives(const Key& key) const;

  private:
    std::vector<const Key*> keys_;
    std::string_view reference_;
};

/// The reference of all keys of a kind of input file, as their declarations say it: Markdown, a
/// heading of the third level and a table per section.
std::string key_reference(const KeyList& keys);

}  // namespace tricontact::io

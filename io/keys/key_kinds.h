#pragma once

#include <utility>

#include "io/keys/key.h"

// Declarations of keys by what they hold: path, what is admissible, example, meaning.
namespace tricontact::io {

/// What few keys have.
struct KeyExtras {
    std::string_view reason = {}, default_value = {};
    bool required = false;
    int alternative = 0;
    std::string_view needs = {};
};

inline Key key_of(Key::Kind kind, std::string_view path, const Range& range,
                  std::string_view example, std::string_view text, const KeyExtras& extras) {
    return {.path = path,
            .kind = kind,
            .range = range,
            .reason = extras.reason,
            .default_value = extras.default_value,
            .required = extras.required,
            .alternative = extras.alternative,
            .needs = extras.needs,
            .example = example,
            .text = text};
}

inline Key text_key(std::string_view path, std::string_view example, std::string_view text,
                    const KeyExtras& extras = {}) {
    return key_of(Key::Kind::text, path, {}, example, text, extras);
}
inline Key boolean_key(std::string_view path, std::string_view example, std::string_view text,
                       const KeyExtras& extras = {}) {
    return key_of(Key::Kind::boolean, path, {}, example, text, extras);
}
inline Key choice_key(std::string_view path, std::vector<Choice> choices, std::string_view example,
                      std::string_view text, const KeyExtras& extras = {}) {
    Key key = key_of(Key::Kind::choice, path, {}, example, text, extras);
    key.choices = std::move(choices);
    return key;
}
inline Key integer_key(std::string_view path, const Range& range, std::string_view example,
                       std::string_view text, const KeyExtras& extras = {}) {
    return key_of(Key::Kind::integer, path, range, example, text, extras);
}
inline Key number_key(std::string_view path, const Range& range, std::string_view example,
                      std::string_view text, const KeyExtras& extras = {}) {
    return key_of(Key::Kind::number, path, range, example, text, extras);
}
inline Key quantity_key(std::string_view path, Dimension dimension, const Range& range,
                        std::string_view example, std::string_view text,
                        const KeyExtras& extras = {}) {
    Key key = key_of(Key::Kind::quantity, path, range, example, text, extras);
    key.dimension = dimension;
    return key;
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
    return list_of(std::move(one));
}

}  // namespace tricontact::io

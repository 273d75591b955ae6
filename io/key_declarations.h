#pragma once

#include <vector>

#include "io/case_keys.h"

namespace tricontact::io {

/// Groups of alternative keys: exactly one of each group, or its default.
enum KeyGroup {
    no_group = 0,
    normal_load,
    tangential_load,
    amplitude,
    steps,
    cell_size,
    element_size,
    relaxation
};

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

/// Declarations of the sections [load] and [rolling].
void add_loading_keys(std::vector<Key>& keys);
/// Declarations of the substrate's finite size, in [substrate], [lower_layer] and [ground].
void add_layer_keys(std::vector<Key>& keys);
/// Declarations of the section [substrate.relaxation].
void add_relaxation_keys(std::vector<Key>& keys);
/// Declarations of the section [contact].
void add_contact_keys(std::vector<Key>& keys);
/// Declarations of the section [fem].
void add_fem_keys(std::vector<Key>& keys);

}  // namespace tricontact::io

#pragma once

#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/keys/key.h"

namespace tricontact::io {

/// Declaration of one key of the case file.
using CaseKey = PlacedKey<contact::Case>;

/// All keys in the order in which they are written.
const std::vector<CaseKey>& case_keys();
const KeyList& case_key_list();
/// These and those of a rig: all that a case file may hold, but for the names in [printed].
const KeyList& case_file_keys();
/// The place of a key in the case; none where it does not apply to its shape.
Field place_of(const CaseKey& key, contact::Case& c);
/// The number of the case that a key stands for; null where the case states another one instead.
double* number_of(const CaseKey& key, contact::Case& c);
const CaseKey* find_key(std::string_view path);

/// Groups of alternative keys: exactly one of each group, or its default.
enum KeyGroup {
    normal_load = 1,
    tangential_load,
    amplitude,
    steps,
    cell_size,
    element_size,
    relaxation,
    path_rows,
    adhesion_range,
    wear_law
};

// Declarations by sections.
std::vector<CaseKey> indenter_keys();   // and [indenter.roughness]
std::vector<CaseKey> substrate_keys();  // and [lower_layer], [ground]
std::vector<CaseKey> upper_plate_keys();
std::vector<CaseKey> relaxation_keys();  // [substrate.relaxation]
std::vector<CaseKey> contact_keys();     // [friction], [interface], [contact]
std::vector<CaseKey> adhesion_keys();    // [adhesion]
std::vector<CaseKey> heat_keys();        // [indenter.heat], [substrate.heat]
std::vector<CaseKey> load_keys();
std::vector<CaseKey> rolling_keys();
std::vector<CaseKey> tractive_keys();
std::vector<CaseKey> path_keys();
std::vector<CaseKey> rig_stiffness_keys();  // of [rig] those that the contact feels
std::vector<CaseKey> wear_keys();

/// The place of a key of a relaxing case, see at().
template <auto... members>
Field if_relaxing(contact::Case& c) {
    return c.relaxation ? in(c, members...) : Field();
}

/// The place of a key of what is kept with the case under the type that has the first member.
template <auto first, auto... members>
Field kept(contact::Case& c) {
    const auto place = [&]<class Kept, class Value>(Value Kept::*) {
        return in(c.of<Kept>(), first, members...);
    };
    return place(first);
}

}  // namespace tricontact::io

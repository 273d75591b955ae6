#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/keys/key.h"

namespace tricontact::io {

/// Declaration of one key of the case file.
using CaseKey = PlacedKey<contact::Case>;

/// All keys in the order in which they are written.
std::span<const CaseKey> case_keys();
const KeyList& case_key_list();
const CaseKey* find_key(std::string_view path);
bool is_section(std::string_view name);

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

/// Declarations of the section [indenter].
void add_indenter_keys(std::vector<CaseKey>& keys);
/// Declarations of the section [indenter.roughness].
void add_roughness_keys(std::vector<CaseKey>& keys);
/// Declarations of the sections [load] and [rolling].
void add_loading_keys(std::vector<CaseKey>& keys);
/// Declarations of the section [tractive_rolling].
void add_tractive_keys(std::vector<CaseKey>& keys);
/// Declarations of the substrate's finite size, in [substrate], [lower_layer] and [ground].
void add_layer_keys(std::vector<CaseKey>& keys);
/// Declarations of the section [substrate.relaxation].
void add_relaxation_keys(std::vector<CaseKey>& keys);
/// Declarations of the section [contact].
void add_contact_keys(std::vector<CaseKey>& keys);

}  // namespace tricontact::io

#pragma once

#include <vector>

#include "io/case/case_keys.h"
#include "io/keys/key_kinds.h"

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
/// Declarations of the section [fem].
void add_fem_keys(std::vector<CaseKey>& keys);

}  // namespace tricontact::io

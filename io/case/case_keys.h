#pragma once

#include <span>
#include <string_view>

#include "contact/case.h"
#include "io/keys/key.h"
#include "io/keys/key_list.h"

namespace tricontact::io {

/// Declaration of one key of the case file.
struct CaseKey : Key {
    Field (*field)(contact::Case&) = nullptr;
};

/// All keys in the order in which they are written.
std::span<const CaseKey> case_keys();
const KeyList& case_key_list();
const CaseKey* find_key(std::string_view path);
bool is_section(std::string_view name);

}  // namespace tricontact::io

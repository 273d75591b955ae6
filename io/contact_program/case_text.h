#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "contact/substrates/material.h"

namespace tricontact::io {

/// How the text of an imported case begins.
inline constexpr std::string_view imported_case_beginning = "title = \"Sequence of CONTACT, ";

/// What an input file of CONTACT's module 3 becomes.
struct ImportedCase {
    std::string text;          ///< the case file (TOML)
    std::size_t n_steps = 0;   ///< of the sequence that it computes
    std::size_t left_out = 0;  ///< cases of the normal problem alone, ahead of the sequence
};

/// The case whose steps are those of the file (docs/contact-program.md); every step is compared
/// with what the case makes of it. `is_coupled`: whether the model couples normal and tangential
/// contact of these bodies. `name` stands for the file in messages. Throws contact::InputError with
/// the line of what is no case, or no step of this one.
ImportedCase case_of_sequence(std::string text, const std::string& name,
                              const std::function<bool(const contact::MaterialPair&)>& is_coupled);

}  // namespace tricontact::io

#pragma once

#include <string>

#include "io/keys/key.h"
#include "io/keys/toml_document.h"
#include "io/keys/uncertain_number.h"

namespace tricontact::io {

/// "must be at least 0 m and less than 1 m", and why.
std::string range_rule(const Key& key);

/// Puts the value of an entry into the field of its key: type, unit, choice and range are checked.
/// An empty field is left alone after the checks. Throws contact::InputError.
void read_field(const Key& key, const Entry& entry, const Field& field);
/// The number of a key of one number or quantity with its uncertainty, exact where none is stated;
/// read_field() takes the value alone. Throws contact::InputError.
UncertainNumber read_uncertain_number(const Key& key, const Entry& entry);
/// The choice that the entry makes of those of its key. Throws contact::InputError.
const Choice& read_choice(const Key& key, const Entry& entry);

/// Input files key by key, in the order of their declarations: a heading where a section begins.
class KeyWriter {
  public:
    /// Writes nothing if the case has no value there.
    void add(const Key& key, const Field& field);
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::string_view section_;
};

}  // namespace tricontact::io

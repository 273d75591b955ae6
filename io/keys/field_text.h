#pragma once

#include <string>

#include "io/keys/key.h"

namespace tricontact::io {

/// TOML text of a field, as its key is read: quantities in SI units with the shortest digits that
/// read back the same. Empty if the case has no value there.
std::string field_text(const Key& key, const Field& field);

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

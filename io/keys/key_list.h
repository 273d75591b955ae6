#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/key.h"

namespace tricontact::io {

/// All keys of a kind of input file, in the order in which they are written.
class KeyList {
  public:
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
    /// The keys that exclude each other with this one, itself included; none if it has no
    /// alternative.
    std::vector<const Key*> alternatives(const Key& key) const;

  private:
    std::vector<const Key*> keys_;
    std::string_view reference_;
};

}  // namespace tricontact::io

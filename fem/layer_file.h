#pragma once

#include <stdexcept>
#include <string>

#include "fem/condensed_layer.h"

namespace tricontact::fem {

/// Belongs to every file and key: raise it when the bytes of a file or the numbers of a condensed
/// layer change their meaning.
constexpr unsigned layer_file_version = 2;

/// Digits of a key.
constexpr std::size_t layer_key_length = 32;

/// Why a file of a condensed layer cannot be read or written.
class LayerFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes all of `layer` to an open file and syncs it. Throws LayerFileError.
void write_layer(int file_descriptor, const std::string& key, const CondensedLayer& layer);

/// Reads a file that `write_layer` made, bit by bit the same. Nothing is believed before it has
/// been checked: no size but what the file's own size confirms, no number before its checksum.
/// Throws LayerFileError.
CondensedLayer read_layer(int file_descriptor, const std::string& key);

}  // namespace tricontact::fem

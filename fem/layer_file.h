#pragma once

#include <stdexcept>
#include <string>

#include "fem/condensed_layer.h"
#include "files/partial_file.h"
#include "files/regular_file.h"

namespace tricontact::fem {

/// Belongs to every file and key: raise it when the bytes of a file or the numbers of a condensed
/// layer change their meaning.
constexpr unsigned layer_file_version = 2;

/// Digits of a key.
constexpr std::size_t layer_key_length = 32;

/// What is wrong with a file of a condensed layer.
class LayerFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes all of `layer`. Throws std::system_error.
void write_layer(files::PartialFile& file, const std::string& key, const CondensedLayer& layer);

/// Reads a file that `write_layer` made, bit by bit the same. Nothing is believed before it has
/// been checked: no size but what the file's own size confirms, no number before its checksum.
/// Throws LayerFileError, files::Unreadable.
CondensedLayer read_layer(files::RegularFile& file, const std::string& key);

}  // namespace tricontact::fem

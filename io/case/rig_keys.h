#pragma once

#include <string_view>
#include <vector>

#include "io/keys/key.h"

// Keys of what only a rig has, beside those of the case that describes its contact: [rig],
// [record], [measurement], [design], and [printed], whose names are those of the quantities that a
// publication states.
namespace tricontact::io {

/// What was done while [record] was taken: rolled at one amplitude below or beyond the limit of
/// shakedown, or at amplitudes that rise in steps.
enum class RecordKind { shakedown, ratcheting, limit };

/// Of a contact case: a heavy roller on a layer, rolled back and forth by a lever, its records and
/// what was measured on it.
const std::vector<Key>& rolling_rig_keys();
/// Of a case of the micro-walking machine: [rig].
const std::vector<Key>& walking_rig_keys();

/// Of either list. Throws std::out_of_range.
const Key& rig_key(std::string_view path);

/// The keys of a case and those of its rig.
KeyList with_rig_keys(const KeyList& case_keys, const std::vector<Key>& rig_keys);

/// Whether the path is [printed], a quantity in it, or a part of one.
bool is_printed(std::string_view path);
/// Whether the path is [design.vary], a key of the case in it, or a part of that key's range.
bool is_varied_in_design(std::string_view path);
/// Whether the path is [correlation] or a pair of numbers in it.
bool is_correlation(std::string_view path);
/// Any of these: the names are checked by what reads them.
bool is_read_elsewhere(std::string_view path);

}  // namespace tricontact::io

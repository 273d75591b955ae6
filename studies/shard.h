#pragma once

#include <string>

namespace tricontact::studies {

/// Part i of n, from 1, of a study's points.
struct Shard {
    int i = 1, n = 1;

    /// By the point's key, so that a study that is extended keeps its shards.
    bool has(const std::string& key) const;
};

/// Of "i/n"; the whole of an empty text. Throws contact::InputError.
Shard shard_of(const std::string& text);

}  // namespace tricontact::studies

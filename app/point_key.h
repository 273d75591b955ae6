#pragma once

#include <string>

namespace tricontact::app {

/// Digest of the program's version and the resolved text of a case: what results depend on.
std::string point_key(const std::string& resolved);

/// Shard i of n, from 1, of a study's points.
struct Shard {
    int i = 1, n = 1;

    /// By the point's key, so that a study that is extended keeps its shards.
    bool has(const std::string& key) const;
};

}  // namespace tricontact::app

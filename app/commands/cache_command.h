#pragma once

#include <string>

namespace tricontact::app {

struct CacheOptions {
    std::string folder;  ///< as fem.cache; empty: that of the user
    bool clear = false;
};
/// Prints the condensed layers that are kept and the room that they take to standard output, or
/// removes them. Throws InputError.
void cache_command(const CacheOptions& options);

}  // namespace tricontact::app

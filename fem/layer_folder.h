#pragma once

#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace tricontact::fem {

/// A layer in the folder of a cache.
struct KeptLayer {
    std::string path;
    std::uint64_t bytes = 0;
    timespec used{};  ///< when it was last written or read
};

/// Ending of the name of a layer's file; before it stands the key.
inline constexpr const char* layer_file_ending = ".layer";

/// The layers in a folder, the one that was not used for longest first; nothing else that may be
/// there. Empty if there is no such folder.
std::vector<KeptLayer> kept_layers(const std::string& folder);

std::uint64_t bytes_of(const std::vector<KeptLayer>& layers);

/// Most bytes that the layers of a folder may take: TRICONTACT_CACHE_LIMIT, such as "500 MB", or
/// 10 GB. Throws contact::InputError if that is no size.
std::uint64_t cache_limit();

/// Removes the layers that were not used for longest until the others take `most` bytes at most;
/// the one with the path `kept` stays whatever its size.
void remove_oldest_layers(const std::string& folder, std::uint64_t most, const std::string& kept);

/// "402 MB".
std::string size_text(std::uint64_t bytes);

}  // namespace tricontact::fem

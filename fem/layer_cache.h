#pragma once

#include <cstdint>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fem/condensed_layer.h"
#include "files/partial_file.h"

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

/// "402 MB".
std::string size_text(std::uint64_t bytes);

/// Condensed layers in a folder, one file each, named by what they were made of. Processes may
/// share it: files appear complete or not at all. A file that is damaged, truncated or of another
/// version counts as absent. Files take cache_limit() bytes at most, or are one: those that were
/// not used for longest go.
class LayerCache {
  public:
    /// Empty folder: $TRICONTACT_CACHE, $XDG_CACHE_HOME/tricontact or ~/.cache/tricontact; "none":
    /// nothing is kept.
    /// Throws contact::InputError if the limit that the user set is no size.
    explicit LayerCache(const std::string& folder);

    /// Digest of mesh, materials, boundary conditions, element and file format.
    static std::string key(const LayerProblem& problem);
    /// The layer as it was stored, bit by bit. Empty, then `why` (if asked for) tells what is wrong
    /// with the file, or stays empty when there simply is none.
    std::optional<CondensedLayer> load(const std::string& key, std::string* why = nullptr) const;
    /// False, with nothing left behind, when it cannot be kept; `why` tells (disk full, read-only
    /// folder), or stays empty when nothing is to be kept.
    bool store(const std::string& key, const CondensedLayer& layer,
               std::string* why = nullptr) const;
    /// A layer that is there, or the task to make it.
    struct Claim {
        std::optional<CondensedLayer> layer;
        std::string why;  ///< see `load`
        /// Others wait for the layer until this is gone. Null where nothing is to be kept or nobody
        /// can be told.
        std::unique_ptr<files::PartialFile> reservation;
    };
    /// Waits, after `waits` was called, while another process makes the layer.
    Claim claim(const std::string& key, const std::function<void()>& waits) const;
    const std::string& folder() const { return folder_; }
    /// Where `key` is kept.
    std::string path_of(const std::string& key) const;

  private:
    bool keeps_nothing() const { return folder_.empty(); }
    std::unique_ptr<files::PartialFile> reserve(const std::string& key,
                                                const std::function<void()>& waits) const;

    std::string folder_;   // empty: none
    std::uint64_t limit_;  // [bytes]
};

/// Digest of the sources that condense a layer: a kept layer is that of the code that made it.
std::string_view condensing_sources_digest();

}  // namespace tricontact::fem

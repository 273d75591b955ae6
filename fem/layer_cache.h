#pragma once

#include <optional>
#include <string>

#include "fem/condensed_layer.h"

namespace tricontact::fem {

/// Condensed layers in a folder, one file each, named by what they were made of. Processes may
/// share it: files appear complete or not at all. A file that is damaged, truncated or of another
/// version counts as absent.
class LayerCache {
  public:
    /// Empty folder: $XDG_CACHE_HOME/tricontact or ~/.cache/tricontact; "none": nothing is kept.
    explicit LayerCache(const std::string& folder);

    /// Digest of mesh, materials, boundary conditions, element and file format.
    static std::string key(const LayerProblem& problem);
    std::optional<CondensedLayer> load(const std::string& key) const;
    /// False, with nothing left behind, when it cannot be kept (disk full, read-only folder).
    bool store(const std::string& key, const CondensedLayer& layer) const;
    const std::string& folder() const { return folder_; }

  private:
    std::string folder_;
};

}  // namespace tricontact::fem

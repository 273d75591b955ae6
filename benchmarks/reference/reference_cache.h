#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// reference(), or what was kept of the same case by the same program in files::cache_folder().
/// `identity`: whatever the result depends on beside the resolved case and the sources of this
/// room: the program's version and the digest of its models, digests of the files that the case
/// names. Files appear complete or not at all; one that is damaged, truncated or of another
/// version counts as absent. Those that were not used for longest go beyond 200 MB.
Reference kept_reference(const contact::Case& c, const contact::ModelRunner& runner,
                         std::string_view identity, const contact::Say& say = contact::silent);

/// The same in a folder; empty: nothing is kept.
Reference kept_reference_in(const std::string& folder, const contact::Case& c,
                            const contact::ModelRunner& runner, std::string_view identity,
                            const contact::Say& say = contact::silent);

/// A reference as bytes, but for its case and its digest, which are those that it is read for.
std::string written_reference(const Reference& reference);
/// Empty where the bytes are no whole reference.
std::optional<Reference> read_reference(std::string_view bytes, const contact::Case& c);

/// Digest of the sources that make references.
std::string_view reference_sources_digest();

}  // namespace tricontact::benchmarks

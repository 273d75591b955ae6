#pragma once

#include <string>

// Folders of this copy. In a unit of their own: what else is compiled is the same in each folder,
// and a compiler cache has it already.
namespace tricontact::paths {

/// One of the sources, as an absolute path; `name` from their root: "examples/cases/...".
std::string source(const std::string& name);
/// The program under test.
std::string program();
/// Tests share the layers that one of them condensed.
std::string layer_cache();

}  // namespace tricontact::paths

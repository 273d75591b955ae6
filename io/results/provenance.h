#pragma once

#include <string>

namespace tricontact::io {

/// Written into every file for ParaView as field data.
struct Provenance {
    std::string program_version;
    std::string command_line;
};

}  // namespace tricontact::io

#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tricontact::meshes {

/// A gmsh file, divided into its sections; their contents are not looked at yet.
struct MshFile {
    std::string name;   ///< in messages
    std::string bytes;  ///< of the whole file
    bool old = false;   ///< version 2.2, not 4.1
    bool binary = false;
    /// By name ("Nodes"), without the lines of the markers; views into `bytes`.
    std::map<std::string_view, std::string_view> sections;

    MshFile() = default;
    MshFile(const MshFile&) = delete;
    MshFile& operator=(const MshFile&) = delete;
};

/// Reads `path` into `file`. Throws contact::InputError: no such file, no gmsh file of version 2.2
/// or 4.1 with 8-byte numbers in this machine's order, no nodes or elements, a section that does
/// not end or stands twice, text between sections.
void open_msh_file(const std::string& path, MshFile& file);

/// Whether the sections of nodes and elements are there to their ends; false for no such file.
bool is_complete_mesh(const std::string& path);

}  // namespace tricontact::meshes

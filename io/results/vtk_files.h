#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Written into every file for ParaView as field data.
struct Provenance {
    std::string program_version;
    std::string command_line;
};

/// A file for ParaView, not yet written.
struct VtkFile {
    std::string extension;  ///< ".vti" ...
    std::string bytes;
};

/// The time of a state and what it is: the name of its array, see `time_in_*`.
struct Instant {
    const char* name;
    double time;
};
inline constexpr const char* time_in_seconds = "time_s";
inline constexpr const char* time_in_periods = "time_periods";  ///< of rolling, or rows of a path
inline constexpr const char* time_in_half_lengths = "time_half_lengths";  ///< of rolling on

/// Python for ParaView (paraview.simple): opens surface.ex2 and volume.ex2 of every model folder
/// beside the script, each in views of its own, coloured by normal traction or von Mises' stress,
/// warped by the displacement, and the models side by side with linked cameras. It holds no path:
/// `paraview --script=open_run.py` finds the folder that it lies in; Macros > Import new macro
/// that of a series which is open.
extern const std::string_view paraview_script;
/// Name of the macro beside a run's results.
inline constexpr const char* paraview_macro_name = "open_run.py";

/// Hexahedra and their boundary faces to look at. Positions in m; nodes in VTK's order.
struct MeshView {
    std::span<const std::array<double, 3>> points;
    std::span<const std::array<int, 8>> hexes;
    std::span<const std::uint8_t> regions;  ///< per hexahedron, an index into `region_names`
    std::span<const std::array<int, 4>> faces;
    std::span<const std::uint8_t> boundaries;  ///< per face, an index into `boundary_names`
    std::vector<std::string> region_names, boundary_names;
};

/// The mesh as one `.vtu`: hexahedra, then faces as quadrilaterals. Cell data: `dimension` (3 or 2)
/// tells them apart; `region` and `boundary` are 255 where they do not apply; field data: the names
/// that the numbers stand for. Throws contact::InputError if the file cannot be written,
/// std::invalid_argument for lists of different lengths.
void write_mesh_vtu(const std::string& path, const MeshView& mesh, const Provenance& provenance);

}  // namespace tricontact::io

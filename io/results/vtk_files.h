#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contact/compliances/interior.h"
#include "contact/surface.h"

namespace tricontact::io {

/// Written into every file for ParaView as field data.
struct Provenance {
    std::string program_version;
    std::string command_line;
};

/// A file of a series for ParaView, not yet written.
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

/// A contact surface: `.vti` (grid: point data; of a single row cell data, cells centred on the
/// points), `.vtp` (line: point data on vertices and a polyline) or `.vtu` (nodes: point data on
/// biquadratic quadrilaterals at z = 0, the contact state also as cell data). Throws
/// std::invalid_argument where a field has another size than the surface.
VtkFile vtk_file(const Instant& instant, const contact::Surface& surface,
                 const Provenance& provenance);

/// The inside of the substrate: `.vtu` of triquadratic hexahedra or `.vtr` of a rectilinear grid,
/// point data, with von Mises' stress and the mean pressure (compression positive) beside the
/// stress. Throws std::invalid_argument.
VtkFile vtk_file(const Instant& instant, const contact::Interior& interior,
                 const Provenance& provenance);

/// States over time whose cells differ, as of a walking machine (else StateSeries): files
/// `folder/name_000000.vti` (.vtp, .vtu; see vtk_file) and the
/// collection `folder/name.pvd`, whose times grow (`times_apart`) and which lists, but for those of
/// the last second, the files that are there. Vectors have three components, z out of the
/// substrate. The same states give the same bytes.
class VtkSeries {
  public:
    /// The folder must exist (see make_output_folder).
    VtkSeries(std::string folder, std::string name, Provenance provenance,
              const char* time_name = time_in_periods)
        : folder_(std::move(folder)),
          name_(std::move(name)),
          provenance_(std::move(provenance)),
          time_name_(time_name) {}

    /// Begins again: the first file comes next.
    void clear() {
        files_.clear();
        states_.clear();
        next_collection_ = {};
    }
    std::size_t last_size() const { return last_size_; }  ///< bytes of the last file
    /// Writes the next file of the series. Throws contact::InputError if that fails.
    template <class Fields>
    void add(double time, const Fields& fields) {
        add(time, vtk_file({time_name_, time}, fields, provenance_));
    }
    /// The same for a file that is made already, of a time that is not before that of the last.
    void add(double time, const VtkFile& file);
    /// What the n-th file of the series, from 0, shows is so again.
    void add_again(double time, std::size_t file);
    /// The collection lists all files. Throws contact::InputError if that fails.
    void list_all() const;
    /// The same, and all that was written in this file system is on the disk.
    void finish() const;

  private:
    struct State {
        double time;
        std::size_t file;  // in files_
    };
    std::string path_of(const std::string& name) const;
    std::string collection() const;

    std::string folder_, name_;
    Provenance provenance_;
    const char* time_name_;
    std::vector<State> states_;
    std::vector<std::string> files_;
    std::size_t last_size_ = 0;
    std::chrono::steady_clock::time_point next_collection_{};
};

/// Times that do not decrease, set apart, since ParaView shows one state at a time: of states at
/// one time the last keeps it, the others come before it at equal distances, after all that was
/// earlier; the first ones as far apart as the following states are.
std::vector<double> times_apart(const std::vector<double>& times);

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

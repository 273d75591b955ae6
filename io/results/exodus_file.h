#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/compliances/interior.h"
#include "contact/mirrored_surface.h"
#include "io/results/netcdf_file.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

/// Elements of one kind.
struct ExodusBlock {
    std::string name;     ///< "surface"
    std::string element;  ///< "QUAD4", as Exodus II names it
    int nodes_per_element = 0;
    std::vector<std::int32_t> nodes = {};  ///< of the elements one after another, from 1

    std::size_t size() const { return nodes.size() / static_cast<std::size_t>(nodes_per_element); }
    bool operator==(const ExodusBlock&) const = default;
};

/// Elements and their nodes, the same in all states of a file.
struct ExodusMesh {
    std::vector<std::array<double, 3>> points = {};  ///< [m]
    std::vector<ExodusBlock> blocks = {};
    /// For who reads the file: units, axes, what numbers stand for.
    std::string remark = "SI units, z out of the substrate; contact_state 0 open 1 stick 2 slip";
    /// What reads the surface again needs: n_x, n_y, first, spacing.
    std::vector<double> grid = {};
    std::string layout = {};  ///< "grid", "line", "nodes", or none
    bool operator==(const ExodusMesh&) const = default;
};
ExodusMesh mesh_of(const contact::SurfaceView& surface);
ExodusMesh mesh_of(const contact::Interior& interior);
/// Told by numbers of a grid alone; of other points only mesh_of tells it.
bool is_grid_of(const ExodusMesh& mesh, const contact::SurfaceView& surface);
inline bool is_grid_of(const ExodusMesh&, const contact::Interior&) {
    return false;
}

/// How many points the file has for those whose values are given.
struct ExodusRows {
    int copies = 1;  ///< so many rows of points have the same values
    /// Columns of a grid whose rows at y >= 0 are given, that at y = 0 first: those at y < 0 come
    /// before them, with the other sign of y components. 0: all points are given.
    int mirrored_columns = 0;
};

/// Fields of a state on such a mesh as the file has them: single precision, numbers of states and
/// components that nothing gives, zeros, as bytes. A vector is name_x, name_y, name_z, which
/// readers put together; displacement_m is called elastic_displacement_m, since readers would move
/// the mesh by what is called displacement.
class ExodusFields {
  public:
    struct Field {
        std::string name;
        bool is_byte, is_of_elements;
        std::size_t n_bytes;
        const char* bytes;  ///< of these ExodusFields; null: zeros
    };
    /// Forgets all; the memory serves the next state.
    void begin(const ExodusRows& rows);

    // As those of VtkXml; all throw std::invalid_argument for another number of values than `n`.
    void add_scalar(std::string_view name, std::span<const double> values, std::size_t n);
    void add_vector(std::string_view name, const std::array<std::span<const double>, 3>& components,
                    std::size_t n, double z_sign = 1);
    void add_vector(std::string_view name, std::span<const std::array<double, 3>> values,
                    std::size_t n);
    void add_tensor(std::string_view name, std::span<const std::array<double, 6>> values,
                    std::size_t n);
    void add_bytes(std::string_view name, std::span<const std::uint8_t> values, std::size_t n);
    /// What comes next belongs to elements, those of all blocks one after another.
    void begin_elements() { is_of_elements_ = true; }
    /// One number of the state.
    void add_number(std::string name, double value) { numbers_.emplace_back(name, value); }

    const std::vector<Field>& fields() const { return fields_; }
    const std::vector<std::pair<std::string, double>>& numbers() const { return numbers_; }

  private:
    /// Of a field, kept from state to state.
    struct Memory {
        std::unique_ptr<char[]> bytes;
        std::size_t size = 0;
    };
    void add_component(std::string name, const double* values, std::size_t stride, std::size_t n,
                       double sign, bool is_odd = false);
    /// `n_bytes`: of one copy.
    void add_zeros(std::string name, std::size_t n_bytes, bool is_byte);
    /// What is in memory(): one copy is there.
    void add_copies(std::string name, bool is_byte, std::size_t once);
    /// Of what is added next.
    char* memory(std::size_t n_bytes);
    /// Points that the file has for `n`: of one copy.
    std::size_t n_once(std::size_t n) const {
        return rows_.mirrored_columns > 0 ? 2 * n - static_cast<std::size_t>(rows_.mirrored_columns)
                                          : n;
    }

    ExodusRows rows_;
    bool is_of_elements_ = false;
    std::vector<Field> fields_;
    std::vector<std::pair<std::string, double>> numbers_;
    std::vector<Memory> memory_;
    std::size_t n_used_ = 0;  // of the memory
};

/// Names and kinds of the fields of a file.
struct ExodusNames {
    struct Field {
        std::string name;
        bool is_byte, is_of_elements;
        bool operator==(const Field&) const = default;
    };
    std::vector<Field> fields;
    std::vector<std::string> numbers;

    /// Adds what is missing; a field that was bytes and is not gets single precision. Whether there
    /// was anything.
    bool take(const ExodusFields& state);
};

/// A file of such states in Exodus II: header, mesh and names, placed.
NetcdfLayout exodus_layout(const ExodusMesh& mesh, const ExodusNames& names,
                           const Provenance& provenance);
}  // namespace tricontact::io

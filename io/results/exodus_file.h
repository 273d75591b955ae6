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
#include "contact/surface.h"
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
ExodusMesh mesh_of(const contact::Surface& surface);
ExodusMesh mesh_of(const contact::Interior& interior);
/// Told by numbers of a grid alone; of other points only mesh_of tells it.
bool is_grid_of(const ExodusMesh& mesh, const contact::Surface& surface);
inline bool is_grid_of(const ExodusMesh&, const contact::Interior&) {
    return false;
}

/// Fields of a state on such a mesh as the file has them: single precision, numbers of states and
/// components that are 0 throughout as bytes. A vector is name_x, name_y, name_z, which readers put
/// together; displacement_m is called elastic_displacement_m, since readers would move the mesh by
/// what is called displacement.
class ExodusFields {
  public:
    struct Field {
        std::string name;
        bool is_byte, is_of_elements;
        std::size_t n_bytes;
        std::unique_ptr<char[]> bytes;  ///< none: zeros
    };
    /// `copies`: so many rows of points have the same values.
    explicit ExodusFields(int copies = 1) : copies_(copies) {}

    // As those of VtkXml; all throw std::invalid_argument for another number of values.
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
    void add_component(std::string name, const double* values, std::size_t stride, std::size_t n,
                       double sign);
    void add_zeros(std::string name, std::size_t n);

    int copies_;
    bool is_of_elements_ = false;
    std::vector<Field> fields_;
    std::vector<std::pair<std::string, double>> numbers_;
};
ExodusFields fields_of(const Instant& instant, const contact::Surface& surface);
ExodusFields fields_of(const Instant& instant, const contact::Interior& interior);

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

#include "contact/surface.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "comparisons/differences/results_folder.h"
#include "io/results/surface_file.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::ContactState;
using contact::Surface;

namespace {

struct Field {
    const char* name;
    std::vector<double> Surface::*values;
};

constexpr std::array<Field, 19> fields{{
    {"normal_traction_Pa", &Surface::normal_traction},
    {"tension_Pa", &Surface::tension},
    {"separation_work_J_per_m2", &Surface::separation_work},
    {"tangential_traction_x_Pa", &Surface::tangential_traction_x},
    {"tangential_traction_y_Pa", &Surface::tangential_traction_y},
    {"friction_bound_Pa", &Surface::friction_bound},
    {"displacement_x_m", &Surface::displacement_x},
    {"displacement_y_m", &Surface::displacement_y},
    {"gap_m", &Surface::gap},
    {"slip_x_m", &Surface::slip_x},
    {"slip_y_m", &Surface::slip_y},
    {"dissipation_J_per_m2", &Surface::dissipation},
    {"slip_path_m", &Surface::slip_path},
    {"friction_work_J_per_m2", &Surface::friction_work},
    {"normal_traction_consistent_Pa", &Surface::normal_traction_consistent},
    {"tangential_traction_x_consistent_Pa", &Surface::tangential_traction_x_consistent},
    {"tangential_traction_y_consistent_Pa", &Surface::tangential_traction_y_consistent},
    {"normal_line_load_N_per_m", &Surface::normal_line_load},
    {"tangential_line_load_N_per_m", &Surface::tangential_line_load},
}};
constexpr const char* state_name = "contact_state";
constexpr const char* height_name = "displacement_z_m";

bool is_grid(const Surface& s) {
    return s.n_x > 0;
}

/// (n_y, n_x) of a grid and of a line, else (n).
std::vector<py::ssize_t> shape_of(const Surface& s) {
    if (is_grid(s)) return {s.n_y, s.n_x};
    return {static_cast<py::ssize_t>(s.size())};
}

template <class T>
py::array view_of(const Surface& s, const T* first, const py::object& owner) {
    const py::ssize_t size = sizeof(T);
    std::vector<py::ssize_t> strides{size};
    if (is_grid(s)) strides.insert(strides.begin(), size * s.n_x);
    return view(first, shape_of(s), strides, owner);
}

/// z out of the substrate, as in the files for ParaView.
py::array outward(const Surface& s) {
    py::array_t<double> values(shape_of(s));
    std::ranges::transform(s.displacement_z, values.mutable_data(),
                           [](double inward) { return 0. - inward; });  // without -0
    values.attr("setflags")(py::arg("write") = false);
    return values;
}

std::vector<std::string> field_names(const Surface& s) {
    std::vector<std::string> names;
    for (const Field& field : fields)
        if (!(s.*field.values).empty()) names.emplace_back(field.name);
    if (!s.displacement_z.empty()) names.emplace_back(height_name);
    if (!s.contact_state.empty()) names.emplace_back(state_name);
    return names;
}

py::array field(const py::object& self, const std::string& name) {
    const auto& s = self.cast<const Surface&>();
    if (name == state_name && !s.contact_state.empty()) {
        static_assert(sizeof(ContactState) == sizeof(std::uint8_t));
        return view_of(s, reinterpret_cast<const std::uint8_t*>(s.contact_state.data()), self);
    }
    if (name == height_name && !s.displacement_z.empty()) return outward(s);
    for (const Field& field : fields)
        if (field.name == name && !(s.*field.values).empty())
            return view_of(s, (s.*field.values).data(), self);
    refuse_key("field", name, field_names(s));
}

/// Of the columns or rows of a grid; of all points where there is none.
py::array positions(const py::object& self, int axis) {
    const auto& s = self.cast<const Surface&>();
    if (!is_grid(s)) return view(axis == 0 ? s.node_x : s.node_y, self);
    const int n = axis == 0 ? s.n_x : s.n_y;
    py::array_t<double> positions(n);
    for (int i = 0; i < n; ++i) positions.mutable_at(i) = axis == 0 ? s.x(i) : s.y(i);
    return positions;
}

/// Of each model of a folder of results the times, files and states in them of its
/// surfaces, paths as bytes.
py::dict saved_surfaces(const std::string& folder) {
    py::dict models;
    for (const comparisons::SavedRun& run : comparisons::read_results_folder(folder).runs) {
        py::list files;
        for (const io::SeriesFile& file : run.surfaces)
            files.append(py::make_tuple(file.time, py::bytes(file.path), file.state));
        models[py::str(run.model)] = files;
    }
    return models;
}

const char* layout_of(const Surface& s) {
    if (s.layout == Surface::Layout::grid) return "grid";
    return s.layout == Surface::Layout::line ? "line" : "nodes";
}

}  // namespace

void add_surface(py::module_& module) {
    py::class_<Surface>(
        module, "Surface",
        "Fields of the contact surface by their names, as NumPy arrays that share the memory of\n"
        "the run: of the shape (n_y, n_x) on a grid, (1, n) along a line, (n,) on other nodes.\n"
        "Signs as in the files for ParaView: z is out of the substrate, tractions act on it,\n"
        "normal traction is positive in compression.")
        .def_property_readonly("fields", field_names, "Names of the fields, with units.")
        .def("__getitem__", field, py::arg("name"), "A field. Raises KeyError.")
        .def("to_xarray", passed_on("labelled", "surface"),
             "All fields as a Dataset over their positions. Raises ImportError.")
        .def("plot", passed_on("plots", "surface"),
             "A field as a map, of springs along their line, with matplotlib. Raises ImportError.")
        .def_property_readonly("layout", layout_of, "\"grid\", \"line\" or \"nodes\".")
        .def_property_readonly(
            "shape", [](const Surface& s) { return py::tuple(py::cast(shape_of(s))); },
            "Shape of the fields.")
        .def_property_readonly(
            "x", [](const py::object& self) { return positions(self, 0); },
            "Positions [m] along x: of the grid's columns, or of all nodes.")
        .def_property_readonly(
            "y", [](const py::object& self) { return positions(self, 1); },
            "Positions [m] along y: of the grid's rows, or of all nodes.")
        .def_property_readonly(
            "offset", [](const Surface& s) { return py::make_tuple(s.offset[0], s.offset[1]); },
            "Position (x, y) of the indenter [m]");
    module.def("_saved_surfaces", saved_surfaces, py::arg("folder"));
    module.def("_read_surface", io::read_surface_file, py::arg("path"), py::arg("state"));
}

}  // namespace tricontact::python

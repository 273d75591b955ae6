#include "benchmarks/submissions/own_surface.h"

#include "io/keys/input_file.h"
#include "io/results/surface_file.h"

namespace tricontact::benchmarks {

namespace {

using RunSurface = contact::Surface;

struct Positions {
    std::vector<double> x, y;
};

/// About the indenter, which a rolling contact follows.
Positions positions_of(const RunSurface& s) {
    Positions at;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const bool are_nodes = s.layout == RunSurface::Layout::nodes;
        const int n_x = are_nodes ? 1 : s.n_x;
        const int column = static_cast<int>(i) % n_x, row = static_cast<int>(i) / n_x;
        at.x.push_back((are_nodes ? s.node_x[i] : s.x(column)) - s.offset[0]);
        at.y.push_back((are_nodes ? s.node_y[i] : s.y(row)) - s.offset[1]);
    }
    return at;
}

}  // namespace

MeshField read_own_surface(const std::string& file) {
    io::note_input_file(file);
    const RunSurface s = io::read_surface_file(file, io::last_state);
    MeshField field;
    field.file = file;
    field.format = "Tricontact";
    const auto add = [&](const char* name, Meaning meaning, const char* unit,
                         const std::vector<double>& values) {
        if (values.size() == s.size()) field.columns.push_back({name, meaning, unit, values});
    };
    const Positions at = positions_of(s);
    const bool is_line = s.layout == RunSurface::Layout::line;
    add("x", Meaning::x, "m", at.x);
    if (!is_line) add("y", Meaning::y, "m", at.y);
    add("normal_traction_Pa", Meaning::pressure, "Pa", s.normal_traction);
    add("tangential_traction_x", Meaning::traction_x, "Pa", s.tangential_traction_x);
    if (!is_line) add("tangential_traction_y", Meaning::traction_y, "Pa", s.tangential_traction_y);
    add("displacement_x", Meaning::displacement_x, "m", s.displacement_x);
    if (!is_line) add("displacement_y", Meaning::displacement_y, "m", s.displacement_y);
    add("displacement_z", Meaning::displacement_z, "m", s.displacement_z);
    if (s.layout == RunSurface::Layout::grid)
        add("area", Meaning::area, "m2",
            std::vector<double>(s.size(), s.spacing[0] * s.spacing[1]));
    field.notes.push_back("a surface of tricontact run, SI units, tractions on the substrate");
    return field;
}

}  // namespace tricontact::benchmarks

#include "io/results/surface_file.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "io/keys/input_file.h"
#include "io/results/atomic_file.h"
#include "io/results/netcdf_file.h"
#include "io/results/state_series.h"

namespace tricontact::io {

namespace {

using contact::Surface;

constexpr std::size_t most_points = 20'000'000;

/// A file of a StateSeries of surfaces.
class SavedStates {
  public:
    explicit SavedStates(const std::string& path) : reader_(path) {
        note_input_file(path);
        if (layout_text().empty()) reader_.refuse("is no surface of a contact");
        const std::size_t n = reader_.layout().length("num_nodes");
        if (n == 0 || n > most_points) reader_.refuse("has no sound number of points");
        fields_ = names("name_nod_var");
        numbers_ = names("name_glo_var");
        const NetcdfAttribute* grid = reader_.layout().attribute("tricontact_grid");
        grid_ = grid ? from_big_endian<double>(grid->values) : std::vector<double>();
        if (grid_.size() != 6) reader_.refuse("has no sound grid");
    }
    NetcdfReader& reader() { return reader_; }
    std::string layout_text() const {
        const NetcdfAttribute* found = reader_.layout().attribute("tricontact_layout");
        return found ? found->values : "";
    }
    const std::vector<double>& grid() const { return grid_; }

    std::vector<double> field(std::string_view name, std::size_t n, std::size_t record) {
        const auto k = std::ranges::find(fields_, name) - fields_.begin();
        if (k == std::ssize(fields_)) return {};
        const std::string variable = "vals_nod_var" + std::to_string(k + 1);
        const std::string bytes = reader_.bytes(variable, record);
        std::vector<double> values;
        if (reader_.layout().find(variable)->type == NetcdfType::byte)
            values.assign(bytes.begin(), bytes.end());
        else
            for (const float value : from_big_endian<float>(bytes)) values.push_back(value);
        if (values.size() < n) reader_.refuse("has an array of another size than its points");
        values.resize(n);  // without padding and a second row
        return values;
    }
    double number(std::string_view name, std::size_t record) {
        const auto k = std::ranges::find(numbers_, name) - numbers_.begin();
        const auto values = from_big_endian<double>(reader_.bytes("vals_glo_var", record));
        return k < std::ssize(values) ? values[static_cast<std::size_t>(k)] : 0;
    }
    double time(std::size_t record) {
        for (const char* name : {time_in_seconds, time_in_periods, time_in_half_lengths})
            if (std::ranges::find(numbers_, name) != numbers_.end()) return number(name, record);
        return from_big_endian<double>(reader_.bytes("time_whole", record)).at(0);
    }

  private:
    std::vector<std::string> names(std::string_view variable) {
        const std::string table = reader_.bytes(variable);
        const std::size_t length = reader_.layout().length("len_name");
        std::vector<std::string> names;
        for (std::size_t at = 0; length > 0 && at + length <= table.size(); at += length)
            names.emplace_back(table.substr(at, length).c_str());
        return names;
    }

    NetcdfReader reader_;
    std::vector<std::string> fields_, numbers_;
    std::vector<double> grid_;
};

Surface layout_of(SavedStates& states) {
    Surface s;
    const auto& grid = states.grid();
    const bool is_nodes = states.layout_text() == "nodes";
    s.layout = is_nodes                         ? Surface::Layout::nodes
               : states.layout_text() == "line" ? Surface::Layout::line
                                                : Surface::Layout::grid;
    const double n_x = grid[0], n_y = grid[1];
    if (!(n_x >= 0) || !(n_y >= 0) || !(n_x * n_y <= static_cast<double>(most_points)))
        states.reader().refuse("has no sound grid");
    s.n_x = static_cast<int>(n_x), s.n_y = static_cast<int>(n_y);
    s.first = {grid[2], grid[3]};
    s.spacing = {grid[4], grid[5]};
    const std::size_t n = states.reader().layout().length("num_nodes");
    if (!is_nodes) {
        if (s.size() == 0 || s.size() > n) states.reader().refuse("has no sound grid");
        return s;
    }
    s.node_x = from_big_endian<double>(states.reader().bytes("coordx"));
    s.node_y = from_big_endian<double>(states.reader().bytes("coordy"));
    if (s.node_x.size() != n || s.node_y.size() != n) states.reader().refuse("has no points");
    const auto nodes = from_big_endian<std::int32_t>(states.reader().bytes("connect1"));
    s.quads.resize(nodes.size() / 9);
    for (std::size_t i = 0; i < 9 * s.quads.size(); ++i) {
        if (nodes[i] < 1 || nodes[i] > static_cast<std::int32_t>(n))
            states.reader().refuse("has a cell of points that are not there");
        s.quads[i / 9][i % 9] = nodes[i] - 1;
    }
    return s;
}

}  // namespace

Surface read_surface_file(const std::string& path, int state) {
    SavedStates states(path);
    const std::size_t n_records = states.reader().n_records();
    if (n_records == 0) states.reader().refuse("has no states");
    const std::size_t record =
        state == last_state ? n_records - 1 : static_cast<std::size_t>(state);
    Surface s = layout_of(states);
    const auto field = [&](const char* name) { return states.field(name, s.size(), record); };
    s.normal_traction = field("normal_traction_Pa");
    if (s.normal_traction.empty()) states.reader().refuse("has no normal_traction_Pa");
    s.tension = field("tension_Pa");
    s.separation_work = field("separation_work_J_per_m2");
    s.tangential_traction_x = field("tangential_traction_Pa_x");
    s.tangential_traction_y = field("tangential_traction_Pa_y");
    s.friction_bound = field("friction_bound_Pa");
    s.displacement_x = field("elastic_displacement_m_x");
    s.displacement_y = field("elastic_displacement_m_y");
    s.displacement_z = field("elastic_displacement_m_z");
    for (double& into : s.displacement_z) into = -into;
    s.gap = field("gap_m");
    s.slip_x = field("slip_m_x");
    s.slip_y = field("slip_m_y");
    for (const double value : field("contact_state")) {
        if (!(value >= 0 && value <= 2)) states.reader().refuse("has a contact_state that is none");
        s.contact_state.push_back(static_cast<contact::ContactState>(static_cast<int>(value)));
    }
    s.normal_line_load = field("normal_line_load_N_per_m");
    s.tangential_line_load = field("tangential_line_load_N_per_m");
    s.offset = {states.number("indenter_position_m_x", record),
                states.number("indenter_position_m_y", record)};
    return s;
}

std::vector<SeriesFile> read_state_series(const std::string& path) {
    std::vector<SeriesFile> files;
    const std::string stem =
        path.substr(0, path.size() - std::string_view(states_extension).size());
    std::string one = path;
    std::error_code ignored;
    for (int number = 2; std::filesystem::exists(one, ignored); ++number) {
        SavedStates states(one);
        for (std::size_t i = 0; i < states.reader().n_records(); ++i)
            files.push_back({states.time(i), one, static_cast<int>(i)});
        one = stem + "_" + std::to_string(number) + states_extension;
    }
    return files;
}

bool is_state_series(const std::string& path) {
    constexpr std::size_t most = 16384;
    return path.ends_with(states_extension) &&
           first_bytes(path, most).find("tricontact_layout") != std::string::npos;
}

}  // namespace tricontact::io

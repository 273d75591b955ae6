#include "io/tables/path_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tricontact::io {

namespace {

using contact::NormalControl;
using contact::PrescribedPath;
using contact::TangentialControl;
using Column = std::vector<double>;

constexpr int most_steps_of_row = 100'000;

const CsvForm path_form{"path", "time [s], normal_force [N], tangential_force_x [N], offset_x [mm]",
                        20'000, "thin it out: loads change linearly from row to row", 8};

Column column(const CsvTable& table, std::string_view name, Dimension dimension) {
    return table.has(name) ? table.values(name, dimension) : Column(table.n_rows(), 0.);
}

/// Which of two columns that prescribe the same in two ways is there; empty: neither.
std::optional<std::string> either(const CsvTable& table, const std::string& first,
                                  const std::string& second) {
    if (table.has(first) && table.has(second))
        table.refuse_header("the columns " + first + " and " + second +
                            " contradict each other: one of the two is prescribed");
    if (table.has(first)) return first;
    return table.has(second) ? std::optional(second) : std::nullopt;
}

void check_pressed(const CsvTable& table, const std::string& name, const Column& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i == 0 ? values[i] < 0 : !(values[i] > 0))
            table.refuse_value(
                i, name, i == 0 ? "must not be negative" : "contact is lost on the path",
                "keep it positive, unless [adhesion] holds the bodies; the first row alone may be "
                "0");
}

/// Where the surfaces attract each other they may be pulled, too.
void check_attracted(const CsvTable& table, const std::string& name, const Column& values,
                     bool by_force) {
    if (by_force && values.front() < 0)
        table.refuse_value(0, name, "pulls at what has not touched yet", "let it begin with 0");
    if (std::ranges::none_of(values, [](double value) { return value > 0; }))
        table.refuse_header("nothing is pressed in any row: give a row with a positive " + name);
}

void set_normal(const CsvTable& table, bool may_pull, PrescribedPath& path) {
    const auto name = either(table, "normal_force", "indentation");
    if (!name) table.refuse_header("has neither a column normal_force nor indentation");
    const bool by_force = *name == "normal_force";
    const Column values = table.values(*name, by_force ? Dimension::force : Dimension::length);
    if (may_pull)
        check_attracted(table, *name, values, by_force);
    else
        check_pressed(table, *name, values);
    for (std::size_t i = 0; i < values.size(); ++i)
        path.rows[i].normal = {
            by_force ? NormalControl::Kind::force : NormalControl::Kind::indentation, values[i]};
}

void set_tangential(const CsvTable& table, int d, PrescribedPath& path) {
    const std::string axis = d == 0 ? "x" : "y";
    const auto name = either(table, "tangential_force_" + axis, "shift_" + axis);
    if (!name) return;
    const bool by_force = name->starts_with("tangential");
    const Column values = table.values(*name, by_force ? Dimension::force : Dimension::length);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i == 0 && values[i] != 0 && path.starts_unloaded())
            table.refuse_value(i, *name, "nothing is pressed in the first row",
                               "let it begin with 0, or press in that row");
        path.rows[i].tangential[d] = {
            by_force ? TangentialControl::Kind::force : TangentialControl::Kind::shift, values[i]};
    }
}

void set_steps(const CsvTable& table, int steps, PrescribedPath& path) {
    const Column values =
        table.has("steps") ? table.values("steps", Dimension::none) : Column(table.n_rows(), steps);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] >= 0) || values[i] > most_steps_of_row ||
            values[i] != std::floor(values[i]))
            table.refuse_value(
                i, "steps", "must be a whole number from 0 to " + std::to_string(most_steps_of_row),
                "correct it");
        path.rows[i].steps = static_cast<int>(values[i]);
    }
}

void set_motion(const CsvTable& table, PrescribedPath& path) {
    const Column time = column(table, "time", Dimension::time),
                 x = column(table, "offset_x", Dimension::length),
                 y = column(table, "offset_y", Dimension::length),
                 rotation = column(table, "rotation", Dimension::angle),
                 bulk_stress = column(table, "bulk_stress", Dimension::pressure);
    if (table.has("time"))
        table.check_increasing("time", "times must increase from row to row", "sort the table");
    for (std::size_t i = 0; i < path.rows.size(); ++i) {
        if (i == 0 && rotation[i] != 0 && path.starts_unloaded())
            table.refuse_value(i, "rotation", "nothing is pressed in the first row",
                               "let it begin with 0, or press in that row");
        if (i == 0 && bulk_stress[i] != 0 && path.starts_unloaded())
            table.refuse_value(i, "bulk_stress", "nothing is pressed in the first row",
                               "let it begin with 0, or press in that row");
        path.rows[i].bulk_stress = bulk_stress[i];
        path.rows[i].time = time[i];
        path.rows[i].offset = {x[i], y[i]};
        path.rows[i].rotation = rotation[i];
    }
}

}  // namespace

PrescribedPath read_path(const CsvTable& table, int steps, bool may_pull) {
    table.check_names({"time", "offset_x", "offset_y", "rotation", "bulk_stress", "steps",
                       "normal_force", "indentation", "tangential_force_x", "tangential_force_y",
                       "shift_x", "shift_y"});
    if (table.n_rows() < 2) table.refuse_header("fewer than two rows are no path");
    PrescribedPath path{std::vector<PrescribedPath::Row>(table.n_rows())};
    set_normal(table, may_pull, path);
    set_tangential(table, 0, path);
    set_tangential(table, 1, path);
    set_motion(table, path);
    set_steps(table, steps, path);
    return path;
}

PrescribedPath read_path_file(const std::string& path, int steps, bool may_pull) {
    return read_path(read_csv_table(path, path_form), steps, may_pull);
}

PrescribedPath read_path_text(const std::string& text, const std::string& name, int steps,
                              bool may_pull) {
    return read_path(CsvTable(text, name, path_form), steps, may_pull);
}

}  // namespace tricontact::io

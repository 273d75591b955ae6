#include <algorithm>
#include <filesystem>
#include <utility>

#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/loop_table.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"
#include "io/tables/divided_text.h"
#include "io/tables/force_curve.h"

namespace tricontact::experiments {

using Measurement = IdentificationInput::Measurement;

std::span<const TableKey> table_keys() {
    static constexpr TableKey keys[] = {
        {Measurement::static_shift, "static-shift", "measurement.static_shift", ""},
        {Measurement::force_indentation, "force-indentation", "measurement.force_indentation", ""},
        {Measurement::contact_radius, "contact-radius", "measurement.contact_radius", ""},
        {Measurement::force_relaxation, "force-relaxation", "measurement.force_relaxation",
         "measurement.held_indentation"},
        {Measurement::indentation_creep, "indentation-creep", "measurement.indentation_creep",
         "measurement.held_force"},
        {Measurement::rolling_shift, "rolling-shift", "measurement.rolling_shift", ""},
        {Measurement::sliding_force, "sliding-force", "measurement.sliding_force", ""},
        {Measurement::friction_loop, "friction-loop", "measurement.friction_loop", ""}};
    return keys;
}

std::string_view name_of(Measurement measurement) {
    return table_keys()[static_cast<std::size_t>(measurement)].name;
}

std::string name_of(const IdentificationInput::Table& table) {
    std::string name(name_of(table.measurement));
    return table.label.empty() ? name : name + " (" + table.label + ")";
}

std::string_view key_of(Measurement measurement) {
    return table_keys()[static_cast<std::size_t>(measurement)].key;
}

const MeasuredColumns& columns_of(Measurement measurement) {
    using enum io::Dimension;
    static const MeasuredColumns columns[] = {
        // in the order of Measurement
        {{"tangential_force", "tangential force F_T", force},
         {"shift", "static shift U", length},
         "tangential_force [N], shift [um], shift_error [um]"},
        {{"indentation", "indentation d", length},
         {"normal_force", "normal force F_N", force},
         "indentation [um], normal_force [N], normal_force_error [N]"},
        {{"normal_force", "normal force F_N", force},
         {"contact_radius", "contact radius a", length},
         "normal_force [N], contact_radius [mm], contact_radius_error [mm]"},
        {{"time", "time t", time},
         {"normal_force", "normal force F_N", force},
         "time [s], normal_force [N], normal_force_error [N]"},
        {{"time", "time t", time},
         {"indentation", "indentation d", length},
         "time [s], indentation [um], indentation_error [um]"},
        {{"offset", "rolling offset W", length},
         {"shift", "shift U", length},
         "offset [mm], shift [um], shift_error [um]"},
        {{"normal_force", "normal force F_N", force},
         {"sliding_force", "sliding force F_lim", force},
         "normal_force [N], sliding_force [N], sliding_force_error [N]"},
        {{"shift", "shift U", length},
         {"tangential_force", "tangential force F_T", force},
         loop_table_header}};
    return columns[static_cast<int>(measurement)];
}

namespace {

/// Force curves of instruments begin before the contact does, and count depths from anywhere.
void check_touches(const io::CsvTable& table, std::string_view depth, std::string_view force) {
    const auto depths = table.values(depth, io::Dimension::length),
               forces = table.values(force, io::Dimension::force);
    const std::string remedy =
        "add \"zero_depth\" to measurement.find, or leave out the rows before contact";
    for (std::size_t row = 0; row < depths.size(); ++row) {
        if (!(depths[row] > 0))
            table.refuse_value(row, depth,
                               "there is no contact at this depth, counted from where "
                               "it begins",
                               remedy);
        if (!(forces[row] > 0))
            table.refuse_value(row, force, "there is no contact without a force", remedy);
    }
}

constexpr std::size_t most_rows = 10'000;
constexpr std::size_t most_megabytes = 16;  // instruments write all their channels

std::string few_rows(std::size_t n, std::size_t least) {
    return "the table has " + std::to_string(n) +
           " rows, which do not determine the values to be found and how well they are known: " +
           std::to_string(least) + " at least";
}

/// As an instrument exports it, with all its segments.
void read_force_curve(IdentificationInput::Table& measured, const std::string& text,
                      const std::string& name, std::size_t least_rows) {
    if (measured.measurement != Measurement::force_indentation)
        io::fail(name, "",
                 "this is a force curve, which is read for measurement.force_indentation alone",
                 "write a table of its segment for " + std::string(key_of(measured.measurement)));
    if (!measured.has_free_zero)
        io::fail(name, "", "the heights of a force curve count from anywhere",
                 "add \"zero_depth\" to measurement.find");
    io::ForceCurve curve = io::force_curve(text, name, most_rows, measured.is_adhesive);
    if (curve.depth.size() < least_rows)
        io::fail(name, "", few_rows(curve.depth.size(), least_rows), "export the whole approach");
    if (!(std::ranges::max(curve.force) > 0))
        io::fail(name, "", "no force is positive", "turn the sign of vDeflection");
    measured.given = std::move(curve.depth);
    measured.observed = std::move(curve.force);
    measured.reading = std::move(curve.reading);
    keep_adhesive_rows(measured, name);
    if (measured.given.size() < least_rows)
        io::fail(name, "", few_rows(measured.given.size(), least_rows),
                 "export all of approach and retraction; rows beyond the jumps are left out");
}

}  // namespace

void read_measured_table(IdentificationInput::Table& measured, std::size_t least_rows) {
    const std::string name = measured.label.empty()
                                 ? std::filesystem::path(measured.data_file).filename().string()
                                 : measured.label;
    const std::string text = io::utf8_text(
        io::read_input_file(measured.data_file, "table of a measurement", most_megabytes), name);
    if (measured.measurement == Measurement::friction_loop)
        return read_loop_table(measured, text, name);
    if (io::is_force_curve(text)) return read_force_curve(measured, text, name, least_rows);
    const auto& [given, observed, example] = columns_of(measured.measurement);
    const std::string error_column = std::string(observed.name) + "_error";
    const io::CsvTable table(text, name,
                             {.kind = "table of a measurement",
                              .header = std::string(example),
                              .most_rows = most_rows,
                              .thinning = "thin it out, or take means"});
    // Shifts may be those under several loads.
    const bool is_shift = measured.measurement == Measurement::static_shift;
    const std::string_view load_column = is_shift ? "normal_force" : given.name;
    // Depths of a curve that is steep here and flat there have errors that are worth stating.
    const bool is_pulled =
        measured.is_adhesive && measured.measurement == Measurement::force_indentation;
    const std::string given_error_column = std::string(given.name) + "_error";
    table.check_names({given.name, observed.name, error_column, load_column,
                       is_pulled ? std::string_view(given_error_column) : load_column});
    if (is_shift && table.has(load_column)) {
        measured.normal_forces = table.values(load_column, io::Dimension::force);
        table.check_positive(load_column);
    }
    measured.given = table.values(given.name, given.dimension);
    measured.observed = table.values(observed.name, observed.dimension);
    const bool is_rolled = measured.measurement == Measurement::rolling_shift;
    const bool may_pull = measured.is_adhesive;
    if (measured.measurement == Measurement::force_indentation && !measured.has_free_zero &&
        !may_pull)
        check_touches(table, given.name, observed.name);
    if (!is_rolled && !measured.has_free_zero && !may_pull) table.check_positive(given.name);
    // A shift may be lost in noise, and so may forces before contact; a force or radius that is not
    // there was not measured.
    if (!is_rolled && !measured.has_free_zero && !is_shift && !is_pulled)
        table.check_positive(observed.name);
    if (table.has(error_column)) {
        measured.standard_errors = table.values(error_column, observed.dimension);
        table.check_positive(error_column);
    }
    if (is_pulled && table.has(given_error_column)) {
        if (measured.standard_errors.empty())
            table.refuse_header(given_error_column + " counts beside " + error_column +
                                ", which is missing");
        measured.row_errors.observed = measured.standard_errors;
        measured.row_errors.given = table.values(given_error_column, given.dimension);
        table.check_positive(given_error_column);
    }
    if (table.n_rows() < least_rows) table.refuse_header(few_rows(table.n_rows(), least_rows));
    if (is_rolled && std::ranges::max(measured.given) == std::ranges::min(measured.given))
        table.refuse_value(0, given.name, "the offset is the same everywhere",
                           "a period rolls to both sides: copy the shift at several offsets");
    if (!is_rolled && !(std::ranges::max(measured.observed) > 0))
        table.refuse_value(0, observed.name, "no value is positive",
                           "check the sign: the shift is that in the direction of the force");
    keep_adhesive_rows(measured, name);
    if (measured.given.size() < least_rows)
        table.refuse_header(few_rows(measured.given.size(), least_rows) +
                            "; rows beyond the jumps are left out");
    if (may_pull && !(std::ranges::max(is_pulled ? measured.observed : measured.given) > 0))
        table.refuse_value(0, "normal_force", "no row presses the bodies together",
                           "forces that press are positive: check their sign");
}

}  // namespace tricontact::experiments

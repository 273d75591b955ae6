#include "experiments/identification/identification_table.h"

#include <algorithm>

#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

using Measurement = IdentificationInput::Measurement;

constexpr std::size_t most_rows = 10'000;

void check_columns(const io::CsvTable& table, const MeasuredColumns& columns,
                   const std::string& error_column) {
    for (const auto& column : table.columns())
        if (column.name != columns.given && column.name != columns.observed &&
            column.name != error_column)
            table.refuse_header("unknown column " +
                                io::toml_string(io::shortened(column.name, 40)) + "; known are " +
                                std::string(columns.given) + ", " + std::string(columns.observed) +
                                ", " + error_column);
}

void check_positive(const io::CsvTable& table, std::string_view column,
                    const std::vector<double>& values) {
    for (std::size_t row = 0; row < values.size(); ++row)
        if (!(values[row] > 0))
            table.refuse_value(row, column, "must be positive", "correct or remove the row");
}

}  // namespace

const MeasuredColumns& columns_of(Measurement measurement) {
    using enum io::Dimension;
    static const MeasuredColumns columns[] = {
        // in the order of Measurement
        {"tangential_force", "shift", force, length,
         "tangential_force [N], shift [um], shift_error [um]"},
        {"indentation", "normal_force", length, force,
         "indentation [um], normal_force [N], normal_force_error [N]"},
        {"normal_force", "contact_radius", force, length,
         "normal_force [N], contact_radius [mm], contact_radius_error [mm]"}};
    return columns[static_cast<int>(measurement)];
}

void read_measured_table(IdentificationInput& input) {
    const MeasuredColumns& columns = columns_of(input.measurement);
    const std::string error_column = std::string(columns.observed) + "_error";
    const io::CsvTable table =
        io::read_csv_table(input.data_file, {.kind = "table of a measurement",
                                             .header = std::string(columns.example),
                                             .most_rows = most_rows,
                                             .thinning = "thin it out, or take means"});
    check_columns(table, columns, error_column);
    input.given = table.values(columns.given, columns.given_dimension);
    input.observed = table.values(columns.observed, columns.observed_dimension);
    check_positive(table, columns.given, input.given);
    // A shift may be lost in noise; a force or radius that is not there was not measured.
    if (input.measurement != Measurement::static_shift)
        check_positive(table, columns.observed, input.observed);
    if (table.has(error_column)) {
        input.standard_errors = table.values(error_column, columns.observed_dimension);
        check_positive(table, error_column, input.standard_errors);
    }
    const int n_free = input.young_is_free + input.friction_is_free;
    if (table.n_rows() <= static_cast<std::size_t>(n_free))
        table.refuse_header(
            "the table has " + std::to_string(table.n_rows()) + " rows, which do not determine " +
            (n_free == 2           ? "E and mu"
             : input.young_is_free ? "E"
                                   : "mu") +
            " and how well it is known: " + std::to_string(n_free + 1) + " at least");
    if (!(*std::max_element(input.observed.begin(), input.observed.end()) > 0))
        table.refuse_value(0, columns.observed, "no value is positive",
                           "check the sign: the shift is that in the direction of the force");
}

}  // namespace tricontact::experiments

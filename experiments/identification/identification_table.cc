#include <algorithm>

#include "experiments/identification/identification_reader.h"
#include "io/tables/csv_table.h"

namespace tricontact::experiments {

using Measurement = IdentificationInput::Measurement;

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
         "normal_force [N], contact_radius [mm], contact_radius_error [mm]"}};
    return columns[static_cast<int>(measurement)];
}

void read_measured_table(IdentificationInput& input) {
    const auto& [given, observed, example] = columns_of(input.measurement);
    const std::string error_column = std::string(observed.name) + "_error";
    const io::CsvTable table =
        io::read_csv_table(input.data_file, {.kind = "table of a measurement",
                                             .header = std::string(example),
                                             .most_rows = 10'000,
                                             .thinning = "thin it out, or take means"});
    table.check_names({given.name, observed.name, error_column});
    input.given = table.values(given.name, given.dimension);
    input.observed = table.values(observed.name, observed.dimension);
    table.check_positive(given.name);
    // A shift may be lost in noise; a force or radius that is not there was not measured.
    if (input.measurement != Measurement::static_shift) table.check_positive(observed.name);
    if (table.has(error_column)) {
        input.standard_errors = table.values(error_column, observed.dimension);
        table.check_positive(error_column);
    }
    const int n_free = input.young_is_free + input.friction_is_free;
    if (table.n_rows() <= static_cast<std::size_t>(n_free))
        table.refuse_header(
            "the table has " + std::to_string(table.n_rows()) + " rows, which do not determine " +
            (n_free == 2           ? "E and mu"
             : input.young_is_free ? "E"
                                   : "mu") +
            " and how well it is known: " + std::to_string(n_free + 1) + " at least");
    if (!(std::ranges::max(input.observed) > 0))
        table.refuse_value(0, observed.name, "no value is positive",
                           "check the sign: the shift is that in the direction of the force");
}

}  // namespace tricontact::experiments

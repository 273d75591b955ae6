#include "experiments/identification/loop_table.h"

#include <algorithm>
#include <cmath>

#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t most_loop_rows = 10'000;
constexpr std::size_t most_loop_megabytes = 16;

}  // namespace

void read_loop_table(IdentificationInput::Table& measured, const std::string& text,
                     const std::string& name) {
    using enum io::Dimension;
    const io::CsvTable table(text, name,
                             {.kind = "table of friction loops",
                              .header = std::string(loop_table_header),
                              .most_rows = most_loop_rows,
                              .thinning = "thin the rows out, or leave out cycles: a hundred rows "
                                          "of every tenth cycle",
                              .most_mb = most_loop_megabytes});
    table.check_names({"cycle", "shift", "tangential_force", "normal_force", "amplitude",
                       "tangential_force_error", "shift_error"});
    LoopColumns columns{.cycles = table.values("cycle", none),
                        .shifts = table.values("shift", length),
                        .forces = table.values("tangential_force", force)};
    if (table.has("normal_force")) {
        columns.normal_forces = table.values("normal_force", force);
        table.check_positive("normal_force");
    }
    if (table.has("amplitude")) {
        columns.amplitudes = table.values("amplitude", length);
        table.check_positive("amplitude");
    }
    measured.given = columns.shifts;
    measured.observed = columns.forces;
    try {
        measured.loops = measured_loops(columns);
    } catch (const LoopFault& fault) {
        table.refuse_value(fault.row, fault.column, fault.rule, fault.remedy);
    }
    const bool has_forces = table.has("tangential_force_error");
    if (table.has("shift_error") && !has_forces)
        table.refuse_header("shift_error counts beside tangential_force_error, which is missing");
    if (!has_forces) return;
    measured.standard_errors = table.values("tangential_force_error", force);
    table.check_positive("tangential_force_error");
    if (!table.has("shift_error")) return;
    const auto shift_errors = table.values("shift_error", length);
    table.check_positive("shift_error");
    measured.row_errors.observed = measured.standard_errors;
    measured.row_errors.given = shift_errors;
}

}  // namespace tricontact::experiments

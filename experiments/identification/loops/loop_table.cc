#include "experiments/identification/loops/loop_table.h"

#include <algorithm>
#include <cmath>

#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t most_loop_rows = 10'000;
constexpr std::size_t most_loop_megabytes = 16;
// Rows beside one on its branch, over which the loop's slope is taken.
constexpr std::size_t n_beside = 3;

}  // namespace

std::vector<double> errors_with_shifts(const IdentificationInput::Table& table,
                                       const std::vector<double>& force_errors,
                                       const std::vector<double>& shift_errors) {
    std::vector<double> errors;
    for (const MeasuredLoop& loop : table.loops.loops)
        for (std::size_t i = 0; i < loop.n; ++i) {
            const std::size_t row = loop.first + i;
            double n = 0, u = 0, f = 0, uu = 0, uf = 0;
            for (std::size_t k = loop.n + i - n_beside; k <= loop.n + i + n_beside; ++k) {
                const std::size_t other = loop.first + k % loop.n;
                if (table.loops.rises[other] != table.loops.rises[row]) continue;
                const double x = table.given[other] - loop.centre;
                n += 1;
                u += x;
                f += table.observed[other];
                uu += x * x;
                uf += x * table.observed[other];
            }
            const double spread = n * uu - u * u;
            const double slope = spread > 0 ? (n * uf - u * f) / spread : 0;
            errors.push_back(std::hypot(force_errors[row], slope * shift_errors[row]));
        }
    return errors;
}

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
    measured.standard_errors = errors_with_shifts(measured, measured.standard_errors, shift_errors);
}

}  // namespace tricontact::experiments

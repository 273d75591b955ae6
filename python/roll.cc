#include <pybind11/stl.h>

#include "app/commands.h"
#include "app/roll_models.h"
#include "comparisons/tractive/rolling_document.h"
#include "io/case_writer.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
namespace tractive = comparisons::tractive;

namespace {

tractive::RollingReport roll_all(const contact::Case& c, int points, int threads,
                                 const py::object& on_step) {
    const bool tells = !on_step.is_none();
    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    tractive::RollingReport report{.c = c, .runs = {}, .version = TRICONTACT_VERSION};
    for (const std::string& model : c.models) {
        const auto progress = [&](int step, int steps) {
            check_signals();
            if (!tells) return;
            const py::gil_scoped_acquire lock;
            on_step(model, step, steps);
        };
        report.runs.push_back(app::roll(
            model, c, {.points = points, .threads = threads, .progress = progress, .show = {}}));
    }
    return report;
}

/// Summary, histories and creep curves as the program's files have them, and the steady surfaces;
/// tables are made of them in Python.
py::tuple roll(const contact::Case& given, const std::optional<std::vector<std::string>>& models,
               int points, std::optional<int> threads, const py::object& on_step) {
    const contact::Case c = with_models(given, models);
    app::require_rolling_on(c, "case");
    if (points < 0) throw py::value_error("points: must not be negative");
    tractive::RollingReport report = roll_all(c, points, thread_count(threads), on_step);
    const std::string summary = app::roll_summary(report, io::write_case(c));
    const std::string creep = tractive::creep_csv(report);
    py::dict histories, surfaces;
    for (tractive::RollingRun& run : report.runs) {
        const py::str model(run.model);
        histories[model] = tractive::history_csv(run);
        surfaces[model] = py::cast(std::move(run.history.surface));
    }
    return py::make_tuple(from_json(summary), histories, surfaces, creep);
}

}  // namespace

void add_roll(py::module_& module) {
    module.def("_roll", roll, py::arg("case"), py::arg("models"), py::arg("points"),
               py::arg("threads"), py::arg("on_step"));
}

}  // namespace tricontact::python

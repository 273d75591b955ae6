#include <pybind11/stl.h>

#include "app/roll_models.h"
#include "files/version.h"
#include "io/case/case_writer.h"
#include "python/bindings.h"
#include "rolling/rolling_document.h"

namespace tricontact::python {

namespace py = pybind11;

namespace {

rolling::RollingReport roll_all(const contact::Case& c, int points, int threads,
                                const py::object& on_step) {
    const bool tells = !on_step.is_none();
    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    rolling::RollingReport report{.c = c, .runs = {}, .version = files::version};
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
    rolling::RollingReport report = roll_all(c, points, thread_count(threads), on_step);
    const std::string summary = app::roll_summary(report, io::write_case(c));
    const std::string creep = rolling::creep_csv(report);
    py::dict histories, surfaces;
    for (rolling::RollingRun& run : report.runs) {
        const py::str model(run.model);
        histories[model] = rolling::history_csv(run);
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

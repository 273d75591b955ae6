#include <pybind11/stl.h>

#include "app/commands.h"
#include "app/walk_text.h"
#include "comparisons/walking/walk_document.h"
#include "comparisons/walking/walk_report.h"
#include "dynamics/walk_run.h"
#include "io/atomic_file.h"
#include "io/case_writer.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
namespace walking = comparisons::walking;

namespace {

/// Summary, motion and windows as the program's files have them; numbers are made of them in
/// Python.
py::tuple walk(const dynamics::WalkCase& c) {
    std::string summary, motion, windows;
    {
        const py::gil_scoped_release free_the_lock;
        const dynamics::Walk walk = dynamics::walk(c, walking::report_recording);
        summary = app::walk_summary(c, io::write_walk_case(c), walk);
        motion = walking::motion_csv(c, walk);
        windows = walking::windows_csv(c, walk);
    }
    return py::make_tuple(from_json(summary), motion, windows);
}

void sweep(const std::string& study, const std::string& folder, int jobs, bool retry_failed,
           bool vtk, bool report) {
    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    app::SweepOptions options;
    options.study_file = study;
    options.output = folder;
    options.jobs = jobs;
    options.retry_failed = retry_failed;
    options.vtk = vtk;
    options.report = report;
    options.quiet = true;
    options.attend = [&] { check_signals(); };
    app::sweep_command(options);
}

}  // namespace

void add_walk(py::module_& module) {
    module.def("_walk", walk, py::arg("case"));
    module.def("_sweep", sweep, py::arg("study"), py::arg("folder"), py::arg("jobs"),
               py::arg("retry_failed"), py::arg("vtk"), py::arg("report"));
    module.def(
        "_default_sweep_folder",
        [](const std::string& study) { return io::output_folder({}, study); }, py::arg("study"));
}

}  // namespace tricontact::python

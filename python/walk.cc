#include "walking/run/walk.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/models/make_model.h"
#include "contact/base/interruption.h"
#include "io/results/atomic_file.h"
#include "python/bindings.h"
#include "python/listener.h"
#include "studies/sweep.h"
#include "walking/input/walk_reader.h"
#include "walking/report/walk_document.h"

namespace tricontact::python {

namespace py = pybind11;

namespace {

/// Summary, motion and windows as the program's files have them; numbers are made of them in
/// Python. `on_part` hears how many thousandths of the steps are done; what it raises ends the run.
py::tuple walk(const walking::WalkCase& c, const py::object& on_part) {
    std::string summary, motion, windows;
    {
        const py::gil_scoped_release free_the_lock;
        const contact::Interruption by_signals{SignalCheck()};
        const walking::Walk walk =
            walking::walk(c, walking::report_recording, [&](int done, int total) {
                const py::gil_scoped_acquire lock;
                on_part("walk", done, total);
            });
        summary = walking::walk_summary(c, walking::write_walk_case(c), walk);
        motion = walking::motion_csv(c, walk);
        windows = walking::windows_csv(c, walk);
    }
    return py::make_tuple(from_json(summary), motion, windows);
}

void sweep(const std::string& study, const std::string& folder, int jobs, bool retry_failed,
           bool vtk, bool report, const py::object& say, const py::object& progress) {
    const py::gil_scoped_release free_the_lock;
    const contact::Interruption by_signals{SignalCheck()};
    studies::SweepOptions options;
    options.makers = &app::model_makers();
    options.file = study;
    options.output = folder;
    options.threads = jobs;
    options.retry_failed = retry_failed;
    options.vtk = vtk;
    options.report = report;
    std::ostringstream out;
    options.listener = listener_of(out, say, progress);
    studies::sweep(options);
}

}  // namespace

void add_walk(py::module_& module) {
    module.def("_walk", walk, py::arg("case"), py::arg("on_part"));
    module.def("_sweep", sweep, py::arg("study"), py::arg("folder"), py::arg("jobs"),
               py::arg("retry_failed"), py::arg("vtk"), py::arg("report"), py::arg("say"),
               py::arg("progress"));
    module.def(
        "_default_sweep_folder",
        [](const std::string& study) { return io::output_folder({}, study); }, py::arg("study"));
}

}  // namespace tricontact::python

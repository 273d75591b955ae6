#include "contact/history.h"

#include <pybind11/stl.h>

#include "io/results/history_csv.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::History;
using contact::Snapshot;
using contact::StepRecord;

namespace {

std::span<const io::DriveColumn> drive_columns(const History& history) {
    return history.rig.yields() ? io::drive_columns() : std::span<const io::DriveColumn>();
}

std::vector<std::string_view> column_names(const History& history) {
    std::vector<std::string_view> names;
    for (const io::HistoryColumn& column : io::history_columns()) names.push_back(column.name);
    for (const io::DriveColumn& column : drive_columns(history)) names.push_back(column.name);
    return names;
}

/// A quantity of all steps: every so many bytes in the steps themselves, but for the drive's.
py::array column(const py::object& self, const std::string& name) {
    const auto& history = self.cast<const History&>();
    const auto& steps = history.steps;
    for (const io::HistoryColumn& column : io::history_columns()) {
        if (column.name != name) continue;
        const auto view_of = [&](const auto* first) {
            return view(first, {static_cast<py::ssize_t>(steps.size())}, {sizeof(StepRecord)},
                        self);
        };
        return std::visit(view_of, column.place(steps.front()));  // a run has steps
    }
    for (const io::DriveColumn& column : drive_columns(history)) {
        if (column.name != name) continue;
        py::array_t<double> values(static_cast<py::ssize_t>(steps.size()));
        for (std::size_t i = 0; i < steps.size(); ++i)
            values.mutable_at(i) = column.value(history.rig, steps[i]);
        values.attr("setflags")(py::arg("write") = false);
        return values;
    }
    refuse_key("column", name, column_names(history));
}

py::object to_pandas(const py::object& self) {
    py::dict columns;
    for (const std::string_view name : column_names(self.cast<const History&>()))
        columns[py::str(std::string(name))] = column(self, std::string(name));
    return py::module_::import("pandas").attr("DataFrame")(columns);
}

auto per_period(std::vector<double> History::*values) {
    return [values](const py::object& self) {
        return view(self.cast<const History&>().*values, self);
    };
}

py::dict audit_of(const History& history) {
    py::dict checks;
    for (const auto& check : history.audit.checks())
        checks[py::str(check.name)] =
            py::dict(py::arg("worst") = check.worst, py::arg("allowed") = check.allowed,
                     py::arg("passed") = check.passed());
    return checks;
}

py::object state_of(const History& history) {
    if (history.shift_per_period.empty()) return py::none();  // nothing rolled
    return py::str(contact::name_of(history.verdict.state));
}

}  // namespace

void add_history(py::module_& module) {
    add_scales<contact::Scales>(module, "Scales",
                                "A model's own pressed state: what its ratios refer to.");

    py::class_<Snapshot>(module, "Snapshot", "The contact surface at a phase of the load path.")
        .def_readonly("phase", &Snapshot::phase, "Rolling periods since the start.")
        .def_readonly("surface", &Snapshot::surface, "Its fields.");

    py::class_<History>(
        module, "History",
        "What one model says of a case: the columns of history.csv by their names, one value per\n"
        "step, as NumPy arrays that share the memory of the run (the drive's of a rig that yields\n"
        "are their own), and what the run came to.")
        .def_property_readonly("columns", column_names, "Names of the columns, with units.")
        .def("__getitem__", column, py::arg("name"), "A column. Raises KeyError.")
        .def("__len__", [](const History& history) { return history.steps.size(); })
        .def("to_pandas", to_pandas, "All columns as a DataFrame. Raises ImportError.")
        .def("to_xarray", passed_on("labelled", "history"),
             "All columns as a Dataset along `step`. Raises ImportError.")
        .def("plot", passed_on("plots", "history"),
             "A column over the rolling periods, with matplotlib. Raises ImportError.")
        .def("_repr_html_", passed_on("shown", "history"))
        .def_readonly("model", &History::model, "Name of the model.")
        .def_property_readonly(
            "state", state_of,
            "\"shakedown\", \"cyclic-slip\", \"ratcheting\", \"undecided\"; None: no rolling.")
        .def_readonly("scales", &History::scales, "Its pressed state.")
        .def_readonly("amplitude", &History::amplitude, "W of the rolling [m]")
        .def_readonly("tangential_force", &History::tangential_force, "F_T after loading [N]")
        .def_readonly("friction_limit", &History::friction_limit, "mu F_N [N]")
        .def_readonly("static_shift", &History::static_shift, "U before rolling [m]")
        .def_readonly("limit_tangential_ratio", &History::limit_tangential_ratio,
                      "Largest F_T/(mu F_N) that shakes down, from the pressures.")
        .def_property_readonly("shift_per_period", per_period(&History::shift_per_period),
                               "U after each period, the roller upright [m]")
        .def_property_readonly("dissipation_per_period",
                               per_period(&History::dissipation_per_period),
                               "Frictional work in each period [J]")
        .def_property_readonly(
            "snapshots",
            [](const py::object& self) {
                py::list list;
                for (const Snapshot& snapshot : self.cast<const History&>().snapshots)
                    list.append(
                        py::cast(snapshot, py::return_value_policy::reference_internal, self));
                return list;
            },
            "Surfaces at the quarters of the first three periods and of the last one.")
        .def_property_readonly("audit", audit_of,
                               "Of each check of the solutions: worst, allowed, passed.")
        .def_readonly("cpu_s", &History::cpu_s, "Processor time [s]")
        .def_readonly("wall_s", &History::wall_s, "Time [s]");
}

}  // namespace tricontact::python

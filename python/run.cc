#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/models/make_model.h"
#include "app/models/roll_models.h"
#include "comparisons/quantities/results.h"
#include "contact/wearing_contact.h"
#include "files/version.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"
#include "python/bindings.h"
#include "rolling/rolling_document.h"
#include "runs/case_run.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::Case;
using runs::CaseRun;

namespace {

/// A run with its summary, whose tables take a while.
struct Result {
    CaseRun run;
    std::string summary;
    std::map<std::string, std::vector<contact::Snapshot>> surfaces;  // of every step, if wanted
};

/// With these models, if any, instead of its own, checked as a case file that names them.
Case with_models(const Case& c, const std::optional<std::vector<std::string>>& models) {
    if (!models) return c;
    return io::parse_case(io::write_case(c), "case",
                          {"models=" + toml<std::string>("value", *models)});
}

/// As asked for, or all cores.
int thread_count(std::optional<int> threads) {
    if (threads.value_or(1) < 1) throw py::value_error("threads: must be at least 1");
    return threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

/// Calls what Python wants to be called, if anything.
void tell(const py::object& on_step, const std::string& model, int step, int steps) {
    if (on_step.is_none()) return;
    const py::gil_scoped_acquire lock;
    on_step(model, step, steps);
}

Result run(const Case& given, const std::optional<std::vector<std::string>>& models,
           std::optional<int> threads, bool studies, bool all_surfaces, const py::object& on_step) {
    const Case c = with_models(given, models);
    if (c.tractive_rolling)
        throw contact::InputError(
            "case: [tractive_rolling]: the indenter rolls on and does not come back; "
            "tricontact.roll computes such a case");
    if (c.kept.find<contact::Wear>())
        throw contact::InputError(
            "case: [wear]: a cycle is repeated and wears the surfaces; tricontact.wear computes "
            "such a case");
    runs::RunOptions options;
    options.makers = &app::model_makers();
    options.threads = thread_count(threads);
    options.quiet = true;
    options.studies = studies;

    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    const contact::Say say = [&](const std::string&) { check_signals(); };
    decltype(Result::surfaces) surfaces;
    const runs::ModelRun run_one = [&](const std::string& name, comparisons::LoadingStudy* study) {
        const contact::Observer observer = [&](const contact::StepRecord& record,
                                               contact::Model& model,
                                               const contact::Progress& progress) {
            check_signals();
            if (all_surfaces) {
                if (progress.step == 1) surfaces[name].clear();
                surfaces[name].push_back({record.phase, model.surface()});
            }
            tell(on_step, name, progress.step, progress.steps_at_most);
        };
        return runs::studied_history(name, c, options, say, observer, study);
    };
    CaseRun done = runs::run_models(c, options, say, run_one);
    std::string summary = runs::summary_of(done);
    return {std::move(done), std::move(summary), std::move(surfaces)};
}

py::object history(const py::object& self, const std::string& model) {
    for (const contact::History& history : self.cast<const Result&>().run.histories)
        if (history.model == model)
            return py::cast(history, py::return_value_policy::reference_internal, self);
    refuse_key("model", model, self.cast<const Result&>().run.c.models);
}

/// Those of every step, or the history's.
py::list surfaces(const py::object& self, const std::string& model) {
    const auto& result = self.cast<const Result&>();
    const auto kept = result.surfaces.find(model);
    if (kept == result.surfaces.end()) return history(self, model).attr("snapshots");
    py::list list;
    for (const contact::Snapshot& snapshot : kept->second)
        list.append(py::cast(snapshot, py::return_value_policy::reference_internal, self));
    return list;
}

comparisons::Results results(const Result& result, const std::string& model) {
    for (const contact::History& history : result.run.histories)
        if (history.model == model)
            return comparisons::results_beside(result.run.c, history, result.run.extras.study);
    refuse_key("model", model, result.run.c.models);
}

struct ToPython {
    py::object operator()(std::monostate) const { return py::none(); }
    py::object operator()(contact::State state) const { return py::str(contact::name_of(state)); }
    py::object operator()(comparisons::SlipRegime regime) const {
        return py::str(comparisons::name_of(regime));
    }
    template <class Value>
    py::object operator()(const Value& value) const {
        return py::cast(value);
    }
};

void add_results(py::module_& module) {
    auto results = py::class_<comparisons::Results>(
        module, "Results",
        "What one model came to: the quantities of summary.json; None: undefined.");
    for (const comparisons::Quantity* q : comparisons::all_quantities()) {
        const std::string text = std::string(q->meaning) + " Defined " + q->defined +
                                 ". Unit: " + comparisons::unit_of(*q) + ".";
        results.def_property_readonly(
            q->key, [q](const comparisons::Results& r) { return std::visit(ToPython{}, r[*q]); },
            text.c_str());
    }
}

rolling::RollingReport roll_all(const contact::Case& c, int points, int threads,
                                const py::object& on_step) {
    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    rolling::RollingReport report{.c = c, .runs = {}, .version = files::version};
    for (const std::string& model : c.models) {
        const auto progress = [&](int step, int steps) {
            check_signals();
            tell(on_step, model, step, steps);
        };
        report.runs.push_back(app::roll(
            model, c, {.points = points, .threads = threads, .progress = progress, .show = {}}));
    }
    return report;
}

/// Temperatures of both surfaces, rows of points along x.
py::dict temperatures_of(const rolling::RollingHistory& history) {
    const contact::Surface& s = history.surface;
    const auto field = [&](const std::vector<double>& values) {
        py::array_t<double> array({s.n_y, s.n_x});
        std::ranges::copy(values, array.mutable_data());
        array.attr("setflags")(py::arg("write") = false);
        return array;
    };
    py::dict fields;
    fields["indenter"] = field(history.temperatures->indenter);
    fields["substrate"] = field(history.temperatures->substrate);
    return fields;
}

/// Summary, histories and creep curves as the program's files have them, the steady surfaces and
/// their temperatures, where the case has heat; tables are made of them in Python.
py::tuple roll(const contact::Case& given, const std::optional<std::vector<std::string>>& models,
               int points, std::optional<int> threads, const py::object& on_step) {
    const contact::Case c = with_models(given, models);
    io::require_rolling_on(c, "case");
    if (points < 0) throw py::value_error("points: must not be negative");
    rolling::RollingReport report = roll_all(c, points, thread_count(threads), on_step);
    const std::string summary = app::roll_summary(report, io::write_case(c));
    const std::string creep = rolling::creep_csv(report);
    py::dict histories, surfaces, temperatures;
    for (rolling::RollingRun& run : report.runs) {
        const py::str model(run.model);
        histories[model] = rolling::history_csv(run);
        if (run.history.temperatures) temperatures[model] = temperatures_of(run.history);
        surfaces[model] = py::cast(std::move(run.history.surface));
    }
    return py::make_tuple(from_json(summary), histories, surfaces, temperatures, creep);
}

}  // namespace

void add_run(py::module_& module) {
    add_results(module);
    py::class_<Result>(module, "Result", "What the models of a case came to: histories by name.")
        .def_property_readonly(
            "models", [](const Result& result) { return result.run.c.models; },
            "Names of the models.")
        .def("__getitem__", history, py::arg("model"), "History of a model. Raises KeyError.")
        .def(
            "surfaces",
            [](const py::object& self, const std::string& model) {
                return in_python("labelled", "Surfaces")(surfaces(self, model));
            },
            py::arg("model"),
            "Contact surfaces of a model: as run() was told, of every step. Raises KeyError.")
        .def("to_xarray", passed_on("labelled", "result"),
             "The quantities of all models as a Dataset. Raises ImportError.")
        .def("plot", passed_on("plots", "result"),
             "A column of all models over the periods, with matplotlib. Raises ImportError.")
        .def("_repr_html_", passed_on("shown", "result"))
        .def("results", results, py::arg("model"), "Quantities of a model. Raises KeyError.")
        .def_property_readonly(
            "case", [](const Result& result) { return result.run.c; }, "The case as it was run.")
        .def_property_readonly(
            "summary", [](const Result& result) { return from_json(result.summary); },
            "The numbers of summary.json.");
    module.def("_run", run, py::arg("case"), py::arg("models"), py::arg("threads"),
               py::arg("studies"), py::arg("all_surfaces"), py::arg("on_step"));
}

void add_roll(py::module_& module) {
    module.def("_roll", roll, py::arg("case"), py::arg("models"), py::arg("points"),
               py::arg("threads"), py::arg("on_step"));
}

}  // namespace tricontact::python

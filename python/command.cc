#include "app/commands/command.h"

#include <pybind11/stl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "comparisons/quantities/quantity.h"
#include "contact/base/interruption.h"
#include "io/case/case_keys.h"
#include "io/case/study_reader.h"
#include "python/bindings.h"
#include "python/listener.h"

// Commands of the program, called within this process: what they print and how far they are goes
// to Python, results are read from the files that they write.
namespace tricontact::python {

namespace py = pybind11;
using app::Command;

namespace {

Command command_called(const std::string& name) {
    for (Command& command : app::all_commands())
        if (command.name == name) return std::move(command);
    throw py::key_error(name);
}

/// Arguments as in a shell, without the command.
void parse(const Command& command, std::vector<std::string> arguments) {
    std::ranges::reverse(arguments);  // as CLI11 wants them
    try {
        command.parser->parse(arguments);
    } catch (const CLI::Error& error) {
        throw contact::InputError(command.name + ": " + error.what());
    }
}

/// What the command prints as its answer. `say` hears lines about what goes on, `progress` names
/// and counts; what they raise, and Ctrl-C, end it.
std::string run_command(const std::string& name, const std::vector<std::string>& arguments,
                        const py::object& say, const py::object& progress) {
    const Command command = command_called(name);
    parse(command, arguments);
    const py::gil_scoped_release free_the_lock;
    const contact::Interruption by_signals{SignalCheck()};
    std::ostringstream out;
    if (command.options) command.options->listener = listener_of(out, say, progress);
    if (command.run() == 1) throw std::runtime_error(name + ": failed; " + out.str());
    return out.str();
}

/// Of each option: name as in a shell, whether it is a flag, whether it is needed, text.
py::list options_of(const std::string& name) {
    py::list all;
    const Command command = command_called(name);
    for (const CLI::Option* option : command.parser->get_options())
        if (option != command.parser->get_help_ptr())
            all.append(py::make_tuple(option->get_name(), option->get_items_expected_max() == 0,
                                      option->get_required(), option->get_description()));
    return all;
}

/// SI unit, meaning and what it is a multiple of: of a quantity or a key by its name in tables;
/// None for others.
py::object label_of(const std::string& name) {
    for (const comparisons::Quantity* q : comparisons::all_quantities())
        if (q->key == name) return py::make_tuple(*q->unit ? q->unit : "1", q->name, q->over);
    for (const io::Key* key : io::case_file_keys().keys())
        if (io::table_heading(*key) == name)
            return py::make_tuple(io::si_unit(key->dimension), key->text, "");
    return py::none();
}

}  // namespace

void add_command(py::module_& module) {
    module.def("_run_command", run_command, py::arg("name"), py::arg("arguments"), py::arg("say"),
               py::arg("progress"));
    module.def("_command_options", options_of, py::arg("name"));
    module.def("_label", label_of, py::arg("name"));
}

}  // namespace tricontact::python

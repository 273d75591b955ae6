#include "contact/case.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "io/case/case_reader.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"
#include "python/bindings.h"
#include "walking/input/walk_reader.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::Case;
using contact::HalfSpaceScales;
using walking::WalkCase;

namespace {

constexpr const char* dict_name = "<dict>";  // stands for the file in messages

/// {"rolling.periods": 3} as the program's --set has them.
std::vector<std::string> overrides_of(const py::dict& overrides) {
    std::vector<std::string> texts;
    for (const auto& [key, value] : overrides)
        texts.push_back(py::str(key).cast<std::string>() + '=' + toml_value(value));
    return texts;
}

/// What both kinds of case have, given their readers and writer.
template <class C, class Read, class Parse, class Write>
py::class_<C> add_kind(py::module_& module, const char* name, const char* text, Read read,
                       Parse parse, Write write) {
    return py::class_<C>(module, name, text)
        .def_static(
            "from_file",
            [read](const py::object& path, const py::dict& overrides) {
                const auto file = py::module_::import("os").attr("fspath")(path);
                return read(file.template cast<std::string>(), overrides_of(overrides));
            },
            py::arg("path"), py::arg("overrides") = py::dict(),
            "Read a case file; overrides such as {\"rolling.periods\": 3} replace its keys.\n\n"
            "Raises InputError.")
        .def_static(
            "from_dict",
            [parse](const py::dict& values, const py::dict& overrides) {
                return parse(toml_text(values), dict_name, overrides_of(overrides));
            },
            py::arg("values"), py::arg("overrides") = py::dict(),
            "Read a case from what a case file would hold, sections as dictionaries.\n\n"
            "Raises InputError; its line counts in the dictionary written as a file.")
        .def(
            "to_dict", [write](const C& c) { return from_json(io::case_json(write(c)).dump()); },
            "The resolved case with every default, quantities with their SI units.")
        .def(
            "to_toml", [write](const C& c) { return write(c); },
            "The same as the text of a case file.")
        .def_readonly("title", &C::title, "Title of the case.")
        .def("__repr__", [name = std::string(name)](const C& c) {
            return '<' + name + ' ' + py::repr(py::str(c.title)).template cast<std::string>() + '>';
        });
}

[[noreturn]] void refuse(const std::string& what) {
    throw py::type_error(what + "; TOML has texts, numbers, true and false, and lists of them");
}

std::string key_text(const py::handle& key) {
    if (!py::isinstance<py::str>(key))
        refuse("keys are texts, not " + py::repr(key).cast<std::string>());
    const auto text = key.cast<std::string>();
    const bool bare = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return c < 128 && (std::isalnum(c) || c == '_' || c == '-');
    });
    return bare ? text : io::toml_string(text);
}

std::string list_text(const py::handle& values) {
    std::string text;
    for (const py::handle value : values) text += (text.empty() ? "" : ", ") + toml_value(value);
    return '[' + text + ']';
}

bool is_dict(const py::handle& value) {
    return py::isinstance<py::dict>(value);
}

/// Keys of a table first: those behind a table's heading would be that table's.
void add_table(std::string& text, const std::string& path, const py::dict& values) {
    for (const auto& [key, value] : values)
        if (!is_dict(value)) text += key_text(key) + " = " + toml_value(value) + '\n';
    for (const auto& [key, value] : values) {
        if (!is_dict(value)) continue;
        const std::string below = path + (path.empty() ? "" : ".") + key_text(key);
        text += '[' + below + "]\n";
        add_table(text, below, py::reinterpret_borrow<py::dict>(value));
    }
}

}  // namespace

void add_case(py::module_& module) {
    py::class_<HalfSpaceScales>(
        module, "HalfSpaceScales",
        "What ratios refer to: the body pressed without friction on the half-space.")
        .def_readonly("contact_radius", &HalfSpaceScales::contact_radius, "a [m]")
        .def_readonly("indentation", &HalfSpaceScales::indentation, "d [m]")
        .def_readonly("normal_force", &HalfSpaceScales::normal_force, "F_N [N]")
        .def_readonly("peak_pressure", &HalfSpaceScales::peak_pressure, "p0 [Pa]")
        .def_readonly("unit_shift", &HalfSpaceScales::unit_shift, "U_max [m]");

    add_kind<Case>(
        module, "Case", "A frictional contact, checked and resolved.",
        [](const std::string& path, const auto& overrides) {
            return io::read_case(path, overrides);
        },
        [](const std::string& text, const char* name, const auto& overrides) {
            return io::parse_case(text, name, overrides);
        },
        io::write_case)
        .def_readonly("models", &Case::models, "The models it names.")
        .def_property_readonly("scales", &contact::half_space_scales,
                               "What ratios refer to: see HalfSpaceScales.");

    add_kind<WalkCase>(
        module, "WalkCase", "A micro-walking machine, checked and resolved.",
        [](const std::string& path, const auto& overrides) {
            return walking::read_walk_case(path, overrides);
        },
        [](const std::string& text, const char* name, const auto& overrides) {
            return walking::parse_walk_case(text, name, overrides);
        },
        walking::write_walk_case);
}

std::string toml_value(const py::handle& value) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
    if (py::isinstance<py::str>(value)) return io::toml_string(value.cast<std::string>());
    if (py::isinstance<py::int_>(value)) return py::str(value).cast<std::string>();
    if (py::isinstance<py::float_>(value)) return io::toml_number(value.cast<double>());
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
        return list_text(value);
    // What NumPy has: its numbers and arrays turn into Python's.
    if (py::hasattr(value, "tolist")) return toml_value(value.attr("tolist")());
    refuse(py::repr(value).cast<std::string>() + " is no value for a key");
}

std::string toml_text(const py::dict& values) {
    std::string text;
    add_table(text, "", values);
    return text;
}

}  // namespace tricontact::python

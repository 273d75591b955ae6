#include "contact/case.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "io/case/case_reader.h"
#include "io/keys/toml_document.h"
#include "python/bindings.h"
#include "walking/input/walk_reader.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::Case;
using walking::WalkCase;

namespace {

constexpr const char* dict_name = "<dict>";  // stands for the file in messages

/// {"rolling.periods": 3} as the program's --set has them.
std::vector<std::string> overrides_of(const py::dict& overrides) {
    return toml<std::vector<std::string>>("overrides", overrides);
}

/// The case as an object that remembers what it was made of, for commands that read more of it.
template <class C>
py::object with_origin(C&& c, const py::object& path, const py::object& values,
                       const py::dict& overrides) {
    py::object made = py::cast(std::forward<C>(c));
    made.attr("_origin") =
        py::module_::import("tricontact.inputs").attr("origin_of")(path, values, overrides);
    return made;
}

/// What both kinds of case have, given their readers and writer.
template <class C, class Read, class Parse, class Write>
py::class_<C> add_kind(py::module_& module, const char* name, const char* text, Read read,
                       Parse parse, Write write) {
    return py::class_<C>(module, name, text, py::dynamic_attr())
        .def_static(
            "from_file",
            [read](const py::object& path, const py::dict& overrides) {
                const py::object file = py::module_::import("os").attr("fsdecode")(path);
                return with_origin(
                    read(toml<std::string>("argument", file), overrides_of(overrides)), path,
                    py::none(), overrides);
            },
            py::arg("path"), py::arg("overrides") = py::dict(),
            "Read a case file; overrides such as {\"rolling.periods\": 3} replace its keys.\n\n"
            "Raises InputError.")
        .def_static(
            "from_dict",
            [parse](const py::dict& values, const py::dict& overrides) {
                return with_origin(parse(toml<std::string>("document", values), dict_name,
                                         overrides_of(overrides)),
                                   py::none(), values, overrides);
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
        .def("_repr_html_", passed_on("shown", "case"))
        .def("__repr__", [name = std::string(name)](const C& c) {
            return '<' + name + ' ' + py::repr(py::str(c.title)).template cast<std::string>() + '>';
        });
}

}  // namespace

void add_case(py::module_& module) {
    add_scales<contact::HalfSpaceScales>(
        module, "HalfSpaceScales",
        "What ratios refer to: the body pressed without friction on the half-space.");

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

}  // namespace tricontact::python

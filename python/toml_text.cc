#include <algorithm>
#include <cctype>

#include "io/keys/messages.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;

namespace {

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

#include "app/new_case/example_cases.h"

#include <algorithm>
#include <vector>

#include "contact/base/error.h"
#include "io/keys/messages.h"

namespace tricontact::app {

std::string ExampleCase::title() const {
    const std::size_t line = text.starts_with("title") ? 0 : text.find("\ntitle");
    if (line == text.npos) return {};
    const std::size_t begin = text.find('"', line) + 1;
    return std::string(text.substr(begin, text.find('"', begin) - begin));
}

const ExampleCase& required_example(std::string_view name) {
    const auto found = std::ranges::find(example_cases(), name, &ExampleCase::name);
    if (found != example_cases().end()) return *found;
    std::vector<std::string_view> names;
    for (const ExampleCase& one : example_cases()) names.push_back(one.name);
    const std::string_view near = io::nearest(name, names);
    io::fail("", "--example " + io::shortened(name, 60), "is none of the examples",
             near.empty() ? "tricontact new --list shows them"
                          : "did you mean " + std::string(near) + "?");
}

}  // namespace tricontact::app

#include "app/boundary_element_model.h"

#include "contact/error.h"
#include "io/case/case_reader.h"

namespace tricontact::app {

namespace {

std::string only_model_of(const contact::Case& c) {
    std::string found;
    for (const auto& model : c.models) {
        if (model != "bem" && model != "bem-layer") continue;
        if (!found.empty())
            throw contact::InputError(
                "the case names both bem and bem-layer; choose one by --model");
        found = model;
    }
    if (found.empty())
        throw contact::InputError(
            "models: no boundary elements, which this needs, are among them; choose bem or "
            "bem-layer "
            "by --model");
    return found;
}

}  // namespace

BoundaryElementCase read_boundary_elements(const std::string& case_file,
                                           const std::vector<std::string>& overrides,
                                           const std::string& asked) {
    const auto models =
        asked.empty() ? std::vector<std::string>{} : std::vector<std::string>{asked};
    contact::Case c = io::read_case(case_file, overrides, models);
    const std::string model = asked.empty() ? only_model_of(c) : asked;
    return {std::move(c), model};
}

}  // namespace tricontact::app

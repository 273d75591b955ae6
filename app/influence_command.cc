#include <fmt/format.h>

#include <iostream>

#include "app/commands.h"
#include "bem/case_compliance.h"
#include "contact/error.h"
#include "io/atomic_file.h"
#include "io/case_reader.h"

namespace tricontact::app {

namespace {

/// The only boundary element model of the case, or the one that is asked for.
std::string model_of(const contact::Case& c, const std::string& asked) {
    if (!asked.empty()) return asked;
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
            "only boundary elements have influence coefficients, but the case names none; choose "
            "bem or bem-layer by --model");
    return found;
}

}  // namespace

void influence_command(const InfluenceOptions& options) {
    std::vector<std::string> overrides = options.overrides;
    if (!options.model.empty()) overrides.push_back("models=[\"" + options.model + "\"]");
    const contact::Case c = io::read_case(options.case_file, overrides);
    const std::string model = model_of(c, options.model);
    const auto table = bem::case_influence(
        c, options.threads, model == "bem-layer" ? bem::Body::layer : bem::Body::half_space);
    io::write_file(options.output, bem::influence_text(table));
    std::cout << fmt::format(
        "model                {}\n"
        "spacing              {:.6g} mm\n"
        "positions            {} x {}\n"
        "written              {}\n",
        model, 1e3 * table.spacing, table.n_x, table.n_y, options.output);
}

}  // namespace tricontact::app

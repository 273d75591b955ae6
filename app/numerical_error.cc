#include <fmt/format.h>

#include <stdexcept>

#include "app/case_run.h"
#include "contact/own_limit.h"

namespace tricontact::app {

namespace {

using comparisons::NumericalError;
using comparisons::ResolvedRun;

/// The same with half as many steps; empty where their number is the case's own.
std::optional<Case> with_longer_steps(Case c) {
    if (c.prescribed_path || !c.rolling) return {};
    switch (c.rolling->steps) {
        case Case::Steps::increment:
            c.rolling->increment *= 2;
            return c;
        case Case::Steps::per_quarter:
            if (c.rolling->steps_per_quarter < 2) return {};
            c.rolling->steps_per_quarter /= 2;
            return c;
        case Case::Steps::turning_points:
            return {};
    }
    return {};
}

ResolvedRun resolved(const Case& c, contact::Model& model) {
    const contact::History history = contact::run(c, model);
    require_sound(history.audit, history.model);
    return {c, history};
}

}  // namespace

std::optional<NumericalError> numerical_error(const Case& c, const contact::History& history,
                                              const RunOptions& options, const Say& say) {
    if (!options.studies) return {};
    const std::string& name = history.model;
    NumericalError error{.model = name, .run = ResolvedRun(c, history)};
    if (name == "fem" && c.fem.mesh) {
        error.why_none = "the mesh is a file's; run another one beside it";
        return error;
    }
    const Case coarser = with_coarser_mesh(contact::loaded_as(c, history));
    say(fmt::format("{}: once more on coarser meshes and with longer steps", name));
    std::unique_ptr<contact::Model> model;
    try {
        model = make_model(name, coarser, options.threads, silent);
        error.coarser = resolved(coarser, *model);
    } catch (const std::exception& e) {  // the run itself is none the worse for it
        error.why_none = e.what();
        return error;
    }
    try {
        if (const auto longer = with_longer_steps(coarser)) {
            // On the same elasticity, where the model can share it.
            auto sibling = model->sibling(coarser.contact);
            if (!sibling) sibling = make_model(name, coarser, options.threads, silent);
            error.long_steps = resolved(*longer, *sibling);
        }
        const Case coarsest = with_coarser_mesh(coarser);
        error.coarsest = resolved(coarsest, *make_model(name, coarsest, options.threads, silent));
    } catch (const std::exception&) {  // then two meshes have to do
    }
    return error;
}

}  // namespace tricontact::app

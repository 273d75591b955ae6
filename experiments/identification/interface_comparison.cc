#include "experiments/identification/interface_comparison.h"

#include <algorithm>

#include "contact/base/special_values.h"
#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/interface_parameters.h"
#include "experiments/identification/law_comparison.h"

namespace tricontact::experiments {

namespace {

/// Springs that are rigid, and surfaces that do not attract each other.
IdentificationInput without(IdentificationInput input, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        std::erase_if(input.parameters, [&](const FreeParameter& p) { return p.key == key; });
        if (key == work_key) input.rig.adhesion.reset();
        if (key == approach_key && input.rig.adhesion) input.rig.adhesion->approach_work.reset();
        if (key == work_key || key == approach_key) continue;
        (key == normal_stiffness_key ? input.rig.interface.normal_stiffness
                                     : input.rig.interface.tangential_stiffness)
            .reset();
    }
    return input;
}

InterfaceFit fit_of(IdentificationInput input, const contact::ModelRunner& runner,
                    const std::string& model) {
    InterfaceFit fit;
    for (const FreeParameter& p : input.parameters)
        if (is_of_interface(p.key)) fit.name += (fit.name.empty() ? "" : ", ") + p.symbol;
    if (fit.name.empty()) fit.name = input.tables.front().is_adhesive ? "none" : "rigid";
    fit.input = std::move(input);
    fit.input.shifts_by_theory = true;
    IdentificationTask task = task_of(fit.input, model);
    task.model = prediction_of(model, fit.input, runner);
    fit.found = identify(task);
    fit.likelihood = likelihood_of(fit.input, fit.found);
    return fit;
}

}  // namespace

bool is_of_interface(std::string_view key) {
    return is_stiffness(key) || key == work_key || key == approach_key;
}

InterfaceComparison compare_interfaces(const IdentificationInput& input,
                                       const contact::ModelRunner& runner,
                                       const std::string& model) {
    std::vector<std::string> keys;
    for (const FreeParameter& p : input.parameters)
        if (is_of_interface(p.key)) keys.push_back(p.key);
    std::vector<std::vector<std::string>> rigid{keys};
    InterfaceComparison comparison{.is_adhesion = input.rig.adhesion.has_value()};
    if (comparison.is_adhesion && keys.size() == 2)
        rigid.push_back({std::string(approach_key)});  // one work for both
    else if (keys.size() == 2)
        rigid.insert(rigid.end(), {{keys[1]}, {keys[0]}});
    rigid.emplace_back();
    for (const auto& held : rigid)
        comparison.fits.push_back(fit_of(without(input, held), runner, model));
    const InterfaceFit& all = comparison.fits.back();
    double least = contact::infinity;
    for (std::size_t i = 0; i < comparison.fits.size(); ++i)
        if (comparison.fits[i].likelihood.aicc < least) {
            least = comparison.fits[i].likelihood.aicc;
            comparison.best = i;
        }
    for (InterfaceFit& fit : comparison.fits) {
        fit.aicc_difference = fit.likelihood.aicc - least;
        const int n_more = all.likelihood.n_fitted - fit.likelihood.n_fitted;
        if (n_more == 0) continue;
        fit.likelihood_ratio =
            std::max(0., fit.likelihood.minus_two_log - all.likelihood.minus_two_log);
        fit.chance = chance_of_ratio(fit.likelihood_ratio, n_more, all.input, all.found);
        fit.is_excluded = fit.chance < excluded_chance || fit.aicc_difference > excluded_aicc;
    }
    return comparison;
}

}  // namespace tricontact::experiments

#include "experiments/identification/excluded_ranges.h"

#include "contact/base/error.h"
#include "experiments/identification/adhesion/maugis_curve.h"
#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_models.h"
#include "theory/adhesion.h"

namespace tricontact::experiments {

std::vector<TriedRange> excluded_ranges(const IdentificationInput& input, const std::string& model,
                                        const Identification& found,
                                        const contact::ModelRunner& runner) {
    if (!input.is_free(work_key) || !input.rig.adhesion->is_short_ranged() ||
        !input.rig.adhesion->is_reversible())
        return {};
    std::vector<double> errors, observed;
    for (std::size_t t = 0; t < found.tables.size(); ++t) {
        const auto& of_table = found.tables[t].standard_errors;
        errors.insert(errors.end(), of_table.begin(), of_table.end());
        const auto& rows = input.tables[t].observed;
        observed.insert(observed.end(), rows.begin(), rows.end());
    }
    const contact::Case c = rig_with(input, found.free, found.best()).as_case;
    const double modulus = c.materials().effective_modulus();
    const std::size_t of_work = found.find(std::string(work_key)).value();
    const double beyond = found.parameters[of_work].level - found.sum_of_squares;
    std::vector<TriedRange> tried;
    for (const double lambda : {5., 2., 1., .5, .2, .1}) {
        const double range =
            MaugisCurve::range_of(lambda, c.indenter.radius, modulus, c.adhesion->work);
        IdentificationInput ranged = input;
        ranged.rig.adhesion->range = range;
        IdentificationTask task = task_of(ranged, model);
        task.model = prediction_of(model, ranged, runner);
        try {
            const std::vector<double> best = best_nearby(task, found, observed);
            double sum = 0;
            for (const double r : residuals_of(task, task.model(best), errors)) sum += r * r;
            const contact::Case at = rig_with(ranged, found.free, best).as_case;
            tried.push_back(
                {.range = range,
                 .tabor = theory::tabor_parameter(at.indenter.radius, at.adhesion->work,
                                                  at.materials().effective_modulus(), range),
                 .work = at.adhesion->work,
                 .sum_of_squares = sum,
                 .is_excluded = sum - found.sum_of_squares > beyond,
                 .is_better = found.sum_of_squares - sum > beyond});
        } catch (const contact::InputError&) {  // no such contact
        } catch (const contact::NotConverged&) {
        }
    }
    return tried;
}

}  // namespace tricontact::experiments

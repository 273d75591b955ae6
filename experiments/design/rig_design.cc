#include "experiments/design/rig_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "atlas/prediction.h"
#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/special_values.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "experiments/assumptions/rig_quantities.h"
#include "experiments/predictions/rig_body.h"
#include "experiments/predictions/rig_growth.h"
#include "experiments/predictions/uncertain_case.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

/// By the values: their uncertainties would be propagated through every formula.
Rig rig_of_values(const io::RigFile& file, const contact::ModelRunner& runner) {
    Rig rig = rig_with_body(file, runner);
    for (const auto& one : rig_quantities(rig.kind)) (rig.*one.number).standard_error = 0;
    return rig;
}

RigReport report_of(const DesignInput& input, const io::RigFile& file,
                    const contact::ModelRunner& runner) {
    if (input.assumptions.empty()) return {};
    return check_rig(rig_of_values(file, runner), {}, rolled_growth);
}

/// Of springs under another law of friction than Coulomb's, about which no map is.
double predicted_under_law(const Case& c, const std::string& quantity) {
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    if (quantity == "indentation") return hertz.indentation;
    if (quantity == "contact_radius") return hertz.contact_radius;
    const double force = c.load.tangential_force.value_or(c.load.tangential_ratio.value_or(0) *
                                                          hertz.friction_limit);
    const double f = force / hertz.friction_limit;
    if (f > 1)
        throw contact::InputError(
            fmt::format("load.tangential_force = {:.4g} N: friction carries {:.4g} N alone", force,
                        hertz.friction_limit));
    if (quantity == "static_shift") return hertz.unit_shift * theory::static_shift_ratio(c, f);
    if (!c.rolling) throw contact::InputError(quantity + ": the case has no [rolling]");
    const double w = contact::path_amplitude(c, hertz.contact_radius) / hertz.contact_radius;
    const auto settled = theory::bed_settled_shift_ratio(c, w, f);
    if (quantity != "settled_shift" || !settled)
        throw contact::InputError(
            quantity + (settled ? ": no theory gives it under this law of friction; take settled_"
                                  "shift or static_shift"
                                : ": the contact ratchets"));
    return hertz.unit_shift * *settled;
}

atlas::Value predicted(const Case& c, const std::string& model, const std::string& quantity) {
    if (!c.friction.is_coulomb()) return {predicted_under_law(c, quantity)};
    const atlas::Prediction p = atlas::predict(c, model);
    for (const auto& entry : p.entries)
        if (entry.quantity->key == quantity + "_m") return entry.value;
    throw contact::InputError(fmt::format("{}: the maps do not give the {}{}", model, quantity,
                                          p.gaps.empty()
                                              ? (c.rolling ? "" : ", the case has no [rolling]")
                                              : fmt::format(": {}", fmt::join(p.gaps, "; "))));
}

/// The comparison of a rig that has yet to be measured, by the maps of a model.
ComparisonError comparison_of(const DesignInput& input, const io::RigFile& file,
                              const std::string& model) {
    const UncertainCase numbers = uncertain_case(file.c, file.uncertain_of_case());
    const auto result = [&](const Case& c) { return predicted(c, model, input.quantity).value; };
    auto inputs = input_errors(result, numbers.set, numbers.quantities,
                               file.correlations.of(numbers.names()));
    const atlas::Value computed = predicted(numbers.set, model, input.quantity);
    if (computed.error > 0) inputs.sources.push_back({"map", computed.standard_error()});
    return planned_comparison(computed.value, std::move(inputs), input.record);
}

/// Ratios of all requirements; NaN of all where the rig cannot be told, with the reason.
class Evaluation {
  public:
    Evaluation(const DesignStudy& study, const contact::ModelRunner& runner)
        : study_(study), runner_(runner) {}

    std::vector<double> operator()(const std::vector<double>& fractions) {
        contact::interruption_point();
        std::vector<double> ratios(study_.requirements.size(), contact::undefined);
        try {
            const io::RigFile file = study_.input.at(fractions);
            const RigReport report = report_of(study_.input, file, runner_);
            LawSeparation laws;
            if (!study_.input.laws.laws.empty()) laws = law_separation(file, study_.input.laws);
            for (std::size_t i = 0; i < ratios.size(); ++i) {
                const auto& one = study_.requirements[i];
                ratios[i] =
                    one.law ? one.ratio(laws.distances[*one.law])
                    : one.is_resolution()
                        ? one.ratio(comparison_of(study_.input, file, study_.model).resolution())
                        : ratio_in(report, one);
            }
        } catch (const contact::InputError& error) {  // no rig there, or beyond theory and maps
            note(error.what());
        } catch (const contact::NotConverged& error) {
            note(error.what());
        }
        return ratios;
    }
    /// Why the first place that could not be told could not.
    const std::string& reason() const { return reason_; }

  private:
    void note(const std::string& what) {
        if (reason_.empty()) reason_ = what;
    }

    const DesignStudy& study_;
    contact::ModelRunner runner_;
    std::string reason_;
};

}  // namespace

DesignStudy design_study(const DesignInput& input, const contact::ModelRunner& runner) {
    DesignStudy study{.title = input.rig.c.title, .input = input};
    study.requirements = requirements_of(input, report_of(input, input.rig, runner));
    if (input.resolution)
        study.model = input.rig.c.friction.is_coulomb()
                          ? atlas::predictable_models(input.rig.c).back()
                          : contact::models::mdr;
    Evaluation evaluation(study, runner);
    study.solution = search_design(std::ref(evaluation), input.axes.size());
    const auto& best = study.solution.best;
    if (!std::isfinite(best.worst()))
        throw contact::InputError(fmt::format(
            "[design]: nowhere within the bounds can all requirements be evaluated: {}",
            evaluation.reason().empty() ? "a criterion is missing" : evaluation.reason()));
    if (input.resolution)
        study.comparison = comparison_of(input, input.at(best.fractions), study.model);
    if (!input.laws.laws.empty())
        study.separation = law_separation(input.at(best.fractions), input.laws);
    return study;
}

}  // namespace tricontact::experiments

#include "runs/further_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/base/stopped.h"
#include "contact/models/model_kind.h"
#include "contact/own_limit.h"
#include "contact/relaxing_case.h"
#include "runs/normal_stiffness.h"

namespace tricontact::runs {

namespace {

using comparisons::LoadingVariant;
using comparisons::run_values;
using comparisons::RunValues;
using contact::History;
using contact::State;

/// By turning points the rig's layer settles in 30 periods.
constexpr int enough_periods = 40;
/// A longer run is not repeated for each variant.
constexpr std::size_t most_steps = 1000;

const char* name_of(bool yes) {
    return yes ? "true" : "false";
}
const char* name_of(Case::Press press) {
    return press == Case::Press::friction ? "friction" : "frictionless";
}
std::string name_of(int n) {
    return std::to_string(n);
}

/// The value of a key and another one that has been set instead, for people.
struct Change {
    std::string from, to;
};
template <class Value>
Change change(Value& value, Value other) {
    const Change made{name_of(value), name_of(other)};
    value = other;
    return made;
}
/// To the other of two values.
template <class Value>
Change flip(Value& value) {
    return change(value, static_cast<Value>(!static_cast<bool>(value)));
}

Case without_rolling(Case c) {
    c.rolling.reset();
    return c;
}

/// The case as the study rolls it. A contact that shakes down does so by turning points as well, in
/// a fraction of the time; the shift per period of what ratchets is that of the run's own steps.
/// Without rolling where that would take too long, as it does at finite strains.
Case rolled(const Case& c, const History& history) {
    if (!c.rolling) return c;
    if (c.law != Case::Law::linear) return without_rolling(c);
    if (history.verdict.state != State::ratcheting && contact::turning_points_suffice(c)) {
        Case result = c;
        result.rolling->steps = Case::Steps::turning_points;
        result.rolling->periods = std::max(c.rolling->periods, enough_periods);
        result.rolling->run_all = false;
        return result;
    }
    return history.steps.size() <= most_steps ? c : without_rolling(c);
}

/// One loading after another with one key changed.
class Variants {
  public:
    using Make = Change (*)(Case&);

    Variants(const Case& c, const contact::Model& model, const History& history, const Say& say,
             std::vector<LoadingVariant>& variants)
        : model_(model), name_(history.model), say_(say), variants_(variants) {
        as_rolled_ = contact::loaded_as(rolled(c, history), history);
        run_ = as_the_run(c, history);
        if (is_pressed_alone(comparisons::Results(c, history)))
            loaded_ = &comparisons::not_prescribed(c);
    }

    void add(const char* key, Make make) {
        Case c = as_rolled_;
        const auto [chosen, changed] = make(c);
        LoadingVariant variant;
        variant.model = name_;
        variant.key = key;
        variant.chosen = chosen;
        variant.changed = changed;
        variant.run = run_;
        variant.loaded = loaded_;
        say_(fmt::format("{}: loading once more with {} = {}", name_, key, variant.changed));
        variant.why_none = contact::why_it_stopped(
            [&] { variant.other = run_values(contact::run(c, *model_.sibling(c.contact))); });
        variant.why_not_rolled = why_not_rolled_;
        variants_.push_back(std::move(variant));
    }

  private:
    /// What the variants are compared with: rolled like them, so rolled once more unless the run
    /// itself was.
    RunValues as_the_run(const Case& c, const History& history) {
        if (!c.rolling) return run_values(history);
        const RunValues loaded{history.static_shift};
        if (!as_rolled_.rolling) return loaded;
        const bool longer = as_rolled_.rolling->periods > c.rolling->periods;
        const bool same_steps = as_rolled_.rolling->steps == c.rolling->steps;
        if (same_steps && !(longer && history.verdict.state == State::undecided))
            return run_values(history);
        say_(fmt::format("{}: loading once more, rolled by turning points", name_));
        RunValues rolled = loaded;
        why_not_rolled_ = contact::why_it_stopped([&] {
            rolled = run_values(contact::run(as_rolled_, *model_.sibling(as_rolled_.contact)));
        });
        if (why_not_rolled_.empty()) return rolled;
        say_(fmt::format("{}: {}; other ways of loading are compared before rolling", name_,
                         why_not_rolled_));
        as_rolled_.rolling.reset();
        return loaded;
    }

    const contact::Model& model_;
    const std::string name_;
    const Say& say_;
    std::vector<LoadingVariant>& variants_;
    Case as_rolled_;
    std::string why_not_rolled_;
    RunValues run_;  ///< with the case's own choices
    const comparisons::Quantity* loaded_ = &comparisons::quantities::static_shift;
};

void study_variants(const Case& c, const contact::Model& model, const History& history,
                    const Say& say, comparisons::LoadingStudy& study) {
    // Normal traction displaces tangentially in the model's bodies, whether the case asks for it.
    const auto coupled = model.sibling({.coupling = true});
    if (!coupled || !coupled->is_coupled()) return;
    Variants variants(c, model, history, say, study.variants);
    if (model.sibling({.coupling = !c.contact.coupling}))
        variants.add("contact.coupling", [](Case& v) { return flip(v.contact.coupling); });
    if (model.is_coupled()) {
        variants.add("load.press", [](Case& v) { return flip(v.load.press); });
        if (c.load.press == Case::Press::friction && c.load.press_steps > 1)
            variants.add("load.press_steps", [](Case& v) { return change(v.load.press_steps, 1); });
    }
}

using comparisons::SpeedLimit;
using comparisons::TwinComparison;

RunValues run_once(const Case& c, const std::string& model, const contact::ModelRunner& runner) {
    return run_values(contact::run(c, *runner.make(model, c)));
}

void run_twin(const Case& c, const contact::ModelRunner& runner, const Say& say,
              TwinComparison& comparison) {
    say(fmt::format("{}: once more with the relaxed, elastic {}", comparison.model,
                    contact::relaxing_word(c)));
    comparison.why_none = contact::why_it_stopped([&] {
        comparison.other = run_once(comparisons::elastic_twin(c), comparison.model, runner);
    });
    const std::string found = comparisons::twin_sentence(comparison);
    if (!found.empty()) say(found);
}

SpeedLimit speed_limit(const Case& c, const TwinComparison& known,
                       const contact::ModelRunner& runner) {
    const auto error = [&](double speed) -> std::optional<double> {
        Case other = c;
        other.rolling->speed = speed;
        const auto found =
            comparisons::twin_error(*known.other, run_once(other, known.model, runner));
        return found ? std::optional(std::abs(*found)) : std::nullopt;
    };
    SpeedLimit limit = comparisons::find_speed_limit(*c.relaxation, known.drive->amplitude, error);
    limit.model = known.model;
    limit.of_increment = comparisons::judged_by_increment(*known.other);
    return limit;
}

}  // namespace

void study_loading(const Case& c, contact::Model& model, const History& history, const Say& say,
                   comparisons::LoadingStudy& study) {
    if (study.with_variants && !c.prescribed_path) study_variants(c, model, history, say, study);
    contact::why_it_stopped(  // numerical_error says why
        [&] { study.normal_stiffness[history.model] = frictionless_stiffness(c, model).value; });
    if (!c.indenter.body) return;
    contact::why_it_stopped([&] {
        if (const auto found = upper_contact(c, model)) study.upper_contact[history.model] = *found;
        if (const auto found = sticking_stiffness(c, model))
            study.tangential_stiffness[history.model] = found->value;
    });
}

void study_relaxation(const Case& c, const contact::History& history, const RunOptions& options,
                      const Say& say, comparisons::RelaxationStudy& study) {
    if (!c.relaxation || c.prescribed_path) return;
    TwinComparison comparison;
    comparison.model = history.model;
    comparison.drive = comparisons::drive_values(c, history.amplitude);
    comparison.run = run_values(history);
    if (!options.studies)
        comparison.why_none = "skipped (--no-studies)";
    else if (!comparisons::is_loaded(comparisons::tangential_ratio(history)))
        comparison.why_none = "without F_T there is no shift to be compared";
    else if (contact::model_kind(history.model).is_costly)
        comparison.why_none = "too costly with " + history.model + "; add bem-layer to get one";
    else
        run_twin(c, options.runner(), say, comparison);
    study.twins.push_back(comparison);
    const bool comparable = comparison.drive && comparison.other &&
                            comparisons::twin_error(*comparison.other, comparison.run);
    if (!comparable || study.limit) return;
    say(fmt::format("{}: looking for the drive speed from which on relaxation matters",
                    history.model));
    study.limit = speed_limit(c, comparison, options.runner());
}

void study_small_strains(const Case& c, const History& history, const RunOptions& options,
                         const Say& say, std::vector<comparisons::SmallStrains>& studies) {
    if (c.law == Case::Law::linear || !contact::model_kind(history.model).sees_finite_strains ||
        c.prescribed_path)
        return;
    comparisons::SmallStrains study{
        .model = history.model,
        .finite = comparisons::Results(c, history),
        .linear = {},
        .why_none = {},
        .long_steps = c.rolling && c.rolling->steps == Case::Steps::turning_points};
    if (!options.studies) {
        study.why_none = "skipped (--no-studies)";
    } else {
        say(fmt::format("{}: once more with a linear material", history.model));
        Case linear = contact::loaded_as(c, history);
        linear.law = Case::Law::linear;
        linear.c01_ratio.reset();
        study.why_none = contact::why_it_stopped([&] {
            study.linear =
                comparisons::Results(linear, options.runner().history_of(history.model, linear));
        });
    }
    studies.push_back(std::move(study));
}

}  // namespace tricontact::runs

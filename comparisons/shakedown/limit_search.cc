#include "comparisons/shakedown/limit_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "comparisons/quantities/map_border.h"
#include "comparisons/quantities/reference.h"
#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/own_limit.h"
#include "contact/run.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::State;

/// Increments that are too small to matter: near the limit they are about three times the distance
/// of f_T from it.
constexpr double negligible_part = 1e-2;

/// Where the search for an amplitude begins, over the contact radius.
constexpr double smallest_amplitude = 1e-6;

Case with_value(Case c, LimitVariable variable, double value) {
    if (variable == LimitVariable::load) {
        c.load.set_tangential_ratio(value);
    } else {
        c.rolling->amplitude.reset();
        c.rolling->amplitude_ratio = value;
    }
    return c;
}

/// Springs that those of the interface couple are stepped by a solver, as those of a layer.
double limit_tolerance(const Case& c, const std::string& name) {
    const contact::ModelKind& kind = contact::model_kind(name);
    return c.interface.is_elastic() && kind.is_independent() ? contact::ModelKind{}.limit_tolerance
                                                             : kind.limit_tolerance;
}

/// One model of a case, at one value after another.
class LimitSearch {
  public:
    LimitSearch(const Case& c, const std::string& name, const ModelMaker& make,
                const LimitQuestion& question, const SayLimit& say)
        : case_(c.load.is_by_limit() ? with_value(c, LimitVariable::load, 0) : c),
          make_(make),
          variable_(question.variable),
          tolerance_(question.tolerance.value_or(limit_tolerance(c, name))),
          say_(say) {
        found_.model = name;
        case_.rolling->periods = static_cast<int>(std::ceil(30 / std::sqrt(tolerance_)));
        case_.rolling->run_all = false;
        if (contact::turning_points_suffice(c)) case_.rolling->steps = Case::Steps::turning_points;
        found_.periods_at_most = case_.rolling->periods;
    }

    ModelLimit go() {
        found_.exact = exact_limit(case_, variable_, found_.model);
        const double high = variable_ == LimitVariable::load ? 1 : ratcheting_amplitude();
        found_.by_pressures = by_pressures(high);
        found_.bracket =
            find_limit([&](double value) { return verdict(value); }, 0, high, tolerance_);
        return std::move(found_);
    }

  private:
    /// The model for a value: amplitudes need beds and grids of their own size.
    contact::Model& model_for(const Case& c) {
        if (!model_ || variable_ == LimitVariable::amplitude)
            model_ = make_(c);
        else
            model_->release();
        return *model_;
    }

    struct Overlap {
        double limit, tangential_ratio;
    };

    Overlap overlap(const Case& c) {
        const auto [scales, limit] = contact::frictionless_limit(c, model_for(c));
        return {limit, tangential_ratio(c, {scales.normal_force, scales.sliding_force})};
    }

    /// By how much the points that are never left carry more than f_T.
    double excess(double amplitude) {
        const Overlap at = overlap(with_value(case_, LimitVariable::amplitude, amplitude));
        return at.limit - at.tangential_ratio;
    }

    /// An amplitude beyond the limit: a contact radius, or more where the model's is larger than
    /// that which ratios refer to.
    double ratcheting_amplitude() {
        double high = 1;
        while (excess(high) >= 0) high *= 1.5;
        return high;
    }

    double by_pressures(double high) {
        if (variable_ == LimitVariable::load) {
            const double limit = overlap(with_value(case_, LimitVariable::load, 0)).limit;
            if (limit > 0) return limit;
            throw contact::InputError(fmt::format(
                "{}: rolling by {:.4g} mm leaves no point in contact all the time: no load shakes "
                "down; lower rolling.amplitude or rolling.amplitude_ratio",
                found_.model,
                1e3 * contact::rolling_amplitude(
                          *case_.rolling, contact::half_space_scales(case_).contact_radius)));
        }
        const double least = 0.1 * tolerance_;
        std::uintmax_t evaluations = 60;
        const auto [low, up] = boost::math::tools::toms748_solve(
            [&](double w) { return excess(w); }, smallest_amplitude, high,
            [least](double a, double b) { return b - a < least; }, evaluations);
        return std::midpoint(low, up);
    }

    State verdict(double value) {
        const Case c = with_value(case_, variable_, value);
        contact::Model& model = model_for(c);
        const LimitRun run = roll(c, model, value);
        found_.coupled = model.is_coupled();
        found_.runs.push_back(run);
        say_(fmt::format("{}: {:.7g}: {} after {} periods", found_.model, value,
                         contact::name_of(run.state), run.periods));
        return run.state;
    }

    /// At upright positions and turning points.
    void watch_border(const contact::Model& model) {
        if (!case_.indenter.height_map || case_.period) return;
        const double here = border_force_share(*case_.indenter.height_map, model.surface());
        found_.border_force_share = std::max(found_.border_force_share.value_or(0), here);
    }

    LimitRun roll(const Case& c, contact::Model& model, double value) {
        const auto watch = [this](const auto&, const contact::Model& at, const auto& progress) {
            if (progress.quarter) watch_border(at);
        };
        const contact::History history =
            contact::run(c, model, watch, negligible_part * tolerance_);
        LimitRun result{.value = value,
                        .state = history.verdict.state,
                        .periods = static_cast<int>(history.shift_per_period.size())};
        double smallest = std::numeric_limits<double>::infinity(), before = history.static_shift;
        const double unit = history.scales.unit_shift;
        for (const double shift : history.shift_per_period) {
            if (std::abs(shift - before) < smallest) {
                smallest = std::abs(shift - before);
                result.slowest_shift_ratio = before / unit;
            }
            before = shift;
        }
        result.final_shift = before;
        result.final_shift_ratio = before / unit;
        return result;
    }

    Case case_;
    const ModelMaker& make_;
    LimitVariable variable_;
    double tolerance_;
    const SayLimit& say_;
    std::unique_ptr<contact::Model> model_;
    ModelLimit found_;
};

}  // namespace

ModelLimit search_limit(const Case& c, const std::string& model, const ModelMaker& make,
                        const LimitQuestion& question, const SayLimit& say) {
    return LimitSearch(c, model, make, question, say).go();
}

}  // namespace tricontact::comparisons

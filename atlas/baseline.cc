#include "atlas/baseline.h"

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "contact/bodies/half_space_scales.h"
#include "contact/special_values.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
namespace quantities = comparisons::quantities;
using contact::Case;
using Point = Baseline::Point;

struct ClosedForm {
    const Quantity* quantity;
    const char* name;
    double (*value)(const Point&);
};

const ClosedForm closed_forms[] = {
    {&quantities::static_shift_ratio, "u_stat of Cattaneo and Mindlin",
     [](const Point& p) { return p.u_stat; }},
    {&quantities::settled_shift_ratio, "u_sd of MDR", [](const Point& p) { return p.u_sd; }},
    {&quantities::limit_tangential_ratio, "f_T,lim of Hertz' pressure",
     [](const Point& p) { return p.limit; }},
    {&quantities::shift_increment_ratio, "w - w_lim", [](const Point& p) { return p.excess; }}};

const ClosedForm* find(const Quantity& q) {
    const auto* found = std::ranges::find(closed_forms, &q, &ClosedForm::quantity);
    return found == std::end(closed_forms) ? nullptr : found;
}

}  // namespace

Baseline::Baseline(const Case& base, const std::vector<std::string>& keys) {
    const bool is_ratio = base.rolling && base.rolling->amplitude_ratio &&
                          base.rolling->amplitude_reference == Case::AmplitudeReference::model;
    is_line_ = base.is_line_contact();
    if (!is_ratio || (!is_line_ && !contact::is_hertz_round(base))) return;
    const auto source = [&](const char* key, double value) {
        const auto found = std::ranges::find(keys, key);
        Source s{.place = {}, .value = value};
        if (found != keys.end()) s.place = static_cast<std::size_t>(found - keys.begin());
        return s;
    };
    w_ = source("rolling.amplitude_ratio", *base.rolling->amplitude_ratio);
    const Case::Load& load = base.load;
    if (load.tangential_ratio) {
        kind_ = Load::ratio;
        load_ = source("load.tangential_ratio", *load.tangential_ratio);
    } else if (load.limit_fraction) {
        kind_ = Load::fraction;
        load_ = source("load.limit_fraction", *load.limit_fraction);
    } else if (load.limit_excess) {
        kind_ = Load::excess;
        load_ = source("load.limit_excess", *load.limit_excess);
    }
    if (is_line_)
        lambda_ = contact::line_shift_factor(
            base.materials(), base.indenter.length / half_space_scales(base).contact_radius);
}

double Baseline::load_ratio(double limit, double load) const {
    if (kind_ == Load::ratio) return load;
    return kind_ == Load::fraction ? load * limit : limit + load * (1 - limit);
}

void Baseline::add_round(Point& p) const {
    p.u_stat = theory::static_shift_ratio(p.f);
    if (p.f < p.limit)
        p.u_sd = theory::settled_shift_ratio(p.w, p.f).value_or(contact::undefined);
    else
        p.excess = p.w - theory::amplitude_limit(p.f);
}

void Baseline::add_line(Point& p) const {
    p.u_stat = theory::line_static_shift_ratio(p.f, lambda_);
    if (p.f >= p.limit) {
        p.excess = p.w - theory::line_amplitude_limit(p.f);
    } else if (const auto stick = theory::line_stick_half_width(p.w, p.f)) {
        p.u_sd = theory::line_settled_shift_ratio(p.w, *stick, lambda_);
    }
}

Baseline::Point Baseline::at(std::span<const double> values) const {
    constexpr double nan = contact::undefined;
    Point p{nan, nan, nan, nan, nan, nan};
    if (kind_ == Load::none) return p;
    p.w = w_.at(values);
    if (!(p.w >= 0 && p.w <= 1)) return p;
    p.limit = is_line_ ? theory::line_shakedown_limit(p.w) : theory::shakedown_limit(p.w);
    p.f = load_ratio(p.limit, load_.at(values));
    if (!(p.f >= 0 && p.f <= 1)) return p;
    is_line_ ? add_line(p) : add_round(p);
    return p;
}

double Baseline::of(const Quantity& q, const Point& point) {
    const ClosedForm* form = find(q);
    const double value = form ? form->value(point) : 1;
    return std::isfinite(value) ? value : 1;
}

std::string Baseline::name_of(const Quantity& q) {
    const ClosedForm* form = find(q);
    return form ? form->name : "";
}

}  // namespace tricontact::atlas

#include "atlas/baseline.h"

#include <algorithm>
#include <cmath>

#include "atlas/map_coordinates.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer/layer_forms.h"
#include "theory/layer/line_layer_forms.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/mapped_ratcheting.h"
#include "theory/rolling/mapped_shakedown.h"
#include "theory/rolling/mapped_strength.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
namespace quantities = comparisons::quantities;
using contact::Case;
using Point = Baseline::Point;

// Ranges of the formulas. Beyond they are taken at the end: a map has no use for the best formula,
// but for one without a step.
constexpr double largest_amplitude = .85, least_thickness = .25, least_friction = .4;

constexpr const char* cattaneo = "u_stat of Cattaneo and Mindlin";
constexpr const char* line_static = "u_stat of a line contact";
constexpr const char* line_settled = "u_sd of a line contact";
constexpr const char* limit_of_hertz = "f_T,lim of Hertz' pressure";
constexpr const char* limit_of_lens = "the common contact's share of the area";
constexpr const char* strong_static = "u_stat of springs under a shear strength";
constexpr const char* beyond_limit = "w - w_lim";
constexpr const char* increment = "Delta u of the formula";
constexpr const char* slope = "eta of the formula";

}  // namespace

// Columns: springs, round, round_layer, line, line_layer, springs and round of a shear strength.
const Baseline::Formula Baseline::formulas[] = {
    {&quantities::static_shift_ratio,
     &Point::u_stat,
     {cattaneo, cattaneo, "u_stat of a lifted contact", line_static, line_static, strong_static,
      strong_static}},
    {&quantities::settled_shift_ratio,
     &Point::u_sd,
     {"u_sd of MDR", "u_sd of the mapped formula", "u_sd of a lifted contact", line_settled,
      line_settled, "u_sd of MDR", "u_sd of the mapped formula"}},
    {&quantities::kappa,
     &Point::mapping,
     {nullptr, "kappa of the mapped formula", "1/w", nullptr, nullptr, nullptr,
      "kappa of the mapped formula"}},
    {&quantities::limit_tangential_ratio,
     &Point::limit,
     {limit_of_hertz, limit_of_hertz, limit_of_hertz, limit_of_hertz, limit_of_hertz, limit_of_lens,
      limit_of_lens}},
    {&quantities::shift_increment_ratio,
     &Point::increment,
     {beyond_limit, beyond_limit, increment, increment, increment, nullptr, nullptr}},
    {&quantities::eta, &Point::slope, {nullptr, nullptr, slope, slope, slope, nullptr, nullptr}}};

Baseline::Baseline(const Case& base, const std::string& model,
                   const std::vector<std::string>& keys) {
    const bool is_ratio =
        !base.rolling || (base.rolling->amplitude_ratio &&
                          base.rolling->amplitude_reference == Case::AmplitudeReference::model);
    const Case::Load& load = base.load;
    const bool has_load = load.tangential_ratio || load.is_by_limit();
    const bool is_line = base.is_line_contact();
    if (!is_ratio || !has_load || (!is_line && !contact::is_hertz_round(base))) return;
    const auto source = [&](const char* key, double value) {
        const auto found = std::ranges::find(keys, key);
        Source s{.value = value};
        if (found != keys.end()) s.place = static_cast<std::size_t>(found - keys.begin());
        return s;
    };
    if (base.rolling) {
        w_ = source("rolling.amplitude_ratio", *base.rolling->amplitude_ratio);
        angle_ = source("rolling.angle", base.rolling->angle);
    }
    if (load.tangential_ratio) {
        kind_ = Load::ratio;
        load_ = source("load.tangential_ratio", *load.tangential_ratio);
    } else if (load.limit_fraction) {
        kind_ = Load::fraction;
        load_ = source("load.limit_fraction", *load.limit_fraction);
    } else {
        kind_ = Load::excess;
        load_ = source("load.limit_excess", *load.limit_excess);
    }
    const double radius = half_space_scales(base).contact_radius;
    poisson_ = source("substrate.poisson", base.substrate.poisson);
    friction_ = source("friction.coefficient", base.friction.coefficient.value_or(0));
    const contact::ModelKind& kind = contact::model_kind(model);
    const bool has_layer = !kind.is_half_space() && base.layer.thickness;
    if (has_layer)
        thickness_ = source("substrate.thickness_ratio", *base.layer.thickness / (2 * radius));
    const theory::RolledLaw* law = theory::rolled_law(base.friction);
    if (!law) return;
    if (!law->is_coulomb()) {
        if (is_line || has_layer) return;
        body_ = kind.is_on_line() ? Body::strong_springs : Body::strong_round;
    } else if (is_line) {
        body_ = has_layer ? Body::line_layer : Body::line;
        lambda_ = contact::line_shift_factor(base);
    } else {
        body_ = has_layer ? Body::round_layer : kind.is_on_line() ? Body::springs : Body::round;
    }
}

double Baseline::load_ratio(double limit, double load) const {
    if (kind_ == Load::ratio) return load;
    return kind_ == Load::fraction ? load * limit : limit + load * (1 - limit);
}

theory::MappedRolling Baseline::mapped(const Point& p, std::span<const double> values) const {
    return {.amplitude_ratio = std::min(p.w, largest_amplitude),
            .tangential_ratio = p.f,
            .angle = angle_.at(values),
            .poisson = std::clamp(poisson_.at(values), 0., .5)};
}

void Baseline::add_strong(Point& p, std::span<const double> values) const {
    const theory::RolledLaw& law = theory::strength_rolling;
    p.u_stat = law.static_shift(p.f);
    if (p.f >= p.limit) return;
    p.mapping = body_ == Body::strong_springs ? law.mdr_mapping
                                              : theory::strength_mapping(mapped(p, values));
    p.u_sd = law.settled_shift_ratio(p.w, p.f, p.mapping).value_or(contact::undefined);
}

void Baseline::add_round(Point& p, std::span<const double> values) const {
    const theory::MappedRolling own = mapped(p, values);
    p.u_stat = theory::static_shift_ratio(p.f);
    if (p.f >= p.limit) {
        p.increment = p.w - theory::amplitude_limit(p.f);
        return;
    }
    p.mapping = body_ == Body::springs ? theory::mdr_mapping : theory::half_space_mapping(own);
    p.u_sd = theory::settled_shift_ratio(p.w, p.f, p.mapping).value_or(contact::undefined);
}

// The load by the layer's own limit.
void Baseline::add_layer(Point& p, std::span<const double> values) const {
    const theory::LayerForm layer{
        .thickness_ratio = std::max(thickness_.at(values), least_thickness),
        .poisson = std::clamp(poisson_.at(values), 0., .5)};
    const double w = std::min(p.w, largest_amplitude);
    if (p.f > p.limit) {
        const theory::MappedRolling own{.amplitude_ratio = w,
                                        .tangential_ratio = p.f,
                                        .angle = angle_.at(values),
                                        .poisson = layer.poisson};
        p.increment = theory::half_space_shift_increment_ratio(own);
        p.slope = theory::half_space_ratcheting_slope(own);
    }
    const double limit = theory::layer_shakedown_limit(layer, w);
    const double f = load_ratio(limit, load_.at(values));
    const double friction = std::max(friction_.at(values), least_friction);
    p.mapping = 1 / p.w;
    p.u_stat = theory::layer_static_shift_ratio(layer, f);
    p.u_sd = theory::layer_settled_shift_ratio(layer,
                                               {.amplitude_ratio = w,
                                                .tangential_ratio = f,
                                                .angle = angle_.at(values),
                                                .poisson = layer.poisson},
                                               friction)
                 .value_or(contact::undefined);
}

// On a layer the logarithm ends at its thickness.
double Baseline::line_lambda(std::span<const double> values) const {
    if (body_ == Body::line) return lambda_;
    return theory::line_layer_shift_factor(
        {.thickness_ratio = std::max(thickness_.at(values), least_thickness),
         .poisson = std::clamp(poisson_.at(values), 0., .5)});
}

void Baseline::add_line(Point& p, double lambda) const {
    p.u_stat = theory::line_static_shift_ratio(p.f, lambda);
    if (p.f > p.limit) {
        p.increment = theory::line_shift_increment_ratio(p.w, p.f, lambda);
        p.slope = theory::line_ratcheting_slope(p.w, p.f) / lambda;
    } else if (const auto stick = theory::line_stick_half_width(p.w, p.f)) {
        p.u_sd = theory::line_settled_shift_ratio(p.w, *stick, lambda);
    }
}

Baseline::Point Baseline::at(std::span<const double> values) const {
    constexpr double nan = contact::undefined;
    Point p{nan, nan, nan, nan, nan, nan, nan, nan};
    if (body_ == Body::none) return p;
    p.w = w_.at(values);
    if (!(p.w >= 0 && p.w <= 1)) return p;
    const bool is_line = body_ == Body::line || body_ == Body::line_layer;
    p.limit = is_line       ? theory::line_shakedown_limit(p.w)
              : is_strong() ? theory::strength_rolling.exact_limit(p.w)
                            : theory::shakedown_limit(p.w);
    p.f = load_ratio(p.limit, load_.at(values));
    if (!(p.f >= 0 && p.f <= 1)) return p;
    if (is_line)
        add_line(p, line_lambda(values));
    else if (body_ == Body::round_layer)
        add_layer(p, values);
    else if (is_strong())
        add_strong(p, values);
    else
        add_round(p, values);
    return p;
}

const Baseline::Formula* Baseline::find(const Quantity& q) const {
    const auto* found = std::ranges::find(formulas, &q, &Formula::quantity);
    return found == std::end(formulas) || !name(*found) ? nullptr : found;
}

const char* Baseline::name(const Formula& formula) const {
    // Of a study without formulas the one of the half-space would be 1.
    if (body_ == Body::none) return nullptr;
    return formula.names[static_cast<std::size_t>(body_) - 1];
}

double Baseline::of(const Quantity& q, const Point& point) const {
    const Formula* formula = find(q);
    const double value = formula ? point.*(formula->value) : 1;
    return std::isfinite(value) ? value : 1;
}

std::string Baseline::name_of(const Quantity& q) const {
    const Formula* formula = find(q);
    return formula ? name(*formula) : "";
}

}  // namespace tricontact::atlas

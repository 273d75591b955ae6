// Whether an indenter that deforms is as large as a half-space.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

constexpr const char* section_run = "finite elements of a section of the body, on the layer";
constexpr const char* half_space_run = "boundary elements on the layer, a half-space in its place";
constexpr const char* not_computed = "not computed: a section of the indenter's body";

/// A quantity of both contacts, and what Hertz' formulas make of it.
struct IndenterQuantity {
    const char *name, *symbol, *unit, *words;
    Estimate BodyContact::*of;
    double (*hertz)(const RigData&);
};
const IndenterQuantity indenter_quantities[] = {
    {"indentation", "d", "m", "the indentation", &BodyContact::indentation,
     [](const RigData& r) { return hertz_of(r).indentation; }},
    {"contact_radius", "a", "m", "the contact radius", &BodyContact::contact_radius,
     [](const RigData& r) { return hertz_of(r).contact_radius; }},
    {"peak_pressure", "p_0", "Pa", "the peak pressure", &BodyContact::peak_pressure,
     [](const RigData& r) { return hertz_of(r).peak_pressure; }}};

/// Relative standard error that the rig's numbers leave in a quantity by Hertz' formulas.
double stated_error(const Rig& rig, const IndenterQuantity& q) {
    // A line's half width and pressure go with the same numbers, to other powers.
    if (rig.kind == Rig::Kind::cylinder) {
        const Calculation a =
            calculate(rig, q.name, q.symbol, "Hertz", "Hertz", q.unit, hertz_inputs,
                      [](const RigData& r) { return line_half_width_of(r); });
        return a.result.standard_error / a.result.value;
    }
    const Calculation hertz =
        calculate(rig, q.name, q.symbol, "Hertz", "Hertz", q.unit, hertz_inputs, q.hertz);
    return hertz.result.standard_error / hertz.result.value;
}

Calculation run_of(const IndenterQuantity& q, const std::string& name, const Estimate& value,
                   const char* run) {
    return calculate(name, q.symbol, "a run of the rig's indenter", run, q.unit,
                     {{q.symbol, value, q.unit}}, [](const auto& x) { return x.front(); });
}

}  // namespace

Assumption half_space_indenter(const Rig& rig, const IndenterRun& run) {
    using enum Criterion::Relation;
    Assumption a{.name = "half_space_indenter",
                 .title = "Indenter as half-space",
                 .claim = "The indenter is as large as a half-space"};
    if (!rig.c.indenter.body) {
        a.missing = {"indenter.body", "indenter.support"};
        return a;
    }
    const auto contacts = run ? run(rig) : std::nullopt;
    if (!contacts) {
        a.missing = {not_computed};
        return a;
    }
    std::string off;
    for (const IndenterQuantity& q : indenter_quantities) {
        const Estimate &body = contacts->body.*q.of, &half_space = contacts->half_space.*q.of;
        if (std::isnan(body.value) || std::isnan(half_space.value)) continue;
        const std::string name = std::string("indenter_") + q.name;
        const double stated = stated_error(rig, q);
        a.criteria.push_back(
            {relative_difference(name + "_difference",
                                 fmt::format("|{0} half-space/{0} body - 1|", q.symbol),
                                 "runs of the rig's indenter", section_run,
                                 {std::string(q.symbol) + " half-space", half_space, q.unit},
                                 {std::string(q.symbol) + " body", body, q.unit}),
             at_most, stated > 0 ? stated : accepted_difference,
             stated > 0
                 ? fmt::format("the standard error that the rig's numbers leave in {} by Hertz",
                               q.symbol)
                 : accepted_reason});
        a.background.push_back(run_of(q, name, body, section_run));
        a.background.push_back(run_of(q, name + "_of_half_space", half_space, half_space_run));
        const double ratio = half_space.value / body.value;
        off += fmt::format("{}{} {} {}", off.empty() ? "" : ", ", q.words,
                           percent_text(std::abs(ratio - 1)), ratio < 1 ? "too low" : "too high");
    }
    a.consequence = fmt::format(
        "A half-space in place of the indenter's body, on the same layer, puts {}.", off);
    return a;
}

}  // namespace tricontact::experiments

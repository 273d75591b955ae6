#include "experiments/design/design_requirements.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "experiments/assumptions/rolling_parts.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

/// Findings of zero and below: as good as anything.
constexpr double least_ratio = 1e-9;

Requirement requirement_of(const Assumption& assumption, const Criterion& criterion,
                           double deviation) {
    const bool is_difference = criterion.relation == Criterion::Relation::at_most &&
                               criterion.threshold == accepted_difference;
    return {.name = criterion.calculation.name,
            .symbol = criterion.calculation.symbol,
            .unit = criterion.calculation.unit,
            .claim = assumption.claim,
            .relation = criterion.relation,
            .limit = is_difference ? deviation : criterion.threshold};
}

[[noreturn]] void refuse_unknown(const DesignInput& input, const std::string& name,
                                 const RigReport& report) {
    std::vector<std::string_view> all, assumptions;
    for (const Assumption& one : report.assumptions) {
        all.push_back(one.name);
        assumptions.push_back(one.name);
        for (const Criterion& criterion : one.criteria) all.push_back(criterion.calculation.name);
    }
    // Which criteria there are depends on the body.
    const io::Entry* shape = input.rig.document.find("indenter.shape");
    io::refuse(
        input.rig.document, "design.assumptions",
        "the check of this rig" + (shape ? " of " + shape->subject() : "") +
            " has no assumption or criterion \"" + name + '"',
        io::did_you_mean(io::nearest(name, all), "assumptions are " + io::joined(assumptions) +
                                                     "; criteria stand in rig.json"));
}

void add(std::vector<Requirement>& all, const DesignInput& input, const std::string& name,
         const RigReport& report) {
    const std::size_t before = all.size();
    for (const Assumption& assumption : report.assumptions) {
        if (assumption.name == name && assumption.criteria.empty())
            io::refuse(input.rig.document, "design.assumptions",
                       '"' + name + "\" has no number that a design could change; not given: " +
                           io::joined(assumption.missing),
                       "give it, or omit the assumption");
        for (const Criterion& criterion : assumption.criteria)
            if (name == assumption.name || name == criterion.calculation.name)
                all.push_back(requirement_of(assumption, criterion, input.deviation));
    }
    if (all.size() == before) refuse_unknown(input, name, report);
}

}  // namespace

double Requirement::ratio(double finding) const {
    const double ratio =
        relation == Criterion::Relation::at_most ? finding / limit : limit / finding;
    return ratio < least_ratio ? least_ratio : ratio;
}

double Requirement::finding(double ratio) const {
    return relation == Criterion::Relation::at_most ? ratio * limit : limit / ratio;
}

std::vector<Requirement> requirements_of(const DesignInput& input, const RigReport& report) {
    std::vector<Requirement> all;
    for (const std::string& name : input.assumptions) add(all, input, name, report);
    if (input.resolution)
        all.push_back({.name = "resolution",
                       .symbol = "resolution of the comparison",
                       .unit = "1",
                       .claim = {},
                       .limit = *input.resolution});
    for (std::size_t i = 0; i < input.laws.laws.size(); ++i)
        all.push_back({.name = "separation from " + input.laws.laws[i],
                       .symbol = "D",
                       .unit = "1",
                       .claim = "the law of friction is told from " + input.laws.laws[i],
                       .relation = Criterion::Relation::at_least,
                       .limit = told_distance,
                       .law = i});
    for (auto one = all.begin(); one != all.end(); ++one) {
        if (std::find_if(all.begin(), one,
                         [&](const Requirement& other) { return other.name == one->name; }) != one)
            io::refuse(input.rig.document, one->law ? "design.laws" : "design.assumptions",
                       one->name + " is asked for twice", "name each once");
        if (!(one->limit > 0))
            io::refuse(input.rig.document, "design.assumptions",
                       one->name + " has the limit 0, over which no margin is defined", "omit it");
    }
    return all;
}

double ratio_in(const RigReport& report, const Requirement& requirement) {
    for (const Assumption& assumption : report.assumptions)
        for (const Criterion& criterion : assumption.criteria)
            if (criterion.calculation.name == requirement.name)
                return requirement.ratio(criterion.calculation.result.value);
    return contact::undefined;
}

}  // namespace tricontact::experiments

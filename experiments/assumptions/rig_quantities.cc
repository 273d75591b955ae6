#include "experiments/assumptions/rig_quantities.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/keys/units.h"

namespace tricontact::experiments {

namespace {

std::vector<Inputs::Member> members_of(const Rig& rig, const Inputs& inputs) {
    std::vector<Inputs::Member> members(inputs.begin(), inputs.end());
    if (rig.kind != Rig::Kind::cylinder) std::erase(members, &Rig::L);
    return members;
}

const RigQuantity& quantity_of(const Rig& rig, Inputs::Member member) {
    return *std::ranges::find(rig_quantities(rig.kind), member, &RigQuantity::number);
}

bool is_known(const Rig& rig, const Inputs& inputs) {
    return std::ranges::all_of(members_of(rig, inputs),
                               [&](auto one) { return number_of(rig, one).is_known(); });
}

// The keys without which a quantity is not known.
void add_missing(Assumption& assumption, const Rig& rig, Inputs::Member member) {
    if (number_of(rig, member).is_known()) return;
    const RigQuantity& one = quantity_of(rig, member);
    if (one.formula)
        for (const auto other : members_of(rig, one.formula->given))
            add_missing(assumption, rig, other);
    else if (std::ranges::count(assumption.missing, one.path) == 0)
        assumption.missing.emplace_back(one.path);
}

}  // namespace

RigNumber number_of(const Rig& rig, Inputs::Member member) {
    if ((rig.*member).is_known()) return rig.*member;
    const RigQuantity& one = quantity_of(rig, member);
    if (one.of) return one.of(rig);
    if (!one.formula || !is_known(rig, one.formula->given)) return {};
    return calculate(rig, *one.formula).result;
}

Calculation calculate(const Rig& rig, std::string name, std::string symbol, std::string formula,
                      std::string source, std::string unit, const Inputs& inputs,
                      std::function<double(const RigData&)> function,
                      std::vector<Given> constants) {
    std::vector<Given> given;
    std::vector<std::string> paths;
    std::vector<Inputs::Member> members = members_of(rig, inputs);
    for (const auto member : members) {
        const RigQuantity& one = quantity_of(rig, member);
        given.push_back({std::string(one.symbol), number_of(rig, member),
                         std::string(io::si_unit(one.dimension))});
        // What follows is taken as independent of what it follows from.
        paths.emplace_back((rig.*member).is_known() ? one.path : "");
    }
    given.insert(given.end(), constants.begin(), constants.end());
    paths.resize(given.size());
    return calculate(
        std::move(name), std::move(symbol), std::move(formula), std::move(source), std::move(unit),
        std::move(given),
        [members = std::move(members), function = std::move(function)](const Values& x) {
            RigData data;
            for (std::size_t i = 0; i < members.size(); ++i) data.*members[i] = x[i];
            return function(data);
        },
        rig.correlations.of(paths));
}

Calculation calculate(const Rig& rig, const Formula& f) {
    return calculate(rig, f.name, f.symbol, f.formula, f.source, f.unit, f.given, f.function);
}

Calculation relative_difference(std::string name, std::string symbol, std::string formula,
                                std::string source, Given with, Given without) {
    return calculate(std::move(name), std::move(symbol), std::move(formula), std::move(source), "1",
                     {std::move(with), std::move(without)},
                     [](const Values& x) { return std::abs(x.front() / x.back() - 1); });
}

std::vector<Calculation> known(const Rig& rig, const std::vector<const Formula*>& formulas) {
    std::vector<Calculation> result;
    for (const Formula* formula : formulas)
        if (is_known(rig, formula->given)) result.push_back(calculate(rig, *formula));
    return result;
}

bool has_all(Assumption& assumption, const Rig& rig, const Inputs& inputs) {
    for (const auto member : members_of(rig, inputs)) add_missing(assumption, rig, member);
    return is_known(rig, inputs);
}

bool decide(Assumption& assumption, const Rig& rig, const Formula& formula,
            Criterion::Relation relation, double threshold, std::string reason) {
    if (!has_all(assumption, rig, formula.given)) return false;
    assumption.criteria.push_back(
        {calculate(rig, formula), relation, threshold, std::move(reason)});
    return true;
}

}  // namespace tricontact::experiments

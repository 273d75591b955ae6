#include <algorithm>
#include <cmath>

#include "contact/substrates/relaxing_case.h"
#include "io/case/case_checks.h"
#include "io/case/case_keys.h"
#include "io/tables/body_tables.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Relaxation;
using Input = Case::RelaxationInput;

const std::string prefix = "substrate.relaxation.";

// The shape of the table, ratios over its relaxed modulus, goes with the case's own modulus.
void resolve_dma(Case& c, const Document& document) {
    Input& input = c.relaxation_input;
    const std::string key = prefix + "dma";
    check_file_there(document, key, *input.dma, "name a table");
    told_at(document, key, [&] { c.dma_fit = contact::fit_prony(read_dma_table(*input.dma)); });
    for (const auto& [ratio, time] : c.dma_fit->relaxation.branches) {
        input.moduli.push_back(ratio * c.substrate.shear_modulus());
        input.times.push_back(time);
    }
    input.dma.reset();
}

void check_lists(const Input& input, const Document& document) {
    const std::size_t n = input.moduli.size();
    if (input.times.size() != n)
        refuse(document, prefix + "times",
               "has " + std::to_string(input.times.size()) + " elements, but moduli has " +
                   std::to_string(n),
               "give one relaxation time for each modulus");
    for (auto it = input.times.begin(); it != input.times.end(); ++it)
        if (std::find(input.times.begin(), it, *it) != it)
            refuse(document, prefix + "times", "the time " + rounded(*it) + " s stands twice",
                   "make one term of the two, with the sum of their moduli");
}

// Quotients of extreme numbers leave what the keys admit and double precision can hold.
void check_branches(const Case& c, const std::string& key, const Document& document) {
    const Range& times = find_key("substrate.relaxation.times")->range;
    const Range& moduli = find_key("substrate.relaxation.moduli")->range;
    for (std::size_t i = 0; i < c.relaxation_input.moduli.size(); ++i) {
        const auto [ratio, time] = c.relaxation->branches[i];
        if (!times.contains(time))
            refuse(document, key, "the relaxation time " + rounded(time) + " s is out of range",
                   "check the units of moduli, viscosity and times");
        if (!moduli.contains(c.relaxation_input.moduli[i]) || !(ratio > 0) || !std::isfinite(ratio))
            refuse(document, key,
                   "the modulus " + rounded(c.relaxation_input.moduli[i]) +
                       " Pa is out of range or out of proportion to the relaxed shear modulus " +
                       rounded(c.substrate.shear_modulus()) + " Pa",
                   "check the units of the moduli and of substrate.young");
    }
}

Relaxation::Branch branch(const Case& c, std::size_t i) {
    return {c.relaxation_input.moduli[i] / c.substrate.shear_modulus(),
            c.relaxation_input.times[i]};
}

void refuse_for_mdr(const std::string& model, contact::Unrelaxed stays, bool ground,
                    const Document& document) {
    const std::string but = ", but " + model + " lets everything relax alike";
    switch (stays) {
        case contact::Unrelaxed::nothing:
            return;
        case contact::Unrelaxed::bulk:
            refuse(document, prefix + "bulk",
                   "below poisson = 0.5 shear then relaxes without the bulk" + but,
                   "leave the model out, or say bulk = \"proportional\" if the bulk relaxes alike");
        case contact::Unrelaxed::below:
            refuse(document, ground ? "ground.young" : "lower_layer.young",
                   "what is below the relaxing layer does not relax" + but, "leave the model out");
        case contact::Unrelaxed::indenter:
            refuse(
                document, "indenter.young",
                "1e-3 of the compliance or more is then the indenter's, which does not relax" + but,
                "leave the model out, or omit young and poisson of the indenter to take it as "
                "rigid");
    }
}

bool says(const Input& input, const Case& c) {
    const auto& branches = c.relaxation->branches;
    if (input.moduli.size() != branches.size() || input.times.size() != branches.size())
        return false;
    for (std::size_t i = 0; i < branches.size(); ++i)
        if (branch(c, i).ratio != branches[i].ratio || branch(c, i).time != branches[i].time)
            return false;
    return true;
}

}  // namespace

void resolve_relaxation(Case& c, const Document& document) {
    if (!c.relaxation) return;
    Input& input = c.relaxation_input;
    std::string key = prefix + "moduli";
    if (input.maxwell_modulus) {
        key = prefix + "eta";
        input.moduli = {*input.maxwell_modulus};
        input.times = {*input.viscosity / *input.maxwell_modulus};
        input.maxwell_modulus = input.viscosity = std::nullopt;
    } else if (input.dma) {
        key = prefix + "dma";
        resolve_dma(c, document);
    }
    check_lists(input, document);
    for (std::size_t i = 0; i < input.moduli.size(); ++i)
        c.relaxation->branches.push_back(branch(c, i));
    check_branches(c, key, document);
}

void state_relaxation(Case& c) {
    if (!c.relaxation || says(c.relaxation_input, c)) return;
    c.relaxation_input = {};
    for (const auto& [ratio, time] : c.relaxation->branches) {
        c.relaxation_input.moduli.push_back(ratio * c.substrate.shear_modulus());
        c.relaxation_input.times.push_back(time);
    }
}

void check_relaxation(const Case& c, const Document& document) {
    if (!c.relaxation) return;
    if (c.rolling && c.rolling->steps == Case::Steps::turning_points)
        refuse(document, "rolling.steps",
               "the forces of a relaxing substrate depend on the path between the turning points",
               "give rolling.steps_per_quarter or rolling.increment instead of rolling.steps");
    for (const std::string& model : c.models) {
        const bool layer = model != "mdr" && model != "bem";
        const auto stays = contact::what_stays(layer ? c : contact::without_layer(c));
        if (stays == contact::Unrelaxed::nothing) continue;
        if (model == "mdr" || model == "mdr-layer")
            refuse_for_mdr(model, stays, c.layer.ground.has_value(), document);
        if (c.output.volume != Case::VolumeOutput::none)
            refuse(document, "output.volume",
                   "fields inside are not known where a part of the stiffness relaxes",
                   "leave output.volume out");
    }
}

}  // namespace tricontact::io

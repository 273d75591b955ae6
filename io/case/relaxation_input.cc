#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"
#include "io/results/output.h"
#include "io/tables/body_tables.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Relaxation;
using Input = RelaxationInput;

const std::string prefix = "substrate.relaxation.";

// A Prony series, and what the relaxed modulus is of the unrelaxed one.
struct Series {
    std::string key;             // that says it
    std::vector<double> moduli;  // G_i beside the relaxed one [Pa]
    std::vector<double> times;   // [s]
    double relaxed_share = 1;    // G_inf/G_0
};

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.);
}

bool is_unrelaxed(const Case& c) {
    return c.of<Input>().modulus == Input::Modulus::unrelaxed;
}

Series of_moduli(const Case& c, Series series, const Document& document) {
    const double given = contact::relaxing_material(c).shear_modulus(), sum = sum_of(series.moduli);
    if (!is_unrelaxed(c)) return series;
    if (!(sum < given))
        refuse(document, series.key,
               "the moduli sum to " + rounded(sum) +
                   " Pa, no less than the unrelaxed shear modulus " + rounded(given) +
                   " Pa: nothing would be left at rest",
               "check them and substrate.young, or set modulus = \"relaxed\"");
    series.relaxed_share = (given - sum) / given;
    return series;
}

Series of_relative(const Case& c, const Document& document) {
    const Input& input = c.of<Input>();
    Series series{prefix + "relative_moduli", input.relative_moduli, input.times};
    const double sum = sum_of(input.relative_moduli),
                 given = contact::relaxing_material(c).shear_modulus();
    if (!(sum < 1))
        refuse(document, series.key,
               "the sum is " + rounded(sum) + ": nothing would be left at rest",
               "give moduli over the unrelaxed one, G_i/G_0");
    series.relaxed_share = 1 - sum;
    const double unrelaxed = is_unrelaxed(c) ? given : given / series.relaxed_share;
    for (double& modulus : series.moduli) modulus *= unrelaxed;
    return series;
}

// The shape of the table, ratios over its relaxed modulus, goes with the case's own modulus.
Series of_fit(const Case& c, Series series, const Relaxation& fit) {
    series.relaxed_share = 1 / fit.instantaneous_ratio();
    const double given = contact::relaxing_material(c).shear_modulus(),
                 relaxed = is_unrelaxed(c) ? given * series.relaxed_share : given;
    for (const auto& [ratio, time] : fit.branches) {
        series.moduli.push_back(ratio * relaxed);
        series.times.push_back(time);
    }
    return series;
}

Series of_dma(Case& c, const Document& document) {
    const std::string& table = *c.of<Input>().dma;
    const Series series{prefix + "dma", {}, {}};
    check_file_there(document, series.key, table, "name a table");
    auto& fit = c.of<RelaxationFits>().dma;
    told_at(document, series.key, [&] { fit = contact::fit_prony(read_dma_table(table)); });
    return of_fit(c, series, fit->relaxation);
}

Series of_test(Case& c, const Document& document) {
    const std::string& table = *c.of<Input>().test;
    const Series series{prefix + "test", {}, {}};
    check_file_there(document, series.key, table, "name a table");
    auto& fit = c.of<RelaxationFits>().test;
    told_at(document, series.key, [&] { fit = contact::fit_prony(read_relaxation_test(table)); });
    if (fit->table.is_young && c.relaxation->bulk == Relaxation::Bulk::elastic &&
        contact::what_stays(c) == contact::Unrelaxed::bulk)
        refuse(document, prefix + "bulk",
               "E(t) of " + fit->table.name +
                   " relaxes otherwise than G(t) where the bulk modulus does not relax",
               "give a table of G(t), or bulk = \"proportional\"");
    return of_fit(c, series, fit->relaxation);
}

Series series_of(Case& c, const Document& document) {
    const Input& input = c.of<Input>();
    if (!input.times.empty() && (input.maxwell_modulus || input.dma || input.test))
        refuse(document, prefix + "times",
               "has no effect without moduli or relative_moduli, which are missing",
               "omit this key");
    if (input.maxwell_modulus)
        return of_moduli(
            c,
            {prefix + "eta", {*input.maxwell_modulus}, {*input.viscosity / *input.maxwell_modulus}},
            document);
    if (input.dma) return of_dma(c, document);
    if (input.test) return of_test(c, document);
    if (!input.relative_moduli.empty()) return of_relative(c, document);
    return of_moduli(c, {prefix + "moduli", input.moduli, input.times}, document);
}

// The relaxed bodies of such as were given as they are at once.
void take_relaxed(Case& c, double share) {
    Case relaxed = contact::with_relaxing_ratio(c, share);
    c.substrate = relaxed.substrate;
    c.indenter.material = relaxed.indenter.material;
}

void check_lists(const Series& series, const Document& document) {
    const std::size_t n = series.times.size();
    if (n != series.moduli.size())
        refuse(document, prefix + "times",
               "has " + std::to_string(n) + " elements, but " +
                   std::string(name_of_key(series.key)) + " has " +
                   std::to_string(series.moduli.size()),
               "give one relaxation time for each modulus");
    for (auto it = series.times.begin(); it != series.times.end(); ++it)
        if (std::find(series.times.begin(), it, *it) != it)
            refuse(document, prefix + "times", "the time " + rounded(*it) + " s stands twice",
                   "make one term of the two, with the sum of their moduli");
}

// Quotients of extreme numbers leave what the keys admit and double precision can hold.
void check_branches(const Case& c, const std::string& key, const Document& document) {
    const Range& times = find_key("substrate.relaxation.times")->range;
    const Range& moduli = find_key("substrate.relaxation.moduli")->range;
    for (std::size_t i = 0; i < c.of<Input>().moduli.size(); ++i) {
        const auto [ratio, time] = c.relaxation->branches[i];
        if (!times.contains(time))
            refuse(document, key, "the relaxation time " + rounded(time) + " s is out of range",
                   "check the units of moduli, viscosity and times");
        if (!moduli.contains(c.of<Input>().moduli[i]) || !(ratio > 0) || !std::isfinite(ratio))
            refuse(document, key,
                   "the modulus " + rounded(c.of<Input>().moduli[i]) +
                       " Pa is out of range or out of proportion to the relaxed shear modulus " +
                       rounded(contact::relaxing_material(c).shear_modulus()) + " Pa",
                   "check the units of the moduli and of substrate.young");
    }
}

Relaxation::Branch branch(const Case& c, std::size_t i) {
    return {c.of<Input>().moduli[i] / contact::relaxing_material(c).shear_modulus(),
            c.of<Input>().times[i]};
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
                   "leave the model out, or set bulk = \"proportional\" if the bulk relaxes alike");
        case contact::Unrelaxed::below:
            refuse(document, ground ? "ground.young" : "lower_layer.young",
                   "what is below the relaxing layer does not relax" + but, "leave the model out");
        case contact::Unrelaxed::indenter:
            refuse(
                document, "indenter.young",
                "1e-3 of the compliance or more is then the indenter's, which does not relax" + but,
                "leave the model out, or omit young and poisson of the indenter to take it as "
                "rigid");
        case contact::Unrelaxed::substrate:
            refuse(document, prefix + "body", "the substrate does not relax" + but,
                   "leave the model out, or take substrate.rigid = true");
        case contact::Unrelaxed::interface:
            refuse(document, "interface", "the springs of the interface do not relax" + but,
                   "leave the model out");
    }
}

void check_relaxing_body(const Case& c, const Document& document) {
    const std::string key = prefix + "body";
    if (c.has_rigid_substrate && contact::substrate_relaxes(c))
        refuse(document, "substrate.rigid", "a rigid substrate does not relax",
               "omit it, or take substrate.relaxation.body = \"indenter\"");
    if (!contact::indenter_relaxes(c)) return;
    if (!c.indenter.material)
        refuse(document, key, "the indenter is rigid", "give indenter.young and indenter.poisson");
    if (c.rolling || c.tractive_rolling || contact::path_reach(c, c.indenter.radius)[0] > 0)
        refuse(document, key, "an indenter that relaxes stays where it is pressed",
               "leave out what rolls it, or take body = \"substrate\"");
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
    check_relaxing_body(c, document);
    Series series = series_of(c, document);
    check_lists(series, document);
    if (is_unrelaxed(c)) take_relaxed(c, series.relaxed_share);
    c.of<Input>() = {.moduli = std::move(series.moduli), .times = std::move(series.times)};
    for (std::size_t i = 0; i < c.of<Input>().moduli.size(); ++i)
        c.relaxation->branches.push_back(branch(c, i));
    check_branches(c, series.key, document);
}

void state_relaxation(Case& c) {
    if (!c.relaxation || says(c.of<Input>(), c)) return;
    c.of<Input>() = {};
    for (const auto& [ratio, time] : c.relaxation->branches) {
        c.of<Input>().moduli.push_back(ratio * contact::relaxing_material(c).shear_modulus());
        c.of<Input>().times.push_back(time);
    }
}

void check_relaxation(const Case& c, const Document& document) {
    if (!c.relaxation) return;
    if (c.rolling && c.rolling->steps == Case::Steps::turning_points)
        refuse(document, "rolling.steps",
               "the forces of a relaxing substrate depend on the path between the turning points",
               "give rolling.steps_per_quarter or rolling.increment instead of rolling.steps");
    for (const std::string& model : c.models) {
        const contact::ModelKind& kind = contact::model_kind(model);
        const auto stays =
            contact::what_stays(kind.is_half_space() ? contact::without_layer(c) : c);
        if (stays == contact::Unrelaxed::nothing) continue;
        if (kind.is_on_line()) refuse_for_mdr(model, stays, c.layer.ground.has_value(), document);
        if (c.of<Output>().volume != Output::Volume::none)
            refuse(document, "output.volume",
                   "fields inside are not known where a part of the stiffness relaxes",
                   "leave output.volume out");
    }
}

}  // namespace tricontact::io

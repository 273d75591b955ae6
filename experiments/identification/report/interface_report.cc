// Springs of the interface beside rigid ones: sentences, table and JSON.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/identification/identification_report.h"
#include "experiments/identification/interface_parameters.h"
#include "io/keys/messages.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

std::string fit_numbers(const InterfaceFit& fit) {
    std::string text;
    for (std::size_t k = 0; k < fit.found.free.size(); ++k)
        text += (k == 0 ? "" : ", ") + found_text(fit.found, k);
    return text;
}

/// "likelihood ratio 43.1, p < 0.001, AICc 38.2 above the least".
std::string criteria(const InterfaceFit& fit) {
    return fmt::format("likelihood ratio {}, {}; AICc {} above the least",
                       report::significant(fit.likelihood_ratio, 3), report::p_value(fit.chance),
                       report::significant(fit.aicc_difference, 3));
}

/// Of the numbers beside springs, by how many percent a rigid interface misses the one most.
std::string bias_of_rigid(const InterfaceFit& rigid, const InterfaceFit& all) {
    double largest = -1;
    std::string text;
    for (std::size_t k = 0; k < rigid.found.free.size(); ++k) {
        const FreeParameter& p = rigid.found.free[k];
        const auto other = all.found.find(p.key, p.index);
        if (!other || p.is_sized()) continue;
        const double off = rigid.found.parameters[k].value / all.found.parameters[*other].value - 1;
        if (std::abs(off) <= largest) continue;
        largest = std::abs(off);
        text = fmt::format("{} = {} ({:+.2g} %)", p.symbol,
                           p.shown(rigid.found.parameters[k].value), 100 * off);
    }
    return text;
}

}  // namespace

std::string found_text(const Identification& found, std::size_t k) {
    const FreeParameter& p = found.free[k];
    const auto [low, high] = found.parameters[k].likelihood;
    if (!std::isfinite(high)) return fmt::format("{} above {}", p.symbol, p.shown(low));
    return p.symbol + " = " + p.shown(found.parameters[k].value, low, high);
}

std::vector<Verdict> interface_verdicts(const IdentificationStudy& study) {
    if (!study.interfaces) return {};
    const auto& fits = study.interfaces->fits;
    const InterfaceFit &rigid = fits.front(), &all = fits.back();
    std::vector<Verdict> verdicts;
    const bool is_adhesion = study.interfaces->is_adhesion;
    if (rigid.is_excluded) {
        const std::string bias = bias_of_rigid(rigid, all);
        verdicts.push_back(
            {finding,
             fmt::format("{} excluded ({}){}.",
                         is_adhesion ? "Surfaces that do not attract each other are"
                                     : "A rigid interface is",
                         criteria(rigid),
                         bias.empty()
                             ? ""
                             : (is_adhesion ? "; they would give " : "; it would give ") + bias)});
    } else {
        verdicts.push_back(
            {not_resolved, fmt::format("These data do not tell {} ({}), with which {}.",
                                       is_adhesion ? "attraction of the surfaces from none"
                                                   : "springs of the interface from a rigid one",
                                       criteria(rigid), fit_numbers(rigid))});
    }
    if (is_adhesion && fits.size() == 3) {
        const bool differ = fits[1].is_excluded;
        verdicts.push_back(
            {differ ? finding : not_resolved,
             differ ? fmt::format("One work of adhesion for approach and separation is excluded "
                                  "({}); it would give {}.",
                                  criteria(fits[1]), bias_of_rigid(fits[1], all))
                    : fmt::format("These data do not tell the work of approach from that of "
                                  "separation ({}), with which {}.",
                                  criteria(fits[1]), fit_numbers(fits[1]))});
        return verdicts;
    }
    for (std::size_t i = 1; i + 1 < fits.size(); ++i)
        if (rigid.is_excluded)
            verdicts.push_back(
                {finding,
                 fmt::format("Of the springs, {} {} excluded ({}).", fits[i].name + " alone",
                             fits[i].is_excluded ? "is" : "is not", criteria(fits[i]))});
    return verdicts;
}

report::DocumentTable interface_table(const InterfaceComparison& interfaces) {
    report::DocumentTable table{
        .id = "interfaces",
        .title = interfaces.is_adhesion ? "Attraction of the surfaces" : "Springs of the interface",
        .note =
            "-2 ln L: without a constant. AICc: Akaike's criterion for few observations, less "
            "is better. p: of the likelihood ratio beside all that was asked for; without it the "
            "interface is at the end of a range, where p is twice too large at most.",
        .columns = report::columns(interfaces.is_adhesion ? "attraction" : "springs", "numbers",
                                   "-2 ln L:5", "AICc:5", "above the least:3", "likelihood ratio:3",
                                   "p", "verdict")};
    for (const InterfaceFit& fit : interfaces.fits) {
        const bool is_all = &fit == &interfaces.fits.back();
        table.rows.push_back({fit.name, fit_numbers(fit), fit.likelihood.minus_two_log,
                              fit.likelihood.aicc, fit.aicc_difference,
                              is_all ? contact::undefined : fit.likelihood_ratio,
                              report::p_number(is_all ? contact::undefined : fit.chance),
                              fit.is_excluded ? "excluded" : "not excluded"});
    }
    return table;
}

std::string interface_lines(const InterfaceComparison& interfaces) {
    std::string text = fmt::format("{:<22} {:>10} {:>8}  {:<24} {}\n",
                                   interfaces.is_adhesion ? "attraction" : "springs", "AICc", "+",
                                   "likelihood ratio", "numbers");
    for (const InterfaceFit& fit : interfaces.fits)
        text +=
            fmt::format("{:<22} {:>10} {:>8}  {:<24} {}\n", fit.name,
                        report::significant(fit.likelihood.aicc, 5),
                        report::significant(fit.aicc_difference, 3),
                        &fit == &interfaces.fits.back()
                            ? ""
                            : fmt::format("{}, {}", report::significant(fit.likelihood_ratio, 3),
                                          report::p_value(fit.chance)),
                        fit_numbers(fit));
    return text;
}

nlohmann::ordered_json interface_json(const InterfaceComparison& interfaces) {
    using json = nlohmann::ordered_json;
    json result = json::object();
    for (const InterfaceFit& fit : interfaces.fits) {
        json one = json::object();
        for (std::size_t k = 0; k < fit.found.free.size(); ++k) {
            const auto& estimate = fit.found.parameters[k];
            one[fit.found.free[k].name] = {
                {"value", estimate.value},
                {"likelihood_interval", {estimate.likelihood.low, estimate.likelihood.high}}};
        }
        one["minus_two_log_likelihood"] = fit.likelihood.minus_two_log;
        one["n_fitted"] = fit.likelihood.n_fitted;
        one["aicc"] = fit.likelihood.aicc;
        one["aicc_above_least"] = fit.aicc_difference;
        one["likelihood_ratio"] = fit.likelihood_ratio;
        one["chance"] = fit.chance;
        one["is_excluded"] = fit.is_excluded;
        result[fit.name] = std::move(one);
    }
    return result;
}

}  // namespace tricontact::experiments

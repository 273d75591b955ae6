#include "app/run_text.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "comparisons/quantities/results.h"
#include "contact/verdict.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

// "55.9 um": a terminal may have no other letters.
std::string metres(double value) {
    const report::Unit unit = report::fitting_unit(value, "m");
    constexpr std::string_view micro = "µ";
    std::string symbol = unit.symbol;
    if (symbol.starts_with(micro)) symbol.replace(0, micro.size(), "u");
    return fmt::format("{:.3g} {}", value / unit.factor, symbol);
}

std::string line_of(const comparisons::Results& r) {
    using namespace comparisons::quantities;
    std::string line = r.model + ": ";
    const auto length = [&r](const comparisons::Quantity& q) {
        return metres(r.number(q).value_or(0));
    };
    if (const auto state = r.state())
        fmt::format_to(std::back_inserter(line), "{}{}, ", contact::name_of(*state),
                       r.verdict.by_limit ? " by the limit of uncoupled contact" : "");
    if (r.state() || r.number(final_shift) != 0.)
        fmt::format_to(std::back_inserter(line), "U = {} ({:.4g} U_max)", length(final_shift),
                       r.number(final_shift_ratio).value_or(0));
    else
        fmt::format_to(std::back_inserter(line), "d = {}, a = {}", length(indentation),
                       length(contact_radius));
    if (std::abs(r.verdict.remaining) > contact::known_shift &&
        std::isfinite(r.verdict.remaining_error))
        line += fmt::format(", {:.2g} +- {:.1g} U_max to come", r.verdict.remaining,
                            r.verdict.remaining_error);
    line += fmt::format("; {:.1f} s\n", r.number(wall_time).value_or(0));
    return r.verdict.missing.empty() ? line : line + "  undecided: " + r.verdict.missing + '\n';
}

}  // namespace

std::string run_text(const CaseRun& run) {
    std::string text;
    for (const contact::History& history : run.histories) text += line_of({run.c, history});
    return text;
}

}  // namespace tricontact::app

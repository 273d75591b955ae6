#include "app/run_text.h"

#include <fmt/format.h>

#include <iterator>

#include "comparisons/format.h"
#include "comparisons/summary.h"

namespace tricontact::app {

namespace {

// "55.9 um": a terminal may have no other letters.
std::string metres(double value) {
    const comparisons::Unit unit = comparisons::fitting_unit(value, "m");
    constexpr std::string_view micro = "µ";
    std::string symbol = unit.symbol;
    if (symbol.starts_with(micro)) symbol.replace(0, micro.size(), "u");
    return fmt::format("{:.3g} {}", value / unit.factor, symbol);
}

std::string line_of(const comparisons::ModelSummary& s) {
    std::string line = s.model + ": ";
    if (s.state) fmt::format_to(std::back_inserter(line), "{}, ", contact::name_of(*s.state));
    if (s.state || s.final_shift != 0)
        fmt::format_to(std::back_inserter(line), "U = {} ({:.4g} U_max)", metres(s.final_shift),
                       s.final_shift_ratio);
    else
        fmt::format_to(std::back_inserter(line), "d = {}, a = {}", metres(s.indentation),
                       metres(s.contact_radius));
    return line + fmt::format("; {:.1f} s\n", s.wall_s);
}

}  // namespace

std::string run_text(const CaseRun& run) {
    std::string text;
    for (const contact::History& history : run.histories)
        text += line_of(comparisons::summarise(run.c, history));
    return text;
}

}  // namespace tricontact::app

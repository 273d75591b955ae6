#include "experiments/identification/report/loop_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using json = nlohmann::ordered_json;
using statistics::Estimate;
using enum Verdict::Standing;

// Sentences about so many series; further ones stand in the table.
constexpr std::size_t most_told = 6;
constexpr double sure = .95;

std::string words_of(const std::string& regime) {
    return regime == "partial-slip" ? "partial slip"
           : regime == "gross-slip" ? "gross slip"
                                    : regime;
}

std::string range_text(const Estimate& e, const std::string& unit) {
    const auto shown = [&](double value) {
        return unit.empty() ? report::significant(value, 3) : report::quantity(value, unit, 3);
    };
    return fmt::format("{} ({} to {})", shown(e.value), shown(e.low), shown(e.high));
}

std::string cycles_text(double first, double last) {
    return first == last ? fmt::format("cycle {:.0f}", first)
                         : fmt::format("cycles {:.0f} to {:.0f}", first, last);
}

/// What separates the regime from the next one.
std::string reason_of(const LoopSeries& series) {
    if (series.regime == "stick")
        return fmt::format("its loops are closed, within {} of 4 F U",
                           report::share(closed_loop_ratio));
    if (series.regime == "mixed") return "some cycles slide as a whole, others do not";
    return series.regime == "gross-slip" ? "all of the contact slides in each cycle"
                                         : "part of the contact slips and its middle sticks";
}

Verdict regime_verdict(const LoopSeries& series) {
    const bool is_sure = series.confidence >= sure;
    return {is_sure ? finding : not_resolved,
            fmt::format("Regime ({}): {}{}, confidence {}; {}. Energy per cycle {}.",
                        loop_series_text(series), is_sure ? "" : "most likely ",
                        words_of(series.regime), report::share(std::max(0., series.confidence), 3),
                        reason_of(series), range_text(series.energy, "J"))};
}

std::vector<Verdict> drift_verdicts(const IdentifiedModel& model, const LoopFindings& findings) {
    const auto k = model.found.find(std::string(drift_key));
    if (!k) return {};
    const Interval at = full_interval(model, *k);
    const double value = model.found.parameters[*k].value;
    const std::string numbers =
        fmt::format("{:+.2g} % ({:+.2g} % to {:+.2g} %)", 100 * value, 100 * at.low, 100 * at.high);
    const double largest = model.found.free[*k].high;
    double first = findings.series.front().first_cycle, last = first;
    for (const LoopSeries& series : findings.series) {
        first = std::min(first, series.first_cycle);
        last = std::max(last, series.last_cycle);
    }
    const std::string over = cycles_text(first, last);
    if (at.high >= largest || at.low <= -largest)
        return {{not_resolved,
                 "Drift of friction is not identifiable: no cycle comes close to sliding."}};
    if (at.low > 0 || at.high < 0)
        return {{finding, fmt::format("Friction {} over {}: {} of its mean, linear in the cycle.",
                                      value > 0 ? "rises" : "falls", over, numbers)}};
    return {{holds, fmt::format("No linear drift of friction over {} is resolved: {} of its mean.",
                                over, numbers)}};
}

/// Where it is resolved.
std::optional<Verdict> stiffness_verdict(const LoopSeries& series) {
    const auto& drift = series.stiffness_drift;
    if (!drift || (drift->low <= 0 && drift->high >= 0)) return {};
    const double over = 100 * (series.last_cycle - series.first_cycle);
    return Verdict{finding, fmt::format("The initial stiffness drifts ({}): {:+.2g} % of its mean "
                                        "({:+.2g} % to {:+.2g} %). E or k_rig change, or the "
                                        "contact grows.",
                                        loop_series_text(series), over * drift->value,
                                        over * drift->low, over * drift->high)};
}

report::Cell open_cell(double value, double unit = 1) {
    return std::isfinite(value) ? report::Cell(value / unit) : report::Cell("open");
}

json estimate_of(const Estimate& e) {
    return {{"value", e.value},
            {"standard_error", e.standard_error},
            {"interval", json::array({e.low, e.high})}};
}

report::DocumentTable series_table(const LoopFindings& findings) {
    report::DocumentTable table{
        .id = "loop_series",
        .title = "Friction loops: regime and energy",
        .note = fmt::format(
            "A row per load and amplitude. Regimes after Vingsbo and Söderberg (1988): stick, the "
            "recorded loop is closed to {} of 4 F U without the rig's share; gross slip, all "
            "slides; mixed, some cycles slide as a whole. Energy ratio: energy over 4 F U (Fouvry, "
            "Kapsa and Vincent 1996), the largest. Drift of the shift: of where it counts from, "
            "with its interval; of the initial stiffness, contact and rig in series: over its "
            "mean.",
            report::share(closed_loop_ratio)),
        .columns =
            report::columns("cycles", "F_N [N]", "amplitude [um]:3", "regime", "confidence:3",
                            "energy per cycle [uJ]:4", "low:4", "high:4", "energy ratio:3",
                            "drift of the shift [um/cycle]:2", "from:2", "to:2",
                            "drift of the initial stiffness [%/cycle]:2", "from:2", "to:2")};
    for (const LoopSeries& s : findings.series) {
        const auto drift = s.shift_drift, stiffer = s.stiffness_drift;
        const auto cell = [](const std::optional<Estimate>& of, double Estimate::*end,
                             double unit) {
            return of ? report::Cell((*of).*end * unit) : report::Cell("–");
        };
        table.rows.push_back(
            {cycles_text(s.first_cycle, s.last_cycle), s.normal_force, s.shift * 1e6,
             words_of(s.regime), s.confidence, s.energy.value * 1e6, s.energy.low * 1e6,
             s.energy.high * 1e6, s.largest_ratio, cell(drift, &Estimate::value, 1e6),
             cell(drift, &Estimate::low, 1e6), cell(drift, &Estimate::high, 1e6),
             cell(stiffer, &Estimate::value, 100), cell(stiffer, &Estimate::low, 100),
             cell(stiffer, &Estimate::high, 100)});
    }
    return table;
}

report::DocumentTable block_table(const LoopFindings& findings) {
    report::DocumentTable table{
        .id = "loop_blocks",
        .title = "Friction over the cycles",
        .note =
            "Force at which all slides over the normal force, of consecutive cycles, with E "
            "and k_rig as all loops have them and their errors in the interval. In partial "
            "slip it follows from the curvature of the loops.",
        .columns = report::columns("cycles", "F_N [N]", "amplitude [um]:3", "loops", "F_lim/F_N:4",
                                   "low:4", "high:4")};
    for (const LoopSeries& s : findings.series)
        for (const CycleBlock& block : s.blocks)
            table.rows.push_back({cycles_text(block.first, block.last), s.normal_force,
                                  s.shift * 1e6, static_cast<int>(block.n), block.friction.value,
                                  open_cell(block.friction.low), open_cell(block.friction.high)});
    return table;
}

}  // namespace

std::string loop_series_text(const LoopSeries& series) {
    return fmt::format(
        "{}, F_N = {}, amplitude {}", cycles_text(series.first_cycle, series.last_cycle),
        report::quantity(series.normal_force, "N", 3), report::quantity(series.shift, "m", 3));
}

std::vector<Verdict> loop_verdicts(const IdentificationStudy& study) {
    if (!study.loops) return {};
    const LoopFindings& findings = *study.loops;
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < std::min(most_told, findings.series.size()); ++i)
        verdicts.push_back(regime_verdict(findings.series[i]));
    if (findings.series.size() > most_told)
        verdicts.push_back({finding, fmt::format("Regimes of {} further series stand in the table.",
                                                 findings.series.size() - most_told)});
    std::ranges::move(drift_verdicts(reference_model(study), findings),
                      std::back_inserter(verdicts));
    for (std::size_t i = 0; i < std::min(most_told, findings.series.size()); ++i)
        if (auto verdict = stiffness_verdict(findings.series[i]))
            verdicts.push_back(std::move(*verdict));
    return verdicts;
}

std::vector<report::DocumentTable> loop_tables(const IdentificationStudy& study) {
    if (!study.loops) return {};
    return {series_table(*study.loops), block_table(*study.loops)};
}

report::Figure loop_figure(const IdentificationStudy& study, std::size_t t) {
    const auto& table = study.input.tables[t];
    const TableFit& fit = reference_model(study).found.tables[t];
    const auto largest = [](const std::vector<double>& values) {
        const auto [least, most] = std::ranges::minmax(values);
        return std::max(std::abs(least), std::abs(most));
    };
    const report::Unit shift = report::fitting_unit(largest(table.given), "m"),
                       force = report::fitting_unit(largest(table.observed), "N");
    report::Figure figure{
        .id = study.input.tables.size() == 1 ? "loops" : fmt::format("loops_{}", t + 1),
        .title = "Friction loops" + (table.label.empty() ? "" : ": " + table.label),
        .caption =
            "Tangential force over the shift of the drive: measured, and first and last "
            "cycle of each load and amplitude as fitted, with the rig's spring in series.",
        .x = {fmt::format("shift U [{}]", shift.symbol)},
        .y = {fmt::format("tangential force F_T [{}]", force.symbol)}};
    const auto& loops = table.loops.loops;
    const auto part = [](const std::vector<double>& values, const MeasuredLoop& loop, double unit) {
        std::vector<double> closed;
        for (std::size_t i = 0; i <= loop.n; ++i)
            closed.push_back(values[loop.first + i % loop.n] / unit);
        return closed;
    };
    report::Curve measured{.name = "measured", .kind = report::Curve::Kind::points};
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const bool is_first = i == 0 || loops[i - 1].series != loops[i].series;
        const bool is_last = i + 1 == loops.size() || loops[i + 1].series != loops[i].series;
        if (!is_first && !is_last) continue;
        const auto x = part(table.given, loops[i], shift.factor),
                   y = part(table.observed, loops[i], force.factor);
        measured.x.insert(measured.x.end(), x.begin(), x.end());
        measured.y.insert(measured.y.end(), y.begin(), y.end());
        const double load = load_of(loops[i], study.input.rig);
        figure.curves.push_back({.name = fmt::format("cycle {:.0f}, {}", loops[i].cycle,
                                                     report::quantity(load, "N", 3)),
                                 .x = x,
                                 .y = part(fit.fitted, loops[i], force.factor)});
    }
    figure.curves.push_back(std::move(measured));
    return figure;
}

report::Figure loop_friction_figure(const IdentificationStudy& study) {
    report::Figure figure{.id = "loop_friction",
                          .title = "Friction over the cycles",
                          .caption =
                              "F_lim/F_N of each cycle with its interval; cycles that do "
                              "not determine it are left out.",
                          .x = {"cycle"},
                          .y = {"F_lim/F_N"}};
    const auto& findings = *study.loops;
    for (std::size_t s = 0; s < findings.series.size(); ++s) {
        report::Curve curve{
            .name = fmt::format("{}, {}", report::quantity(findings.series[s].normal_force, "N", 3),
                                report::quantity(findings.series[s].shift, "m", 3)),
            .kind = report::Curve::Kind::points};
        for (const LoopFinding& loop : findings.loops) {
            const bool is_told = loop.friction.standard_error < loop.friction.value;
            if (loop.series != s || !is_told) continue;
            curve.x.push_back(loop.cycle);
            curve.y.push_back(loop.friction.value);
            curve.y_error.push_back(loop.friction.half_width());
        }
        if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
    }
    return figure;
}

json loop_json(const LoopFindings& findings) {
    json result;
    for (const LoopSeries& s : findings.series) {
        json blocks = json::array();
        for (const CycleBlock& block : s.blocks)
            blocks.push_back({{"first_cycle", block.first},
                              {"last_cycle", block.last},
                              {"loops", block.n},
                              {"friction", estimate_of(block.friction)}});
        json one{{"table", s.table + 1},
                 {comparisons::quantities::normal_force.key, s.normal_force},
                 {"shift_amplitude_m", s.shift},
                 {"loops", s.n_loops},
                 {"first_cycle", s.first_cycle},
                 {"last_cycle", s.last_cycle},
                 {"regime", s.regime},
                 {"confidence", s.confidence},
                 {"energy_J", estimate_of(s.energy)},
                 {"energy_ratio", s.largest_ratio},
                 {"friction_over_cycles", std::move(blocks)}};
        if (s.shift_drift) one["shift_drift_m_per_cycle"] = estimate_of(*s.shift_drift);
        if (s.stiffness_drift)
            one["initial_stiffness_drift_per_cycle"] = estimate_of(*s.stiffness_drift);
        if (s.force_drift) one["force_drift_N_per_cycle"] = estimate_of(*s.force_drift);
        result["series"].push_back(std::move(one));
    }
    for (const LoopFinding& loop : findings.loops)
        result["loops"].push_back(
            {{"table", loop.table + 1},
             {"series", loop.series + 1},
             {"cycle", loop.cycle},
             {comparisons::quantities::normal_force.key, loop.normal_force},
             {"shift_amplitude_m", loop.state.amplitude},
             {"contact_shift_amplitude_m", loop.contact_shift},
             {"sliding_shift_m", loop.sliding_shift},
             {"force_amplitude_N", loop.force},
             {"shift_offset_m", loop.state.centre},
             {"force_offset_N", loop.state.force_offset},
             {"energy_J", estimate_of(loop.energy)},
             {"energy_ratio", loop.energy_ratio},
             {"friction", estimate_of(loop.friction)},
             {"initial_stiffness_N_per_m", loop.stiffness ? estimate_of(*loop.stiffness) : json()},
             {"regime", name_of(loop.regime())},
             {"probability_of_stick", loop.sticks},
             {"probability_of_gross_slip", loop.slides}});
    return result;
}

std::string loops_csv(const IdentificationStudy& study) {
    std::string text =
        "table,series,cycle,normal_force [N],shift_amplitude [m],contact_shift_amplitude [m],"
        "force_amplitude [N],shift_offset [m],force_offset [N],energy [J],energy_low [J],"
        "energy_high [J],energy_ratio,friction,friction_low,friction_high,regime,"
        "probability_of_stick,probability_of_gross_slip\n";
    for (const LoopFinding& l : study.loops->loops)
        text += fmt::format(
            "{},{},{:.0f},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},"
            "{:.9g},{:.9g},{:.9g},{},{:.6g},{:.6g}\n",
            l.table + 1, l.series + 1, l.cycle, l.normal_force, l.state.amplitude, l.contact_shift,
            l.force, l.state.centre, l.state.force_offset, l.energy.value, l.energy.low,
            l.energy.high, l.energy_ratio, l.friction.value, l.friction.low, l.friction.high,
            name_of(l.regime()), l.sticks, l.slides);
    return text;
}

}  // namespace tricontact::experiments

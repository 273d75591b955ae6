#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/change_table.h"
#include "comparisons/run/loading_reading.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/relaxing_case.h"
#include "contact/verdict.h"
#include "io/case/case_input.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::Relaxation;
using contact::State;

std::string times_text(const Relaxation& relaxation) {
    const auto& branches = relaxation.branches;
    if (branches.size() == 1)
        return fmt::format("one term of {}", report::quantity(branches.front().time, "s", 3));
    const auto [fast, slow] = std::ranges::minmax(branches, {}, &Relaxation::Branch::time);
    return fmt::format("{} terms of {} to {}", branches.size(), report::quantity(fast.time, "s", 3),
                       report::quantity(slow.time, "s", 3));
}

std::string substrate_sentence(const Case& c) {
    const double relaxed = contact::relaxing_material(c).shear_modulus();
    return fmt::format("The shear modulus of the {} relaxes from {} to {}, by {}.",
                       contact::substrate_relaxes(c) ? "substrate" : "indenter",
                       report::quantity(relaxed * c.relaxation->instantaneous_ratio(), "Pa"),
                       report::quantity(relaxed, "Pa"), times_text(*c.relaxation));
}

std::string drive_sentence(const Case& c, const DriveValues& drive) {
    const auto [least, largest] = std::ranges::minmax(drive.deborah);
    const std::string deborah =
        drive.deborah.size() == 1
            ? fmt::format("The Deborah number 2πfτ is {}.", report::significant(least, 3))
            : fmt::format("Deborah numbers 2πfτ are {} to {}.", report::significant(least, 3),
                          report::significant(largest, 3));
    return fmt::format(
        "At {} the rolling repeats itself with {} Hz: there G′ = {}, G″ = {}, loss tangent {}. {}",
        report::given_quantity(c.rolling->speed, "m/s"), report::significant(drive.frequency, 3),
        report::quantity(drive.storage, "Pa"), report::quantity(drive.loss, "Pa"),
        report::significant(drive.loss_tangent(), 3), deborah);
}

/// Before rolling: what F_T, which comes at once, and the wait leave.
std::string static_sentence(const Case& c, const RelaxationStudy& study) {
    std::vector<std::string> errors;
    for (const TwinComparison& twin : study.twins)
        if (const auto error = twin.static_error())
            errors.push_back(fmt::format("{} ({})", report::percent(*error + 1),
                                         report::display_name(twin.model)));
    if (errors.empty()) return {};
    return fmt::format(
        "The static shift depends on the hold time under F_T (load.hold = {}), not on the drive: "
        "there the elastic {} errs by {}.",
        report::given_quantity(c.load.hold, "s"), contact::relaxing_word(c),
        fmt::join(errors, ", "));
}

std::string limit_sentence(const SpeedLimit& limit, const Case& c) {
    const std::string name = report::display_name(limit.model);
    const char* what =
        limit.of_increment ? "the increment per period" : "the shift after the last period";
    if (!limit.speed)
        return fmt::format(
            "No drive speed was found ({} runs by {}) at which taking the substrate as elastic "
            "begins to err by {:g} % in {}: {}.",
            limit.runs, name, 100 * SpeedLimit::limit, what, limit.why_none);
    const double ratio = c.rolling->speed / *limit.speed;
    return fmt::format(
        "Up to a drive of {} ({} Hz) the substrate may be taken as elastic, to {:g} % of {}; this "
        "case is {} times {} ({}, speed found to {:g} % in {} runs).",
        report::quantity(*limit.speed, "m/s", 3), report::significant(limit.frequency, 3),
        100 * SpeedLimit::limit, what, report::significant(std::max(ratio, 1 / ratio), 3),
        ratio > 1 ? "faster" : "slower", name, 100 * SpeedLimit::resolution, limit.runs);
}

}  // namespace

std::string twin_sentence(const TwinComparison& twin) {
    const std::string name = report::display_name(twin.model);
    if (!twin.other) return fmt::format("{}: no elastic reference run: {}.", name, twin.why_none);
    if (!twin.other->state || !twin.final_error()) return {};
    if (const auto error = twin.increment_error())
        return fmt::format("{}: taken as elastic, it would ratchet by {} per period.", name,
                           instead(twin.other->increment, twin.run.increment, error));
    const State state = *twin.run.state, elastic = *twin.other->state;
    const bool decided = state != State::undecided && elastic != State::undecided;
    if (decided && contact::settles(state) != contact::settles(elastic))
        return fmt::format(
            "{}: taken as elastic, it would {}, but it {}: f_T,lim = {} instead of {}.", name,
            contact::settles(elastic) ? "settle" : "ratchet",
            contact::settles(state) ? "settles" : "ratchets",
            report::significant(twin.other->limit), report::significant(twin.run.limit));
    const bool settled = twin.settled_error().has_value();
    std::string text = fmt::format(
        "{}: taken as elastic, the {} would be {}; {}.", name,
        settled ? "settled shift" : "shift after the last period",
        instead(twin.other->final_shift, twin.run.final_shift, twin.final_error()),
        state == elastic ? fmt::format("both: {}", contact::name_of(state))
                         : fmt::format("relaxing: {}, elastic: {}", contact::name_of(state),
                                       contact::name_of(elastic)));
    if (!settled)
        text += " Whether settled shifts differ as much, this does not resolve: run more periods.";
    return text;
}

std::vector<std::string> relaxation_sentences(const Case& c, const RelaxationStudy& study) {
    std::vector<std::string> result{substrate_sentence(c)};
    if (!study.twins.empty() && study.twins.front().drive)
        result.push_back(drive_sentence(c, *study.twins.front().drive));
    if (study.limit) result.push_back(limit_sentence(*study.limit, c));
    for (const TwinComparison& twin : study.twins) result.push_back(twin_sentence(twin));
    result.push_back(static_sentence(c, study));
    const io::RelaxationFits& fits = io::relaxation_fits(c);
    if (fits.dma)
        for (const std::string& remark :
             contact::remarks(*fits.dma, contact::relaxing_material(c).shear_modulus()))
            result.push_back(remark + ".");
    if (fits.test)
        for (const std::string& remark :
             contact::remarks(*fits.test, fits.test->table.is_young
                                              ? contact::relaxing_material(c).young
                                              : contact::relaxing_material(c).shear_modulus()))
            result.push_back(remark + ".");
    std::erase(result, std::string());
    return result;
}

report::DocumentTable relaxation_table(const Case& c, const RelaxationStudy& study) {
    report::DocumentTable table{
        .id = "relaxation",
        .title = std::string("Relaxing ") + contact::relaxing_word(c),
        .note = fmt::format(
            "The elastic {0} has the relaxed modulus: what an infinitely slow drive "
            "finds, with the same a, d and U_max. Its error is its shift over that of the "
            "relaxing one, minus 1; settled shifts are compared where both shake down, "
            "increments where both ratchet. Scales, closed forms and κ, η of this report know "
            "the relaxed {0} only.",
            contact::relaxing_word(c)),
        .columns = quantity_columns()};
    const auto row = [&](const std::string& label, const std::string& unit, const auto& cell) {
        std::vector<report::Cell> cells{label, unit};
        for (const TwinComparison& twin : study.twins) cells.emplace_back(cell(twin));
        table.rows.push_back(cells);
    };
    const auto error = [&](const std::string& of,
                           std::optional<double> (TwinComparison::*get)() const) {
        row(fmt::format("error of the elastic {}: {}", contact::relaxing_word(c), of), "%",
            [get](const TwinComparison& twin) { return 100 * (twin.*get)().value_or(NAN); });
    };
    for (const TwinComparison& twin : study.twins)
        table.columns.push_back({report::display_name(twin.model)});

    if (!study.twins.empty() && study.twins.front().drive) {
        const DriveValues& d = *study.twins.front().drive;
        const auto drive = [&](const std::string& label, const report::Unit& unit,
                               const auto& get) {
            row("drive: " + label, unit.symbol,
                [&](const TwinComparison& twin) { return get(*twin.drive) / unit.factor; });
        };
        const report::Unit modulus = report::fitting_unit(d.storage, "Pa");
        drive("amplitude W", report::fitting_unit(d.amplitude, "m"),
              [](auto& v) { return v.amplitude; });
        drive("frequency f = v/(4 W)", {1, "Hz"}, [](auto& v) { return v.frequency; });
        drive("storage modulus G′", modulus, [](auto& v) { return v.storage; });
        drive("loss modulus G″", modulus, [](auto& v) { return v.loss; });
        drive("loss tangent", {}, [](auto& v) { return v.loss_tangent(); });
        for (std::size_t i = 0; i < d.deborah.size(); ++i)
            drive("Deborah number 2πfτ, τ = " +
                      report::quantity(c.relaxation->branches[i].time, "s", 3),
                  {}, [i](auto& v) { return v.deborah[i]; });
    }
    error("static shift", &TwinComparison::static_error);
    if (!c.rolling) return table;
    error("shift after the last period", &TwinComparison::final_error);
    error("settled shift", &TwinComparison::settled_error);
    error("ratcheting increment", &TwinComparison::increment_error);
    error("limit f_T,lim", &TwinComparison::limit_error);
    const auto name = [](const RunValues& run) -> std::string {
        return run.state ? contact::name_of(*run.state) : "–";
    };
    row("verdict", "", [&](const TwinComparison& twin) { return name(twin.run); });
    row("verdict of the elastic one", "",
        [&](const TwinComparison& twin) { return name(twin.other.value_or(RunValues{})); });
    return table;
}

}  // namespace tricontact::comparisons

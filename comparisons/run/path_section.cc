#include "comparisons/run/path_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "comparisons/quantities/quantities.h"
#include "contact/path_cycles.h"
#include "contact/rig_stiffness.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::History;
using contact::StepRecord;
using contact::steps_at_rows;

constexpr std::size_t most_path_points = 3000;  // of a line: more than the picture has pixels
constexpr double negligible = 1e-7;             // of the largest value: the solvers' tolerance
constexpr std::size_t most_rows = 200, most_open_rows = 12;

/// What a path prescribes or a model answers, of one step.
struct Magnitude {
    std::string id, name, base;  ///< of its figure; "shift U_x", "m"
    std::function<double(const StepRecord&)> of;

    double largest(const Histories& histories) const {
        double largest = 0;
        for (const History& history : histories)
            for (const StepRecord& step : history.steps)
                largest = std::max(largest, std::abs(of(step)));
        return largest;
    }
};

const Magnitude shift_x{"path_x", "shift U_x", "m", [](const StepRecord& s) { return s.shift[0]; }};
const Magnitude shift_y{"path_y", "shift U_y", "m", [](const StepRecord& s) { return s.shift[1]; }};
const Magnitude force_x{"path_x", "force F_x", "N",
                        [](const StepRecord& s) { return s.tangential_force[0]; }};
const Magnitude force_y{"path_y", "force F_y", "N",
                        [](const StepRecord& s) { return s.tangential_force[1]; }};
const Magnitude normal_force{"path_normal", "normal force F_N", "N",
                             [](const StepRecord& s) { return s.normal_force; }};
const Magnitude indentation{"path_normal", "indentation d", "m",
                            [](const StepRecord& s) { return s.indentation; }};
const Magnitude torque{"path_torque", "torque M", "N m",
                       [](const StepRecord& s) { return s.torque; }};
const Magnitude rotation{"path_rotation", "rotation", "rad",
                         [](const StepRecord& s) { return s.rotation; }};

/// What the models answer: of each pair of force and motion the one that is not prescribed.
std::vector<const Magnitude*> answers(const contact::PrescribedPath& path) {
    using contact::NormalControl, contact::TangentialControl;
    const auto& row = path.rows.front();
    std::vector<const Magnitude*> list;
    list.push_back(row.tangential[0].kind == TangentialControl::Kind::force ? &shift_x : &force_x);
    if (!path.is_along_x())
        list.push_back(row.tangential[1].kind == TangentialControl::Kind::force ? &shift_y
                                                                                : &force_y);
    list.push_back(row.normal.kind == NormalControl::Kind::force ? &indentation : &normal_force);
    if (path.twists()) list.push_back(&torque);
    return list;
}

report::DocumentTable row_table(const contact::Case& c, const Histories& histories) {
    const contact::PrescribedPath& path = *c.prescribed_path;
    report::DocumentTable table{
        .id = "path",
        .title = "At the rows of the path",
        .note =
            "Rows count from 0. Without a value: that row is the indenter out of contact. W: "
            "frictional work since the first row.",
        .columns = {{"row"}},
        .folded = path.rows.size() > most_open_rows};
    if (path.twists())
        table.note += " Twist, shifts and torque: " + centre_of_rotation_text(c) + ".";
    const auto shown = report::thinned(path.rows.size(), most_rows);
    for (const std::size_t r : shown) table.rows.push_back({static_cast<int>(r)});
    const auto add = [&](const History& history, const std::string& name, const report::Unit& unit,
                         const auto& value_of) {
        table.columns.push_back(
            {fmt::format("{} {} [{}]", report::display_name(history.model), name, unit.symbol)});
        const auto rows = steps_at_rows(history);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const StepRecord* step = shown[i] < rows.size() ? rows[shown[i]] : nullptr;
            table.rows[i].push_back(report::number_cell(
                step ? std::optional(value_of(step)) : std::nullopt, unit.factor));
        }
    };
    for (const Magnitude* magnitude : answers(path)) {
        const double largest = magnitude->largest(histories);
        const report::Unit unit = report::fitting_unit(largest, magnitude->base);
        for (const History& history : histories)
            add(history, magnitude->name.substr(magnitude->name.rfind(' ') + 1), unit,
                [&](const StepRecord* step) {
                    const double value = magnitude->of(*step);
                    return std::abs(value) <= negligible * largest ? 0 : value;
                });
    }
    for (const History& history : histories) {
        std::vector<double> work{0};
        for (const StepRecord& step : history.steps) work.push_back(work.back() + step.dissipation);
        const auto first = steps_at_rows(history).front();
        const double pressed = first ? work[first - history.steps.data() + 1] : 0;
        add(history, "W", report::fitting_unit(work.back() - pressed, "J"),
            [&](const StepRecord* step) {
                return work[step - history.steps.data() + 1] - pressed;
            });
    }
    return table;
}

/// Regime and what it takes, cycle by cycle; no rows without closed cycles.
report::DocumentTable cycle_table(const contact::Case& c, const Histories& histories) {
    report::DocumentTable table{
        .id = "cycles",
        .title = "Closed cycles",
        .note = "F_T, shift U: half of what each covers. W: frictional work of the cycle.",
        .columns = {{"cycle"}}};
    std::vector<std::vector<FrictionLoop>> loops;
    std::size_t n = 0;
    for (const History& history : histories) {
        loops.push_back(friction_loops(c, history));
        n = std::max(n, loops.back().size());
    }
    table.folded = n > most_open_rows;
    const auto shown = report::thinned(n, most_rows);
    for (const std::size_t k : shown) table.rows.push_back({static_cast<int>(k) + 1});
    for (std::size_t m = 0; m < histories.size(); ++m) {
        const auto& work = histories[m].dissipation_per_period;
        const std::string name = report::display_name(histories[m].model);
        const auto add = [&](const std::string& symbol, const std::string& base,
                             const auto& value_of) {
            double largest = 0;
            for (std::size_t k = 0; k < loops[m].size(); ++k)
                largest = std::max(largest, value_of(k));
            const report::Unit unit = report::fitting_unit(largest, base);
            table.columns.push_back({fmt::format("{} {} [{}]", name, symbol, unit.symbol)});
            for (std::size_t i = 0; i < shown.size(); ++i)
                table.rows[i].push_back(report::number_cell(
                    shown[i] < loops[m].size() ? std::optional(value_of(shown[i])) : std::nullopt,
                    unit.factor));
        };
        table.columns.push_back({name + " regime"});
        for (std::size_t i = 0; i < shown.size(); ++i)
            table.rows[i].push_back(shown[i] < loops[m].size() ? name_of(loops[m][shown[i]].regime)
                                                               : "");
        add("F_T", "N", [&](std::size_t k) { return loops[m][k].force_amplitude; });
        add("U", "m", [&](std::size_t k) { return loops[m][k].shift_amplitude; });
        add("W", "J", [&](std::size_t k) { return k < work.size() ? work[k] : 0; });
    }
    return table;
}

/// One magnitude over another, or over the rows of the path, of all models.
report::Figure figure_of(const std::string& id, const std::string& title, const Magnitude& y,
                         const Magnitude* x, const Histories& histories) {
    const report::Unit y_unit = report::fitting_unit(y.largest(histories), y.base);
    const report::Unit x_unit =
        x ? report::fitting_unit(x->largest(histories), x->base) : report::Unit{};
    report::Figure figure{
        .id = id,
        .title = title,
        .x = {x ? fmt::format("{} [{}]", x->name, x_unit.symbol) : "row of the path"},
        .y = {fmt::format("{} [{}]", y.name, y_unit.symbol)}};
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const auto& steps = histories[i].steps;
        report::Curve curve = curve_of(histories[i]);
        for (const std::size_t k : report::thinned(steps.size(), most_path_points))
            curve.add((x ? x->of(steps[k]) : steps[k].phase) / x_unit.factor,
                      y.of(steps[k]) / y_unit.factor);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

const char* words_of(SlipRegime regime) {
    switch (regime) {
        case SlipRegime::stick:
            return "nothing slips";
        case SlipRegime::partial_slip:
            return "part of the contact slips";
        default:
            return "the whole contact slips";
    }
}

}  // namespace

std::string loop_words(const Results& s) {
    using namespace quantities;
    const auto* const regime = std::get_if<SlipRegime>(&s[slip_regime]);
    if (!regime) return "In the last closed cycle the path returns; friction works ";
    const auto told = [&](const Quantity& q) { return report::quantity(*s.number(q), q.unit); };
    std::string words =
        fmt::format("In the last closed cycle {}: F_T of {} and a shift of {} to either side",
                    words_of(*regime), told(loop_force), told(loop_shift));
    if (s.number(drive_shift)) words += fmt::format(", of the drive {}", told(drive_shift));
    if (s.number(gross_slip_shift))
        words += fmt::format(", gross slip from {} behind a reversal on", told(gross_slip_shift));
    if (const auto change = s.number(regime_changes_at))
        words += fmt::format("; the regime changes at closed cycle {:.0f}", *change);
    return words + "; friction works ";
}

std::string centre_of_rotation_text(const contact::Case& c) {
    const contact::CentreOfRotation& centre = c.prescribed_path->centre;
    const auto place = [](const contact::Vector2& at) {
        return fmt::format("({:.6g}, {:.6g}) mm", 1e3 * at[0] + 0., 1e3 * at[1] + 0.);
    };
    if (centre.frame == contact::CentreOfRotation::Frame::substrate)
        return "about the point " + place(centre.place) + ", at rest on the substrate";
    const contact::Vector2 lowest = c.make_indenter()->lowest_point();
    std::string text = "about the indenter's lowest point";
    if (centre.place != contact::Vector2{})
        text = "about the point " + place(centre.place) + " from the indenter's lowest point";
    if (c.indenter.shape == contact::Case::Shape::height_map)
        text += ", which lies " + place(lowest) + " from the map's middle node";
    return text + ", and moving with it";
}

report::DocumentSection path_section(const contact::Case& c, const Histories& histories) {
    if (!c.prescribed_path) return {};
    const contact::PrescribedPath& path = *c.prescribed_path;
    report::DocumentSection section{
        .id = "path", .heading = "Along the path", .tables = {row_table(c, histories)}};
    if (auto cycles = cycle_table(c, histories); !cycles.rows.empty())
        section.tables.push_back(std::move(cycles));
    const auto add = [&](const std::string& id, const std::string& title, const Magnitude& y,
                         const Magnitude* x) {
        // What stays zero has no picture.
        if (y.largest(histories) == 0 || (x && x->largest(histories) == 0)) return;
        section.figures.push_back(figure_of(id, title, y, x, histories));
    };
    for (const Magnitude* magnitude : answers(path))
        add(magnitude->id, report::capitalised(magnitude->name) + " along the path", *magnitude,
            nullptr);
    add("path_loop", "Force F_x over shift U_x", force_x, &shift_x);
    const contact::RigStiffness& rig = c.of<contact::RigStiffness>();
    if (rig.tangential) {
        const Magnitude drive{"path_x", "shift of the drive U_x", "m",
                              [&rig](const StepRecord& s) { return rig.drive_shift(s)[0]; }};
        add("path_loop_drive", "Force F_x over the shift of the drive", force_x, &drive);
    }
    if (!path.is_along_x()) add("path_loop_y", "Force F_y over shift U_y", force_y, &shift_y);
    if (path.twists()) add("path_twist", "Torque over rotation", torque, &rotation);
    return section;
}

}  // namespace tricontact::comparisons

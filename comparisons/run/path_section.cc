#include "comparisons/run/path_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "contact/path_cycles.h"
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

}  // namespace

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
    if (!path.is_along_x()) add("path_loop_y", "Force F_y over shift U_y", force_y, &shift_y);
    if (path.twists()) add("path_twist", "Torque over rotation", torque, &rotation);
    return section;
}

}  // namespace tricontact::comparisons

#include "benchmarks/report/comparison_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "benchmarks/report/comparison_words.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

using report::Curve;

constexpr double box_height = .34;  // half, of a row
constexpr int difference_colour = 0, explained_colour = 1, left_colour = 2;

/// Boxes of one meaning: outlines that share an entry of the legend, and their ground.
class Boxes {
  public:
    Boxes(report::Figure& figure, const char* name, int colour)
        : figure_(figure), outline_{.name = name, .colour = colour} {}
    void add(double row, double from, double to) {
        const double low = row - box_height, high = row + box_height;
        figure_.bands.push_back({.name = outline_.name,
                                 .x = {std::min(from, to), std::max(from, to)},
                                 .low = {low, low},
                                 .high = {high, high},
                                 .colour = outline_.colour});
        for (const auto& [x, y] : {std::pair{from, low},
                                   {to, low},
                                   {to, high},
                                   {from, high},
                                   {from, low},
                                   {double(NAN), double(NAN)}})
            outline_.add(x, y);
    }
    void finish() {
        if (!outline_.x.empty()) figure_.curves.push_back(outline_);
    }

  private:
    report::Figure& figure_;
    Curve outline_;
};

/// Points with the half widths of their intervals along x.
Curve bars_of(const char* name, int colour) {
    return {.name = name, .kind = Curve::Kind::points, .colour = colour};
}

void add_bar(Curve& curve, double x, double row, double half_width) {
    curve.add(x, row);
    curve.x_error.push_back(half_width);
}

/// Slope that an expected order begins with: "1 (...)", "4/3 to 3/2".
std::optional<double> slope_of(const std::string& expected) {
    const char *at = expected.data(), *const end = at + expected.size();
    double slope = 0, over = 1;
    const auto read = std::from_chars(at, end, slope);
    if (read.ec != std::errc{} || !(slope > 0)) return {};
    if (read.ptr != end && *read.ptr == '/') {
        const auto rest = std::from_chars(read.ptr + 1, end, over);
        if (rest.ec != std::errc{} || !(over > 0)) return {};
    }
    return slope / over;
}

std::string slope_name(double slope) {
    return "order " + report::as_given(std::round(1000 * slope) / 1000);
}

/// A grey line for each expected order, through the finest error that has it.
void add_slopes(const Comparison& comparison, bool norms, report::Figure& figure) {
    std::map<double, Curve> slopes;
    const double coarse = comparison.meshes.front().size, fine = comparison.meshes.back().size;
    for (const ComparedNumber& one : comparison.numbers) {
        const auto slope = slope_of(one.expected_order);
        const auto error = difference_of(one, comparison.meshes.size() - 1);
        if (one.is_norm != norms || !slope || !error || *error == 0) continue;
        const double at_fine = 100 * std::abs(*error);
        slopes.try_emplace(*slope, Curve{.name = slope_name(*slope),
                                         .x = {1e3 * coarse, 1e3 * fine},
                                         .y = {at_fine * std::pow(coarse / fine, *slope), at_fine},
                                         .theory = true});
    }
    for (auto& [slope, curve] : slopes) figure.curves.push_back(std::move(curve));
}

}  // namespace

report::Figure budget_figure(const ComparedNumber& number) {
    const double n = static_cast<double>(number.explained.size()) + 2;
    const double tolerance = 100 * number.tolerance;
    report::Figure figure{
        .id = "budget_" + number.key,
        .title = "Budget of the difference: " + number.title,
        .caption = fmt::format(
            "From the difference of the code the predicted effects are taken one after another; "
            "what is left, with U as its bar, is compared with the tolerance of {} (grey).",
            report::share(number.tolerance)),
        .x = {"difference [%]"},
        .y = {.low = n - .5, .high = -.5}};
    figure.bands.push_back({.name = "tolerance",
                            .x = {-tolerance, tolerance},
                            .low = {-.5, -.5},
                            .high = {n - .5, n - .5}});
    Boxes difference(figure, "difference", difference_colour);
    Boxes explained(figure, "explained", explained_colour);
    Boxes left(figure, "left", left_colour);
    Curve bars = bars_of("explained", explained_colour), of_left = bars_of("left", left_colour);
    Curve steps{.theory = true};
    figure.y.names.emplace_back("difference");
    double at = 100 * number.difference, row = 0;
    difference.add(row, 0, at);
    for (const Explained& one : number.explained) {
        figure.y.names.push_back("− " + one.title);
        const double next = at - 100 * one.change;
        for (const double y : {row - box_height, row + 1 + box_height}) steps.add(at, y);
        steps.add(NAN, NAN);
        explained.add(++row, at, next);
        add_bar(bars, next, row, 100 * one.bar);
        at = next;
    }
    for (const double y : {row - box_height, row + 1 + box_height}) steps.add(at, y);
    figure.y.names.emplace_back("left");
    left.add(++row, 0, at);
    add_bar(of_left, at, row, 100 * number.uncertainty);
    for (Boxes* boxes : {&difference, &explained, &left}) boxes->finish();
    for (Curve* curve : {&bars, &of_left, &steps})
        if (!curve->x.empty()) figure.curves.push_back(*curve);
    return figure;
}

report::Figure left_figure(const Comparison& comparison) {
    const double n = static_cast<double>(comparison.numbers.size());
    report::Figure figure{
        .id = "left",
        .title = "What is left of each difference",
        .caption =
            "After what is explained, with U as its bar, over the tolerance of each number "
            "(grey: -1 to 1).",
        .x = {"left over tolerance [-]"},
        .y = {.low = n - .5, .high = -.5}};
    figure.bands.push_back(
        {.name = "tolerance", .x = {-1, 1}, .low = {-.5, -.5}, .high = {n - .5, n - .5}});
    for (const Standing standing : {Standing::pass, Standing::fail, Standing::not_resolved}) {
        Curve curve = bars_of(report::word_of(standing_of(standing)), static_cast<int>(standing));
        for (std::size_t i = 0; i < comparison.numbers.size(); ++i) {
            const ComparedNumber& one = comparison.numbers[i];
            if (one.standing != standing || !(one.tolerance > 0)) continue;
            add_bar(curve, one.left() / one.tolerance, static_cast<double>(i),
                    one.uncertainty / one.tolerance);
        }
        if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
    }
    for (const ComparedNumber& one : comparison.numbers) figure.y.names.push_back(one.title);
    return figure;
}

std::vector<report::Figure> error_figures(const Comparison& comparison) {
    std::vector<report::Figure> figures;
    const auto is_sized = [](const MeshResult& mesh) { return mesh.size > 0; };
    if (comparison.meshes.size() < 2 || !std::ranges::all_of(comparison.meshes, is_sized))
        return {};
    for (const bool norms : {false, true}) {
        report::Figure figure{
            .id = norms ? "errors_of_norms" : "errors",
            .title =
                norms ? "Norms over the size of elements" : "Differences over the size of elements",
            .caption =
                "Magnitudes, before anything is explained: a difference that stays is none "
                "of the mesh. Dashed: slopes of the expected orders, through the finest "
                "mesh.",
            .x = {"size of elements h [mm]", true},
            .y = {norms ? "norm of the difference [%]" : "difference [%]", true}};
        for (const ComparedNumber& one : comparison.numbers) {
            if (one.is_norm != norms) continue;
            Curve curve{.name = one.title, .kind = Curve::Kind::line_and_points};
            for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
                const auto error = difference_of(one, k);
                if (error && *error != 0)
                    curve.add(1e3 * comparison.meshes[k].size, 100 * std::abs(*error));
            }
            if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
        }
        if (figure.curves.empty()) continue;
        add_slopes(comparison, norms, figure);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace tricontact::benchmarks

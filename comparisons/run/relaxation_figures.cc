#include <algorithm>
#include <array>
#include <numbers>

#include "comparisons/run/relaxation_report.h"
#include "contact/relaxing_case.h"
#include "io/case/case_input.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::DmaFit;
using report::Curve;

constexpr double turn = 2 * std::numbers::pi;
constexpr int curve_parts = 240;

struct Range {
    double low, high;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// G' and G'' [MPa] of the case over f [Hz].
std::vector<Curve> moduli(const Case& c, const Range& range) {
    const auto modulus = [&](double f) {
        return contact::relaxing_material(c).shear_modulus() *
               c.relaxation->dynamic_ratio(turn * f) * 1e-6;
    };
    Curve storage{.name = "G′", .colour = 0}, loss{.name = "G″", .colour = 1};
    storage.sample_decades(range.low, range.high, curve_parts,
                           [&](double f) { return modulus(f).real(); });
    loss.sample_decades(range.low, range.high, curve_parts,
                        [&](double f) { return modulus(f).imag(); });
    return {storage, loss};
}

/// Points of the table: G', G'' [MPa] with the case's relaxed modulus, and residuals of both [%].
std::array<Curve, 4> measured(const DmaFit& fit, double relaxed) {
    std::array<Curve, 4> curves;
    const char* const names[] = {"G′, measured", "G″, measured", "G′", "G″"};
    for (int i = 0; i < 4; ++i)
        curves[i] = {.name = names[i], .kind = Curve::Kind::points, .colour = i % 2};
    const double factor = relaxed / fit.relaxed_modulus;
    for (std::size_t k = 0; k < fit.table.size(); ++k) {
        const double omega = fit.table.omega[k], f = omega / turn;
        const auto fitted = fit.relaxed_modulus * fit.relaxation.dynamic_ratio(omega);
        curves[0].add(f, fit.table.storage[k] * factor * 1e-6);
        curves[1].add(f, fit.table.loss[k] * factor * 1e-6);
        curves[2].add(f, 100 * (fitted.real() / fit.table.storage[k] - 1));
        curves[3].add(f, 100 * (fitted.imag() / fit.table.loss[k] - 1));
    }
    return curves;
}

/// The points of a relaxation test and the fitted series [MPa], and its residuals [%].
std::vector<report::Figure> test_figures(const contact::RelaxationTestFit& fit) {
    const std::string symbol = fit.table.symbol();
    Curve points{.name = symbol + "(t), measured", .kind = Curve::Kind::points, .colour = 0},
        residuals{.name = symbol + "(t)", .kind = Curve::Kind::points, .colour = 0};
    for (std::size_t k = 0; k < fit.table.size(); ++k) {
        const double t = fit.table.time[k];
        if (t == 0) continue;  // has no place on a logarithmic axis
        points.add(t, fit.table.modulus[k] * 1e-6);
        residuals.add(t, 100 * (fit.modulus(t) / fit.table.modulus[k] - 1));
    }
    Curve series{.name = symbol + "(t)", .colour = 0};
    series.sample_decades(points.x.front(), points.x.back(), curve_parts,
                          [&](double t) { return fit.modulus(t) * 1e-6; });
    return {{.id = "relaxation_test",
             .title = "Relaxation test",
             .caption = "The table and the Prony series fitted to it, whose shape the case has.",
             .x = {"time t [s]", true},
             .y = {"modulus [MPa]"},
             .curves = {series, points}},
            {.id = "test_residuals",
             .title = "Residuals of the fit to the relaxation test",
             .caption = "Curve over point, minus 1.",
             .x = {"time t [s]", true},
             .y = {"residual [%]"},
             .curves = {residuals}}};
}

/// A vertical line over the whole of the figure.
struct Mark {
    double frequency;
    const char* name;
    const char* meaning;  ///< sentence of the caption
};

std::vector<Mark> marks(const RelaxationStudy& study) {
    std::vector<Mark> result;
    if (!study.twins.empty() && study.twins.front().drive)
        result.push_back(
            {study.twins.front().drive->frequency, "drive", "Drive: frequency of the rolling."});
    if (study.limit && study.limit->frequency)
        result.push_back(
            {*study.limit->frequency, "elastic within 1 %",
             "Below the other vertical line taking it as elastic errs by less than 1 %."});
    return result;
}

/// Two decades beyond the relaxation times, and everything that is marked [Hz].
Range frequencies(const Case& c, const std::vector<Mark>& marked) {
    const auto [fast, slow] =
        std::ranges::minmax(c.relaxation->branches, {}, &contact::Relaxation::Branch::time);
    Range range{0.01 / (turn * slow.time), 100 / (turn * fast.time)};
    for (const Mark& mark : marked) range.include(mark.frequency);
    const io::RelaxationFits& fits = io::relaxation_fits(c);
    if (fits.dma)
        for (const double omega : fits.dma->table.omega) range.include(omega / turn);
    return range;
}

}  // namespace

std::vector<report::Figure> modulus_figures(const Case& c, const RelaxationStudy& study) {
    const std::vector<Mark> marked = marks(study);
    const Range range = frequencies(c, marked);
    report::Figure figure{.id = "modulus",
                          .title = std::string("Dynamic shear modulus of the ") +
                                   (contact::substrate_relaxes(c) ? "substrate" : "indenter"),
                          .caption = "Storage modulus G′ and loss modulus G″ of the case.",
                          .x = {"frequency f [Hz]", true, range.low, range.high},
                          .y = {"modulus [MPa]", true},
                          .curves = moduli(c, range)};
    // Decades in which G'' is next to nothing are not worth the room.
    const double highest = 1.5 * figure.curves[0].y.back();
    figure.y.low = std::max(figure.curves[1].y.front(), 1e-3 * highest) / 2;
    figure.y.high = highest;
    for (const Mark& mark : marked) {
        figure.curves.push_back({.name = mark.name,
                                 .x = {mark.frequency, mark.frequency},
                                 .y = {*figure.y.low, *figure.y.high},
                                 .theory = true});
        figure.caption += std::string(" ") + mark.meaning;
    }
    const io::RelaxationFits& fits = io::relaxation_fits(c);
    if (fits.test) {
        std::vector<report::Figure> figures = test_figures(*fits.test);
        figures.insert(figures.begin(), std::move(figure));
        return figures;
    }
    if (!fits.dma) return {figure};
    const auto [storage, loss, storage_residual, loss_residual] =
        measured(*fits.dma, contact::relaxing_material(c).shear_modulus());
    figure.curves.insert(figure.curves.end(), {storage, loss});
    figure.caption +=
        " Points: the DMA table times one factor, so that its relaxed modulus is the case's.";
    return {figure,
            {.id = "modulus_residuals",
             .title = "Residuals of the fit to the DMA table",
             .caption = "Curve over point, minus 1.",
             .x = figure.x,
             .y = {"residual [%]"},
             .curves = {storage_residual, loss_residual}}};
}

}  // namespace tricontact::comparisons

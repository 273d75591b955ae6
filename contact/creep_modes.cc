#include "contact/creep_modes.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "contact/relaxing_case.h"
#include "contact/substrates/partly_relaxing_substrate.h"

namespace tricontact::contact {

namespace {

// A panel that begins at s is s wide: where exp(-s/l) is not yet rounding it falls by exp(-16) at
// most, which twenty points integrate to 1e-12.
using PanelRule = boost::math::quadrature::gauss<double, 20>;
constexpr double forgotten = 40;  // lengths of a branch: exp(-40)
/// Of a cell: what a shorter branch remembers of the first cell ahead of all that count is gone
/// before they come, exp(-8) a cell.
constexpr double shortest_seen = 1. / 8;

}  // namespace

CreepModes creep_modes(const Case& c) {
    const Relaxation& relaxation = *c.relaxation;
    if (relaxes_as_one(c)) return {{with_relaxing_ratio(c, 1)}, {Retardation(relaxation, 0)}, {1}};
    const StieltjesInterpolation interpolation = interpolation_of(c);
    CreepModes modes{{}, interpolation.creep(relaxation), interpolation.weights};
    for (const double ratio : interpolation.nodes)
        modes.bodies.push_back(with_relaxing_ratio(c, ratio));
    return modes;
}

CreepAlongWay::CreepAlongWay(std::vector<Retardation> modes, double speed, double cell,
                             double distance)
    : modes_(std::move(modes)), speed_(speed), cell_(cell) {
    double shortest = distance, longest = 0;
    for (const Retardation& mode : modes_)
        for (const auto& branch : mode.branches) {
            const double length = speed * branch.time;
            shortest = std::min(shortest, std::max(length, shortest_seen * cell));
            longest = std::max(longest, length);
        }
    double begin = 0;
    for (double width = shortest; begin < forgotten * longest; width *= 2) {
        for (std::size_t i = 0; i < PanelRule::abscissa().size(); ++i)
            for (const int side : {-1, 1}) {
                ahead_.push_back(begin + width / 2 * (1 + side * PanelRule::abscissa()[i]));
                weights_.push_back(width / 2 * PanelRule::weights()[i]);
            }
        begin += width;
    }
}

/// e at the first cell.
double CreepAlongWay::first_memory(double length, double first,
                                   std::span<const double> ahead) const {
    if (length < shortest_seen * cell_) return 0;
    double mean = 0;
    for (std::size_t q = 0; q < ahead.size(); ++q)
        mean += weights_[q] * std::exp(-ahead_[q] / length) / length * ahead[q];
    return first - mean;
}

void CreepAlongWay::add(std::size_t mode, std::span<const double> cells,
                        std::span<const double> ahead, std::span<double> sum) const {
    for (std::size_t k = 0; k < cells.size(); ++k) sum[k] += modes_[mode].relaxed * cells[k];
    for (const auto& [compliance, time] : modes_[mode].branches) {
        const double length = speed_ * time;
        if (!(length > 0)) continue;
        const double decay = std::exp(-cell_ / length), mean = StepIntegrals(cell_ / length).mean;
        double memory = first_memory(length, cells[0], ahead);
        sum[0] -= compliance * memory;
        for (std::size_t k = 1; k < cells.size(); ++k) {
            memory = decay * memory + mean * (cells[k] - cells[k - 1]);
            sum[k] -= compliance * memory;
        }
    }
}

}  // namespace tricontact::contact

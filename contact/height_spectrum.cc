#include "contact/height_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/fftw.h"
#include "contact/cells.h"

namespace tricontact::contact {

namespace {

using std::numbers::pi;

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Least squares on a lattice: slopes are the moments of height over those of place.
void remove_plane(HeightMap& map) {
    const double middle_x = (map.n_x - 1) / 2., middle_y = (map.n_y - 1) / 2.;
    const double level = mean(map.height);
    double along_x = 0, along_y = 0, square_x = 0, square_y = 0;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i) {
            const double x = i - middle_x, y = j - middle_y;
            along_x += x * map.at(i, j);
            along_y += y * map.at(i, j);
            square_x += x * x;
            square_y += y * y;
        }
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            map.at(i, j) -=
                level + along_x / square_x * (i - middle_x) + along_y / square_y * (j - middle_y);
}

/// Hann's window at the middle of the i-th of n strips, of mean square 1.
double window(int i, int n) {
    return std::sqrt(8. / 3) * (1 - std::cos(2 * pi * (i + .5) / n)) / 2;
}

void taper(HeightMap& map) {
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i) map.at(i, j) *= window(i, map.n_x) * window(j, map.n_y);
}

/// |h_m|^2 [m^2] of the waves with m_x >= 0, fastest in m_x.
std::vector<double> squared_coefficients(HeightMap map) {
    const std::size_t n = static_cast<std::size_t>(map.n_x / 2 + 1) * map.n_y;
    const auto waves = fftw_zeros<FftwComplex>(n);
    const FftwPlan plan(
        fftw_plan_dft_r2c_2d(map.n_y, map.n_x, map.height.data(), waves.get(), FFTW_ESTIMATE));
    fftw_execute(plan.get());
    std::vector<double> squares(n);
    const double nodes = static_cast<double>(map.height.size());
    for (std::size_t k = 0; k < n; ++k)
        squares[k] = (std::pow(waves[k][0], 2) + std::pow(waves[k][1], 2)) / nodes / nodes;
    return squares;
}

struct Ring {
    double waves = 0, wave_number = 0, square = 0;  // sums
};

}  // namespace

HeightSpectrum height_spectrum(const HeightMap& map, MapEdges edges) {
    HeightMap prepared = map;
    if (edges == MapEdges::open) {
        remove_plane(prepared);
        taper(prepared);
    }
    const auto squares = squared_coefficients(std::move(prepared));
    const Vector2 side = map.period();
    const double width = 2 * pi / std::min(side[0], side[1]);
    const double highest = pi / std::max(map.spacing[0], map.spacing[1]);
    std::vector<Ring> rings(static_cast<std::size_t>(highest / width) + 2);
    const int columns = map.n_x / 2 + 1;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < columns; ++i) {
            const double m_y = j <= map.n_y / 2 ? j : j - map.n_y;
            const double q = 2 * pi * std::hypot(i / side[0], m_y / side[1]);
            if (q > highest * (1 + 1e-9)) continue;
            const double both = i == 0 || 2 * i == map.n_x ? 1 : 2;  // the opposite wave, too
            Ring& ring = rings[static_cast<std::size_t>(std::lround(q / width))];
            ring.waves += both;
            ring.wave_number += both * q;
            ring.square += both * squares[static_cast<std::size_t>(j) * columns + i];
        }
    HeightSpectrum spectrum;
    for (std::size_t k = 1; k < rings.size(); ++k) {
        const Ring& ring = rings[k];
        if (ring.waves == 0) continue;
        spectrum.wave_number.push_back(ring.wave_number / ring.waves);
        spectrum.density.push_back(ring.square / ring.waves * side[0] * side[1] / (4 * pi * pi));
    }
    return spectrum;
}

HeightSpectrum surface_spectrum(const Case& c) {
    Case alone = c;  // the roughness without what it lies upon
    HeightMap map;
    if (c.indenter.height_map) {
        map = *c.indenter.height_map;
    } else {
        alone.indenter.shape = Case::Shape::flat;
        const double length = c.indenter.roughness->long_wavelength;
        const int n = std::max(2, static_cast<int>(std::lround(length / cell_side(c))));
        map = {
            n, n, {length / n, length / n}, std::vector<double>(static_cast<std::size_t>(n) * n)};
    }
    const auto indenter = alone.make_indenter();
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            map.at(i, j) = indenter->height((i - map.n_x / 2) * map.spacing[0],
                                            (j - map.n_y / 2) * map.spacing[1]);
    const bool repeats = !c.indenter.height_map || c.period;
    return height_spectrum(map, repeats ? MapEdges::repeat : MapEdges::open);
}

}  // namespace tricontact::contact

#include "contact/solvers/grid_transfer.h"

#include <algorithm>
#include <cmath>

#include "contact/base/memory.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

std::vector<double> to_coarser(const std::vector<double>& height, int n_x, int n_y, int n_threads) {
    const int m_x = (n_x + 1) / 2, m_y = (n_y + 1) / 2;
    std::vector<double> means = large_field(static_cast<std::size_t>(m_x) * m_y);
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int j = 0; j < m_y; ++j) {
        const double* const row = height.data() + static_cast<std::size_t>(2 * j) * n_x;
        const double* const next = 2 * j + 1 < n_y ? row + n_x : nullptr;
        for (int i = 0; i < m_x; ++i) {
            double sum = 0;
            int n = 0;
            auto add = [&](double h) {
                const bool is_finite = std::isfinite(h);
                sum += is_finite ? h : 0;
                n += is_finite;
            };
            for (int k = 2 * i; k < std::min(2 * i + 2, n_x); ++k) {
                add(row[k]);
                if (next) add(next[k]);
            }
            means[static_cast<std::size_t>(j) * m_x + i] = n > 0 ? sum / n : infinity;
        }
    }
    return means;
}

std::vector<double> to_finer(const std::vector<double>& pressure, int n_x, int n_y, int n_threads) {
    const int m_x = (n_x + 1) / 2, m_y = (n_y + 1) / 2;
    std::vector<double> fine = large_field(static_cast<std::size_t>(n_x) * n_y);
    // A quarter of the square's width off its centre, towards the next one.
    constexpr double near = .75, far = .25;
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int j = 0; j < n_y; ++j) {
        const int beside = std::clamp(j / 2 + (j % 2 == 0 ? -1 : 1), 0, m_y - 1);
        const double* const row = pressure.data() + static_cast<std::size_t>(j / 2) * m_x;
        const double* const next = pressure.data() + static_cast<std::size_t>(beside) * m_x;
        double* const to = fine.data() + static_cast<std::size_t>(j) * n_x;
        auto between = [&](int i) { return near * row[i] + far * next[i]; };
        double last = between(0), here = last;
        for (int i = 0; i < m_x; ++i) {
            const double after = i + 1 < m_x ? between(i + 1) : here;
            to[2 * i] = near * here + far * last;
            if (2 * i + 1 < n_x) to[2 * i + 1] = near * here + far * after;
            last = here;
            here = after;
        }
    }
    return fine;
}

}  // namespace tricontact::contact

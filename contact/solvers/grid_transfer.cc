#include "contact/solvers/grid_transfer.h"

#include <algorithm>
#include <cmath>

#include "contact/memory.h"
#include "contact/special_values.h"

namespace tricontact::contact {

std::vector<double> to_coarser(const std::vector<double>& height, int n_x, int n_y, int n_threads) {
    const int m_x = (n_x + 1) / 2, m_y = (n_y + 1) / 2;
    std::vector<double> means(static_cast<std::size_t>(m_x) * m_y);
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int j = 0; j < m_y; ++j)
        for (int i = 0; i < m_x; ++i) {
            double sum = 0;
            int n = 0;
            for (int l = 2 * j; l < std::min(2 * j + 2, n_y); ++l)
                for (int k = 2 * i; k < std::min(2 * i + 2, n_x); ++k) {
                    const double h = height[static_cast<std::size_t>(l) * n_x + k];
                    if (!std::isfinite(h)) continue;
                    sum += h;
                    ++n;
                }
            means[static_cast<std::size_t>(j) * m_x + i] = n > 0 ? sum / n : infinity;
        }
    return means;
}

std::vector<double> to_finer(const std::vector<double>& pressure, int n_x, int n_y, int n_threads) {
    const int m_x = (n_x + 1) / 2, m_y = (n_y + 1) / 2;
    std::vector<double> fine = large_field(static_cast<std::size_t>(n_x) * n_y);
    // A quarter of the square's width off its centre, towards the next one.
    constexpr double near = .75, far = .25;
    auto beside = [](int i, int m) { return std::clamp(i / 2 + (i % 2 == 0 ? -1 : 1), 0, m - 1); };
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int j = 0; j < n_y; ++j) {
        const double* const row = pressure.data() + static_cast<std::size_t>(j / 2) * m_x;
        const double* const next = pressure.data() + static_cast<std::size_t>(beside(j, m_y)) * m_x;
        for (int i = 0; i < n_x; ++i) {
            const int other = beside(i, m_x);
            fine[static_cast<std::size_t>(j) * n_x + i] =
                near * (near * row[i / 2] + far * row[other]) +
                far * (near * next[i / 2] + far * next[other]);
        }
    }
    return fine;
}

}  // namespace tricontact::contact

#include "experiments/design/level_line.h"

#include <array>
#include <cmath>

namespace tricontact::experiments {

std::vector<std::pair<LevelPoint, LevelPoint>> zero_line(const LevelGrid& grid) {
    std::vector<std::pair<LevelPoint, LevelPoint>> pieces;
    const std::size_t n = grid.places.size();
    for (std::size_t j = 0; j + 1 < n; ++j)
        for (std::size_t i = 0; i + 1 < n; ++i) {
            constexpr std::array<std::pair<std::size_t, std::size_t>, 5> corners{
                {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
            std::vector<LevelPoint> crossings;
            bool is_known = true;
            for (std::size_t k = 0; k < 4; ++k) {
                const auto [i_0, j_0] = corners[k];
                const auto [i_1, j_1] = corners[k + 1];
                const double a = grid.values[i + i_0 + (j + j_0) * n],
                             b = grid.values[i + i_1 + (j + j_1) * n];
                if (std::isnan(a) || std::isnan(b)) is_known = false;
                if ((a > 0) == (b > 0)) continue;
                const double t = a / (a - b);
                crossings.emplace_back(std::lerp(grid.places[i + i_0], grid.places[i + i_1], t),
                                       std::lerp(grid.places[j + j_0], grid.places[j + j_1], t));
            }
            if (!is_known) continue;
            for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
                pieces.emplace_back(crossings[k], crossings[k + 1]);
        }
    return pieces;
}

}  // namespace tricontact::experiments

#include "benchmarks/decks/graded_line.h"

#include <algorithm>
#include <cmath>

namespace tricontact::benchmarks {

namespace {

// size (g + g^2 + ... + g^n): what n growing elements cover.
double grown_length(double size, double growth, int n) {
    double sum = 0, length = size;
    for (int i = 0; i < n; ++i) sum += length *= growth;
    return sum;
}

}  // namespace

std::vector<double> graded_line(double start, double size, int count, double end, double growth) {
    std::vector<double> line;
    for (int i = 0; i <= count; ++i) line.push_back(start + i * size);
    const double rest = end - line.back();
    if (rest <= 1e-9 * size) return line;
    int n = 1;
    while (grown_length(size, growth, n) < rest) ++n;
    // The factor that fits: below the largest one, and above that of elements that only fill the
    // rest.
    double low = 0, high = growth;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (grown_length(size, middle, n) < rest ? low : high) = middle;
    }
    double length = size;
    for (int i = 0; i < n; ++i) line.push_back(line.back() + (length *= high));
    line.back() = end;
    return line;
}

std::vector<double> refined_line(const std::vector<double>& line, int level) {
    const int parts = 1 << level;
    std::vector<double> fine{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 1; k <= parts; ++k)
            fine.push_back(k == parts ? line[i]
                                      : line[i - 1] + (line[i] - line[i - 1]) * k / parts);
    return fine;
}

std::vector<double> mirrored_line(const std::vector<double>& line) {
    std::vector<double> whole;
    for (auto x = line.rbegin(); x != line.rend(); ++x) whole.push_back(*x == 0 ? 0 : -*x);
    whole.insert(whole.end(), line.begin() + 1, line.end());
    return whole;
}

std::vector<double> line_within(const std::vector<double>& line, double reach) {
    std::vector<double> part;
    std::ranges::copy_if(line, std::back_inserter(part),
                         [&](double x) { return std::abs(x) <= reach * (1 + 1e-9); });
    return part;
}

}  // namespace tricontact::benchmarks

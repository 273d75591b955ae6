#include "experiments/assumptions/sliding_slope.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"
#include "io/tables/divided_text.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

constexpr std::string_view sliding_key = "measurement.sliding_force";
constexpr std::size_t most_sliding_rows = 10'000, least_loads = 3;
constexpr double slope_confidence = .95;

struct SlidingForces {
    std::vector<double> loads, forces, errors;  // [N]
};

SlidingForces read_sliding(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    const io::CsvTable table(
        io::utf8_text(io::read_input_file(file, "table of a measurement", 1), name), name,
        {.kind = "table of a measurement",
         .header = "normal_force [N], sliding_force [N], sliding_force_error [N]",
         .most_rows = most_sliding_rows,
         .thinning = "thin it out, or take means"});
    table.check_names({"normal_force", "sliding_force", "sliding_force_error"});
    SlidingForces read{table.values("normal_force", io::Dimension::force),
                       table.values("sliding_force", io::Dimension::force),
                       {}};
    table.check_positive("normal_force");
    table.check_positive("sliding_force");
    if (table.has("sliding_force_error")) {
        read.errors = table.values("sliding_force_error", io::Dimension::force);
        table.check_positive("sliding_force_error");
    }
    if (std::set<double>(read.loads.begin(), read.loads.end()).size() < least_loads)
        table.refuse_header("a slope and its error need three different loads at least");
    return read;
}

}  // namespace

std::optional<SlidingSlope> sliding_slope(const io::Document& document) {
    const io::Entry* entry = document.find(sliding_key);
    if (!entry) return {};
    std::string file;
    io::read_field(io::rig_key(sliding_key), *entry, io::Field(&file));
    const SlidingForces read = io::told_at(document, std::string(sliding_key),
                                           [&] { return read_sliding(document.path_of(file)); });
    std::vector<double> x, y, weights;
    for (std::size_t i = 0; i < read.loads.size(); ++i) {
        x.push_back(std::log(read.loads[i]));
        y.push_back(std::log(read.forces[i]));
        if (!read.errors.empty()) weights.push_back(std::pow(read.forces[i] / read.errors[i], 2));
    }
    const statistics::Fit fit = statistics::fit_linear({std::vector<double>(x.size(), 1.), x}, y,
                                                       {.confidence = slope_confidence,
                                                        .weights = weights,
                                                        .weights_are_absolute = !weights.empty()});
    const statistics::Estimate& slope = fit.parameters[1];
    const auto [least, largest] = std::ranges::minmax(read.loads);
    return SlidingSlope{.slope = slope.value,
                        .standard_error = slope.standard_error,
                        .quantile = (slope.high - slope.value) / slope.standard_error,
                        .n_forces = static_cast<int>(read.loads.size()),
                        .least_load = least,
                        .largest_load = largest};
}

}  // namespace tricontact::experiments

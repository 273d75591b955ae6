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

constexpr const char* few_loads = "a slope and its error need three different loads at least";

std::size_t n_loads(const SlidingForces& read) {
    return std::set<double>(read.loads.begin(), read.loads.end()).size();
}

/// `name`: for messages. `is_alone`: no other table has further loads.
SlidingForces read_sliding(const std::string& file, const std::string& name, bool is_alone) {
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
    if (is_alone && n_loads(read) < least_loads) table.refuse_header(few_loads);
    return read;
}

SlidingForces read_all(const std::vector<std::string>& files, const io::Document& document) {
    SlidingForces all;
    for (const std::string& file : files) {
        const std::string name =
            files.size() > 1 ? file : std::filesystem::path(file).filename().string();
        const SlidingForces one = read_sliding(document.path_of(file), name, files.size() == 1);
        if (!all.loads.empty() && all.errors.empty() != one.errors.empty())
            io::fail(name, "", "of several tables all state errors or none",
                     "add sliding_force_error to all of them, or leave it out");
        all.loads.insert(all.loads.end(), one.loads.begin(), one.loads.end());
        all.forces.insert(all.forces.end(), one.forces.begin(), one.forces.end());
        all.errors.insert(all.errors.end(), one.errors.begin(), one.errors.end());
    }
    if (n_loads(all) < least_loads) io::fail(io::joined(files), "", few_loads, "measure more");
    return all;
}

}  // namespace

std::optional<SlidingSlope> sliding_slope(const io::Document& document) {
    const io::Entry* entry = document.find(sliding_key);
    if (!entry) return {};
    std::vector<std::string> files;
    io::read_field(io::rig_key(sliding_key), *entry, io::Field(&files));
    const SlidingForces read =
        io::told_at(document, std::string(sliding_key), [&] { return read_all(files, document); });
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

#include <algorithm>
#include <cmath>

#include "benchmarks/submissions/read_field.h"
#include "benchmarks/submissions/submission_file.h"
#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

/// Points at which the largest of all loads is above a thousandth.
std::vector<std::size_t> loaded_points(const MeshField& field) {
    using enum Meaning;
    std::vector<double> load(field.size(), 0.);
    for (const Meaning meaning : {pressure, traction_z, force_normal, force_z}) {
        const FieldColumn* column = field.find(meaning);
        if (!column) continue;
        for (std::size_t i = 0; i < load.size(); ++i) load[i] = std::abs(column->values[i]);
        break;
    }
    const double largest = load.empty() ? 0 : *std::ranges::max_element(load);
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < load.size(); ++i)
        if (load[i] > 1e-3 * largest || largest == 0) points.push_back(i);
    return points;
}

double extent(const MeshField& field, Meaning meaning, const std::vector<std::size_t>& points) {
    const FieldColumn* column = field.find(meaning);
    if (!column || points.empty()) return 0;
    double low = INFINITY, high = -INFINITY;
    for (const std::size_t i : points) {
        low = std::min(low, column->values[i]);
        high = std::max(high, column->values[i]);
    }
    return high - low;
}

}  // namespace

double relative_point_distance(const MeshField& field) {
    const auto points = loaded_points(field);
    if (points.size() < 2) return 0;
    const double x = std::max(extent(field, Meaning::x, points), extent(field, Meaning::r, points));
    const double y = extent(field, Meaning::y, points);
    const auto n = static_cast<double>(points.size());
    const double longest = std::max(x, y);
    if (longest == 0) return 0;
    // Points of one row, or of a rectangle.
    return std::min(x, y) < longest / n ? 1 / (n - 1) : std::sqrt(x * y / n) / longest;
}

Submission submission_of_files(const std::string& problem, const std::vector<std::string>& files) {
    if (files.empty())
        io::fail(problem, "", "no results are named", "name one file per mesh, coarse to fine");
    if (files.size() > static_cast<std::size_t>(most_meshes))
        io::fail(problem, "", "there are more than " + std::to_string(most_meshes) + " meshes",
                 "keep the finest");
    Submission submission{.problem = problem};
    for (const std::string& file : files) submission.meshes.push_back(read_field({file, "", ""}));
    auto& meshes = submission.meshes;
    const bool have_sizes = std::ranges::all_of(meshes, [](const MeshField& mesh) {
        const auto size = mesh.totals.find("size");
        return size != mesh.totals.end() && size->second.unit;
    });
    std::ranges::stable_sort(meshes, std::greater<>(), [&](const MeshField& mesh) {
        return have_sizes ? mesh.totals.at("size").value : relative_point_distance(mesh);
    });
    return submission;
}

}  // namespace tricontact::benchmarks

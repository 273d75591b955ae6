#include "benchmarks/comparison/exact_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "benchmarks/comparison/compared_numbers.h"
#include "benchmarks/comparison/surface_layout.h"
#include "benchmarks/reference/closed_reference.h"
#include "benchmarks/reference/quantity_units.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double not_told = std::numeric_limits<double>::quiet_NaN();
// Units differ by 10 and more, a result that fails by less.
constexpr double largest_unit_misfit = .7;  // natural logarithm
constexpr double deviation_share = .1;      // of the tolerance: no refinement takes it away
const char* const no_order = "none: exact on every mesh";

struct UnitSize {
    const char* name;
    double size;
};
constexpr std::array pressure_units{UnitSize{"MPa", 1e6}, UnitSize{"Pa", 1}, UnitSize{"kPa", 1e3},
                                    UnitSize{"GPa", 1e9}};
constexpr std::array length_units_of_patch{UnitSize{"mm", 1e-3}, UnitSize{"m", 1},
                                           UnitSize{"cm", 1e-2}};

/// Of a column's values that should be near `due` in SI.
UnitSize nearest_unit(double value, double due, std::span<const UnitSize> units,
                      const std::string& place) {
    const auto misfit = [&](const UnitSize& unit) {
        return std::abs(std::log(std::abs(value) * unit.size / due));
    };
    const UnitSize best = *std::ranges::min_element(units, {}, misfit);
    if (!(misfit(best) < largest_unit_misfit))
        throw contact::InputError(
            fmt::format("{}: not understood: {:.4g} is near {:.4g} in no unit that is tried; "
                        "state the unit in brackets behind the column's name",
                        place, value, due));
    return best;
}

/// Standing by the mesh that is furthest off, without a limit.
void judge_every_mesh(ComparedNumber& n) {
    double worst = 0;
    for (const auto& value : n.values) {
        if (!value) continue;
        const double d = n.is_norm ? *value : *value / n.reference.value - 1;
        n.finest = d;
        if (!(std::abs(d) < std::abs(worst))) worst = d;
    }
    n.difference = worst;
    for (const Explained& e : n.explained) n.uncertainty = std::hypot(n.uncertainty, e.bar);
    n.unexplained_standing = standing_of(n.difference, 0, n.tolerance);
    n.standing = standing_of(n.left(), n.uncertainty, n.tolerance);
    n.expected_order = no_order;
    if (n.standing == Standing::not_resolved) {
        n.blame = "what explains the difference is known too badly";
        n.remedy = "a stiffer penalty";
    }
}

void add_number(Comparison& c, const std::string& key, std::vector<std::optional<double>> values,
                std::vector<Explained> explained = {}) {
    if (std::ranges::none_of(values, [](const auto& v) { return v.has_value(); })) return;
    ComparedNumber n;
    n.key = key;
    n.title = std::string(title_of_quantity(key));
    n.unit = usual_unit(key, Geometry::plane).base;
    n.values = std::move(values);
    n.reference = *c.reference.find(key);
    n.tolerance = c.submission.tolerances.at(key);
    n.explained = std::move(explained);
    judge_every_mesh(n);
    c.numbers.push_back(std::move(n));
}

/// Every number decides: there is nothing that a mesh could excuse.
void decide(Comparison& c) {
    const auto worst = [&](auto standing_of_number) {
        Standing found = Standing::pass;
        for (const ComparedNumber& n : c.numbers) {
            if (standing_of_number(n) == Standing::fail) return Standing::fail;
            if (standing_of_number(n) == Standing::not_resolved) found = Standing::not_resolved;
        }
        return found;
    };
    c.standing = worst([](const ComparedNumber& n) { return n.standing; });
    c.unexplained_standing = worst([](const ComparedNumber& n) { return n.unexplained_standing; });
    for (const ComparedNumber& n : c.numbers)
        if (c.blame.empty() && n.standing == c.standing && !n.blame.empty())
            c.blame = n.title + ": " + n.blame;
    for (const auto& [key, tolerance] : c.submission.tolerances.of)
        if (std::ranges::find(c.numbers, key, &ComparedNumber::key) == c.numbers.end())
            throw contact::InputError(
                fmt::format("tolerance.{}: nothing of this name is compared here", key));
}

struct PatchMesh {
    MeshResult result;
    double mean = 0, largest = 0, deviation = 0;  ///< [Pa], [Pa], over the mean
    std::optional<double> displacement;           ///< of the interface [m]
};

/// Pressures [Pa] at the points, compression positive.
std::vector<double> pressures(const MeshField& field, const SurfaceLayout& layout, double due,
                              std::vector<Convention>& conventions) {
    const FieldColumn& column = normal_column(field, layout);
    const std::string place = field.file + ": column " + column.heading;
    if (says_force(column).value_or(false))
        throw contact::InputError(
            place +
            ": has nodal forces, which are no pressures: of a uniform one they differ "
            "from node to node; write the contact's pressures");
    std::vector<double> p(column.values);
    double sum = 0;
    for (const double v : p) sum += v;
    const double mean = sum / static_cast<double>(p.size());
    UnitSize unit{"", 1};
    if (!column.unit) {
        unit = nearest_unit(mean, due, pressure_units, place);
        conventions.push_back({"kind",
                               fmt::format("{}: tractions in {}", column.heading, unit.name),
                               fmt::format("their mean is {:.4g} of the closed form",
                                           std::abs(mean) * unit.size / due)});
    }
    if (mean < 0)
        conventions.push_back(
            {"sign", "tension is positive in the file", "the mean is negative where blocks press"});
    for (double& v : p) v *= mean < 0 ? -unit.size : unit.size;
    return p;
}

/// Of a column's values and the points the mean along the normal; empty without the column.
std::optional<double> mean_displacement(const MeshField& field, const SurfaceLayout& layout,
                                        double length_unit) {
    const bool height_is_y = layout.x_axis != Meaning::y;
    for (const Meaning meaning : {height_is_y ? Meaning::displacement_y : Meaning::displacement_x,
                                  Meaning::displacement_z}) {
        const FieldColumn* column = field.find(meaning);
        if (!column) continue;
        double sum = 0, size = 0;
        for (const double v : column->values) {
            sum += v;
            size += std::abs(v);
        }
        if (size == 0) continue;  // across the plane
        return sum / static_cast<double>(column->values.size()) * (column->unit ? 1 : length_unit);
    }
    return {};
}

PatchMesh patch_mesh(const MeshField& field, const Reference& reference,
                     std::vector<Convention>& conventions) {
    if (field.size() == 0)
        throw contact::InputError(
            field.file +
            ": the patch test is judged by the pressures at points of the interface, and there are "
            "none; give a table x [mm], p [MPa]");
    const SurfaceLayout layout = surface_layout(field, Geometry::plane);
    const auto p =
        pressures(field, layout, reference.find(keys::peak_pressure)->value, conventions);
    const auto [low, high] = std::ranges::minmax(layout.x);
    const double length = layout.unit
                              ? 1
                              : nearest_unit(high - low, 2 * reference.contact_radius,
                                             length_units_of_patch, field.file + ": positions")
                                    .size;
    PatchMesh mesh;
    mesh.result.file = field.file;
    mesh.result.geometry = Geometry::plane;
    std::vector<double> x(layout.x);
    std::ranges::sort(x);
    for (std::size_t i = 1; i < x.size(); ++i)
        mesh.result.size = std::max(mesh.result.size, (x[i] - x[i - 1]) * length);
    if (const auto size = field.totals.find("size"); size != field.totals.end())
        mesh.result.size = size->second.value * (size->second.unit ? 1 : length);
    for (std::size_t i = 0; i < p.size(); ++i) {
        SurfacePoint point{.x = (layout.x[i] - (low + high) / 2) * length,
                           .y = 0,
                           .area = 0,
                           .values = {p[i], not_told, not_told, not_told, not_told, not_told},
                           .gap = not_told,
                           .status = not_told};
        mesh.result.points.push_back(point);
        mesh.mean += p[i] / static_cast<double>(p.size());
        mesh.largest = std::max(mesh.largest, p[i]);
    }
    for (const double v : p)
        mesh.deviation = std::max(mesh.deviation, std::abs(v - mesh.mean) / mesh.mean);
    mesh.displacement = mean_displacement(field, layout, length);
    if (const auto u = field.totals.find(keys::displacement); u != field.totals.end())
        mesh.displacement = u->second.value * (u->second.unit ? 1 : length);
    return mesh;
}

void diagnose_patch(Comparison& c) {
    const ComparedNumber& deviation = c.numbers.front();
    if (deviation.standing == Standing::fail)
        c.diagnoses.push_back(
            {"patch_test",
             fmt::format("Pressures differ from their mean by up to {:.3g} %, and the exact one is "
                         "uniform: where meshes do not match, no refinement removes such an error",
                         100 * deviation.difference),
             "contact in both directions, or from surface to surface with an integral over the "
             "common segments (mortar); quadratic elements need consistent nodal forces"});
    const double finite = -std::log1p(-.1) / .1 - 1;
    if (c.submission.contact.kinematics == ContactMethod::Kinematics::finite)
        c.diagnoses.push_back(
            {"finite_strain",
             fmt::format("The strain is 0.1: with logarithmic strains the pressure is {:+.3g} %",
                         100 * finite),
             "small strains, or judge the deviation alone"});
}

struct WedgeCause {
    double ratio;
    const char* text;
};

void diagnose_wedge(Comparison& c) {
    const ComparedNumber& n = c.numbers.front();
    if (n.standing != Standing::fail || !n.values.back()) return;
    const double t = wedge_slope, mu = wedge_friction;
    const std::array causes{
        WedgeCause{t + mu, "the friction acts along the level, not along the slope"},
        WedgeCause{mu, "the face is level"}, WedgeCause{t, "there is no friction"},
        WedgeCause{(mu - t) / (1 + mu * t), "the block slides down"}};
    std::string text;
    for (const WedgeCause& cause : causes)
        if (std::abs(std::abs(*n.values.back()) / cause.ratio - 1) < 2e-3)
            text = fmt::format(": as if {}, {:.6g}", cause.text, cause.ratio);
    c.diagnoses.push_back(
        {"wedge", fmt::format("F/G differs by {:+.3g} %{}", 100 * n.difference, text),
         "check that the whole contact slides, the normal of the face and the side to which "
         "friction acts"});
}

}  // namespace

Comparison compare_patch_test(Submission submission) {
    Comparison c;
    c.submission = std::move(submission);
    c.reference = patch_test_reference();
    std::vector<std::optional<double>> deviation, peak, force, displacement;
    for (const MeshField& field : c.submission.meshes) {
        c.conventions.clear();  // those of the last mesh are said
        const PatchMesh mesh = patch_mesh(field, c.reference, c.conventions);
        deviation.emplace_back(mesh.deviation);
        const auto total = [&](const char* key) -> std::optional<double> {
            const auto found = field.totals.find(key);
            if (found == field.totals.end() || !found->second.unit) return {};
            return std::abs(found->second.value);
        };
        peak.push_back(total(keys::peak_pressure).value_or(mesh.largest));
        force.push_back(total(keys::normal_force));
        displacement.push_back(mesh.displacement);
        c.meshes.push_back(mesh.result);
    }
    ComparedNumber n;
    n.key = pressure_deviation;
    n.title = "pressure, largest deviation from its mean";
    n.is_norm = true;
    n.values = std::move(deviation);
    const auto& tolerances = c.submission.tolerances;
    n.tolerance =
        tolerances.of.contains(n.key) ? tolerances.at(n.key) : deviation_share * tolerances.usual;
    judge_every_mesh(n);
    c.numbers.push_back(std::move(n));
    std::vector<Explained> penalty, penetration;
    if (c.submission.contact.stiffness) {
        const double change = patch_test_penalty(*c.submission.contact.stiffness);
        penalty.push_back({"penalty", "normal penalty", change, 0});
        // Of the upper block's face; that of the lower one moves as much less.
        penetration.push_back({"penalty", "normal penalty", 0, std::abs(change)});
    }
    add_number(c, keys::peak_pressure, std::move(peak), penalty);
    add_number(c, keys::normal_force, std::move(force), penalty);
    add_number(c, keys::displacement, std::move(displacement), penetration);
    diagnose_patch(c);
    decide(c);
    return c;
}

Comparison compare_wedge(Submission submission) {
    Comparison c;
    c.submission = std::move(submission);
    c.reference = wedge_reference();
    std::vector<std::optional<double>> ratios;
    for (const MeshField& field : c.submission.meshes) {
        MeshResult mesh;
        mesh.file = field.file;
        const auto total = [&](const char* key) {
            const auto found = field.totals.find(key);
            return found == field.totals.end() ? nullptr : &found->second;
        };
        const Total *ratio = total(keys::force_ratio), *pushed = total(keys::tangential_force),
                    *weight = total(keys::normal_force);
        if (ratio) {
            ratios.emplace_back(ratio->value);
        } else if (pushed && weight && weight->value != 0 &&
                   pushed->unit.has_value() == weight->unit.has_value()) {
            ratios.emplace_back(std::abs(pushed->value / weight->value));
            c.conventions = {{"ratio", "F/G of the tangential and the normal force",
                              fmt::format("{:.6g} over {:.6g}", pushed->value, weight->value)}};
        } else {
            throw contact::InputError(
                field.file +
                ": the wedge is judged by F/G: its pressures have no closed form; state "
                "force_ratio, or tangential_force and normal_force, both with their units");
        }
        if (const Total* size = total("size"); size && size->unit) mesh.size = size->value;
        c.meshes.push_back(mesh);
    }
    if (std::ranges::any_of(c.submission.meshes, [](const MeshField& m) { return m.size() > 0; }))
        c.sentences.push_back(
            "The fields are not judged: the block is pushed from one side and its pressures have "
            "no closed form.");
    add_number(c, keys::force_ratio, std::move(ratios));
    diagnose_wedge(c);
    decide(c);
    return c;
}

}  // namespace tricontact::benchmarks

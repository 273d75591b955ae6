#include "benchmarks/comparison/conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "benchmarks/comparison/load_reading.h"
#include "benchmarks/comparison/mesh_sizes.h"
#include "benchmarks/comparison/surface_axes.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Values of a column in SI by its reading; NaN throughout where there is none.
std::vector<double> tractions(const FieldColumn* column, const LoadReading& reading, double cover,
                              const std::vector<double>& areas, std::size_t n) {
    if (!column) return std::vector<double>(n, undefined);
    std::vector<double> t(column->values);
    const bool is_force = says_force(*column).value_or(reading.is_force);
    for (std::size_t i = 0; i < n; ++i) {
        if (!column->unit) t[i] *= reading.unit;
        // Of part of a ring: over the same part of its area.
        if (is_force) t[i] = areas[i] > 0 ? t[i] * reading.share / (cover * areas[i]) : undefined;
    }
    return t;
}

std::vector<double> plain_values(const MeshField& field, Meaning meaning, double unit) {
    const FieldColumn* column = field.find(meaning);
    if (!column) return std::vector<double>(field.size(), undefined);
    std::vector<double> v(column->values);
    if (!column->unit)
        for (double& one : v) one *= unit;
    return v;
}

MeshResult points_of(const WeightedField& w, const LoadReading& reading,
                     const ContactReach& reach) {
    const MeshField& field = *w.laid_out->field;
    const SurfaceLayout& layout = w.laid_out->layout;
    MeshResult mesh;
    mesh.file = field.file;
    mesh.geometry = layout.geometry;
    mesh.faces = w.faces;
    const std::size_t n = w.x.size();
    const double cover = reach.parts();
    const auto p = tractions(w.laid_out->normal, reading, cover, w.lumped, n);
    const TangentialColumns tangential = tangential_columns(field, layout);
    const auto tx = tractions(tangential.x, reading, cover, w.lumped, n);
    const auto ty = tractions(tangential.y, reading, cover, w.lumped, n);
    const auto along = [&](Meaning first, Meaning axis) {
        const int k =
            axis == Meaning::r ? 0 : static_cast<int>(axis) - static_cast<int>(Meaning::x);
        return plain_values(field, static_cast<Meaning>(static_cast<int>(first) + k), reach.unit);
    };
    const auto ux = along(Meaning::displacement_x, layout.x_axis);
    const bool is_spatial = layout.geometry == Geometry::spatial;
    const auto uy = is_spatial ? along(Meaning::displacement_x, layout.y_axis)
                               : std::vector<double>(n, undefined);
    Meaning height = layout.y_axis;
    if (is_spatial)
        for (const Meaning m : {Meaning::x, Meaning::y, Meaning::z})
            if (m != layout.x_axis && m != layout.y_axis) height = m;
    auto uz = along(Meaning::displacement_x, height);
    const auto gap = plain_values(field, Meaning::gap, reach.unit);
    const FieldColumn* status = field.find(Meaning::status);
    mesh.points.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        SurfacePoint& point = mesh.points[i];
        point.x = w.x[i];
        point.y = is_spatial ? w.y[i] : 0;
        point.area = w.lumped[i];
        point.values = {p[i] * reading.sign, tx[i], ty[i], ux[i], uy[i], uz[i]};
        point.gap = gap[i];
        point.status = status ? status->values[i] : undefined;
    }
    return mesh;
}

/// Integral of a column over the whole contact; empty without the column.
std::optional<double> integral(const WeightedField& w, const FieldColumn* column,
                               const LoadReading& reading, const ContactReach& reach) {
    if (!column) return {};
    const bool is_force = says_force(*column).value_or(reading.is_force);
    double sum = 0;
    for (std::size_t i = 0; i < w.x.size(); ++i)
        sum += column->values[i] * (is_force ? 1 : w.weights[i]);
    return sum * (column->unit ? 1 : reading.unit) * (is_force ? reading.share : reach.parts());
}

/// Totals whose numbers are those of the whole contact however it was modelled.
bool is_resultant(const std::string& key) {
    return key == keys::normal_force || key == keys::tangential_force;
}
/// Those that go with the part that was modelled.
bool is_extensive(const std::string& key) {
    return is_resultant(key) || key == "balancing_force" || key == keys::stored_energy ||
           key == keys::dissipation || key == keys::contact_area || key == keys::stick_area;
}

/// What a number without a unit has to be multiplied by for its lengths.
double length_factor(const std::string& key, double unit) {
    if (key == keys::contact_area || key == keys::stick_area) return unit * unit;
    const bool has_length = key == keys::indentation || key == keys::shift ||
                            key == keys::stored_energy || key == keys::dissipation ||
                            key == keys::contact_radius || key == keys::static_shift ||
                            key == keys::settled_shift || key == keys::shift_increment;
    return has_length ? unit : 1;
}

/// Length and other totals as they stand, resultants of the whole contact.
void read_totals(UnderstoodMesh& mesh, const MeshField& field, const ContactReach& reach,
                 const Reference& reference, std::vector<Convention>& conventions) {
    const auto reference_of = [&](const char* key) {
        const ReferenceValue* v = reference.find(key);
        return v && v->value != 0 ? std::abs(v->value) : 0.;
    };
    double factor = 1, share = 1;
    const auto normal = field.totals.find(keys::normal_force);
    if (normal != field.totals.end()) {
        const ForceReading read =
            force_reading(normal->second, keys::normal_force, reference_of(keys::normal_force),
                          mesh.field_force, reach, mesh.result.geometry);
        factor = read.factor;
        share = read.share;
        mesh.result.totals[keys::normal_force] = std::abs(normal->second.value) * factor;
        if (!read.is_plain)
            conventions.push_back({"share", "the force given is in " + read.text,
                                   fmt::format("{}: times {:.4g} it is {:.4g} of {}",
                                               normal->second.place, factor, read.ratio,
                                               mesh.field_force ? "the integral of the pressures"
                                                                : "the reference's force")});
    }
    for (const auto& [key, total] : field.totals) {
        if (key == keys::normal_force || key == "size" || key == "cpu_time") continue;
        double whole = total.value;
        if (is_extensive(key))
            whole *=
                total.unit || key == keys::contact_area || key == keys::stick_area ? share : factor;
        if (!total.unit) whole *= length_factor(key, reach.unit);
        mesh.result.totals[key] =
            key == keys::tangential_force || key == keys::shift ? whole : std::abs(whole);
    }
}

std::string parts_text(const ContactReach& reach) {
    if (reach.parts() == 4) return "a quarter of the contact was modelled";
    if (reach.parts_x == 2) return "the half x > 0 or x < 0 was modelled";
    return "the half y > 0 or y < 0 was modelled";
}

void say_reading(std::vector<Convention>& conventions, const std::vector<LaidOutField>& laid_out,
                 const ContactReach& reach, const LoadReading& reading) {
    const LaidOutField& finest = laid_out.back();
    conventions.push_back(
        {"coordinates",
         fmt::format("{}, in {}{}", finest.layout.text, reach.unit_name,
                     finest.layout.unit ? "" : " (found)"),
         fmt::format("the pressure reaches {:.3g} times as far as the reference's", reach.ratio)});
    conventions.push_back(
        {"kind",
         fmt::format(
             "{}: {} in {}{}{}", finest.normal->heading,
             reading.is_force ? "nodal forces" : "tractions", reading.unit_name,
             finest.normal->unit ? "" : " (found)",
             reading.is_force && !reading.share_name.empty() ? ", " + reading.share_name : ""),
         fmt::format(
             "their resultant is {:.4g} of the reference's force, the largest pressure {:.4g}",
             reading.resultant_ratio, reading.peak_ratio)});
    if (reading.sign < 0)
        conventions.push_back({"sign", "tension is positive in the file",
                               "the resultant is negative where the bodies press"});
    if (reach.parts() > 1)
        conventions.push_back({"share", parts_text(reach),
                               "points on one side of the plane reach as far as the contact does"});
}

UnderstoodMesh without_field(const MeshField& field) {
    UnderstoodMesh mesh;
    mesh.result.file = field.file;
    return mesh;
}

}  // namespace

Understanding understand(const Submission& submission, const Reference& reference) {
    Understanding out;
    if (submission.meshes.empty())
        throw contact::InputError("nothing to compare: the submission has no mesh");
    std::vector<LaidOutField> laid_out;
    for (const MeshField& field : submission.meshes) {
        if (field.size() == 0) continue;
        LaidOutField one;
        one.field = &field;
        one.layout = surface_layout(field, reference.geometry);
        one.normal = &normal_column(field, one.layout);
        laid_out.push_back(std::move(one));
    }
    if (!laid_out.empty() && laid_out.size() != submission.meshes.size())
        throw contact::InputError(
            "some meshes have a field and some have not; give one for each, or totals alone");
    ContactReach reach;
    LoadReading reading;
    std::vector<WeightedField> weighted;
    if (!laid_out.empty()) {
        reach = contact_reach(laid_out, reference);
        for (const LaidOutField& one : laid_out) weighted.push_back(weighted_field(one, reach));
        reading = load_reading(weighted, reach, reference);
        say_reading(out.conventions, laid_out, reach, reading);
    }
    for (std::size_t k = 0; k < submission.meshes.size(); ++k) {
        const MeshField& field = submission.meshes[k];
        UnderstoodMesh mesh = without_field(field);
        if (!weighted.empty()) {
            const WeightedField& w = weighted[k];
            mesh.result = points_of(w, reading, reach);
            mesh.low = w.low;
            mesh.high = w.high;
            mesh.height = w.laid_out->layout.height;
            for (double& z : mesh.height) z *= reach.unit;
            mesh.field_force =
                integral(w, w.laid_out->normal, reading, reach).value_or(0) * reading.sign;
            if (const auto stress = integral(w, field.find(Meaning::stress_zz), reading, reach))
                mesh.stress_force = std::abs(*stress);
            for (const SurfacePoint& p : mesh.result.points)
                if (p.values.pressure > mesh.peak_pressure) mesh.peak_pressure = p.values.pressure;
        }
        std::vector<Convention> said;
        read_totals(mesh, field, reach, reference, said);
        if (k + 1 == submission.meshes.size())
            out.conventions.insert(out.conventions.end(), said.begin(), said.end());
        const auto cpu = field.totals.find("cpu_time");
        if (cpu != field.totals.end()) mesh.result.cpu_time = cpu->second.value;
        mesh.result.size = mesh_size(field, mesh.result, reach.unit);
        out.meshes.push_back(std::move(mesh));
    }
    std::ranges::stable_sort(out.meshes, std::greater<>(),
                             [](const UnderstoodMesh& m) { return m.result.size; });
    for (UnderstoodMesh& mesh : out.meshes)
        for (SurfacePoint& p : mesh.result.points) p.area *= reach.parts();
    if (!laid_out.empty()) turn_to_reference(out, reference, reach);
    return out;
}

}  // namespace tricontact::benchmarks

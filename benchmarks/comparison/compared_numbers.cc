#include "benchmarks/comparison/compared_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "benchmarks/comparison/explained.h"
#include "benchmarks/comparison/explained_pressing.h"
#include "benchmarks/reference/quantity_units.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double unknown = std::numeric_limits<double>::infinity();

const char* const smooth = "1 to 2: resultants of smooth elements";

/// Where a resultant's order is not expected.
struct OrderOfKey {
    const char *key, *order;
};
const std::array other_orders{
    OrderOfKey{keys::contact_radius, "1 to 3/2: the edge's error on its own load"},
    OrderOfKey{keys::peak_pressure, "1 to 2: away from the contact's edge"},
    OrderOfKey{keys::contact_area, "1: counted in elements"},
    OrderOfKey{keys::stick_area, "1: counted in elements"},
    OrderOfKey{keys::dissipation, "1: of the steps"},
    OrderOfKey{keys::shift_increment, "1: counted in elements"},
    OrderOfKey{keys::stick_ratio, "1: counted in elements"},
    OrderOfKey{keys::pressure_at_axis, "1 to 2: away from the edge"},
    OrderOfKey{keys::pressure_at_0_9, "1/2 or better: beside a singular edge"}};

/// What a quantity's number of a field is, behind its title.
std::string_view how_found(std::string_view key) {
    if (key == keys::contact_radius) return ", by the second moment of p";
    if (key == keys::pressure_at_axis) return ", fitted inside .3 a";
    if (key == keys::peak_pressure) return ", fitted inside .3 a";
    return {};
}

constexpr std::array decisive{keys::normal_force,    keys::indentation,     keys::tangential_force,
                              keys::shift,           keys::static_shift,    keys::settled_shift,
                              keys::shift_increment, keys::shakedown_limit, keys::torque,
                              keys::creepage};

/// Ratios that a problem is about.
const std::array decisive_targets{keys::stick_ratio,
                                  keys::creepage_ratio,
                                  keys::shift_ratio,
                                  keys::increment_ratio,
                                  keys::stiffness_ratio,
                                  keys::settled_shift_ratio,
                                  keys::c11,
                                  keys::c22,
                                  keys::c23,
                                  keys::c33,
                                  keys::von_mises_ratio,
                                  keys::von_mises_depth_ratio,
                                  keys::edge_exponent};

std::string percent(double share) {
    return 100 * share < 100 ? fmt::format("{:.2g} %", 100 * share)
                             : fmt::format("{:.0f} %", 100 * share);
}

/// Differences of the values from the reference: relative, or as they stand of norms.
double relative(const ComparedNumber& n, double value) {
    return n.is_norm ? value : value / n.reference.value - 1;
}

struct Term {
    double size;
    std::string blame, remedy;
};

void name_the_blame(ComparedNumber& n, std::size_t n_meshes, const MeshFamily& family,
                    double reference_bar, double explained_bar) {
    if (n.standing != Standing::not_resolved) return;
    if (!std::isfinite(n.discretisation)) {
        n.blame = n_meshes < 2 ? "one mesh has no error bar"
                               : "the meshes are no family: " + family.why_not;
        n.remedy = n_meshes < 2
                       ? "give three meshes, each half as fine as the next"
                       : "use meshes that are finer by one factor in every direction, as a "
                         "deck's are";
        return;
    }
    std::vector<Term> terms{
        {n.discretisation, fmt::format("the meshes leave {}", percent(n.discretisation)),
         n_meshes < 3 ? "one more mesh, half as fine in every direction"
                      : "one or two finer meshes of the same family"},
        {reference_bar, fmt::format("the reference is known to {}", percent(reference_bar)),
         "a larger tolerance, or a finer reference"},
        {explained_bar,
         fmt::format("what explains the difference is known to {}", percent(explained_bar)),
         "a stiffer penalty, or contact on the undeformed surface: then less has to be explained"}};
    const Term& worst = *std::ranges::max_element(terms, {}, &Term::size);
    n.blame = worst.blame;
    n.remedy = worst.remedy;
}

ComparedNumber named(const std::string& key, const Reference& reference) {
    ComparedNumber n;
    n.key = key;
    const auto own = reference.titles.find(key);
    n.title = own != reference.titles.end()
                  ? own->second
                  : std::string(title_of_quantity(key)) + std::string(how_found(key));
    n.unit = usual_unit(key, reference.geometry).base;
    const auto other = std::ranges::find(
        other_orders, key, [](const OrderOfKey& one) { return std::string(one.key); });
    n.expected_order = other == other_orders.end() ? smooth : other->order;
    return n;
}

/// The value of a mesh that counts for a quantity: the code's own total, else from its field.
std::optional<double> value_of(const std::string& key, const UnderstoodMesh& mesh,
                               const std::vector<FieldNumber>& of_field) {
    const auto total = mesh.result.totals.find(key);
    if (total != mesh.result.totals.end()) return total->second;
    const auto found = std::ranges::find(of_field, key, &FieldNumber::key);
    if (found != of_field.end() && std::isfinite(found->value)) return found->value;
    return {};
}

/// The same of a ratio: what the code states, else from the number that it is made of.
std::optional<double> ratio_or_value(const std::string& key, const UnderstoodMesh& mesh,
                                     const std::vector<FieldNumber>& of_field,
                                     const Reference& reference) {
    if (const auto value = value_of(key, mesh, of_field)) return value;
    const auto ratio = reference.ratios.find(key);
    if (ratio != reference.ratios.end()) {
        const auto over = value_of(ratio->second.numerator, mesh, of_field);
        return over ? std::optional(std::abs(*over) / ratio->second.denominator) : std::nullopt;
    }
    if (key != keys::stick_ratio) return {};
    const auto stick = value_of(keys::stick_area, mesh, of_field),
               contact = value_of(keys::contact_area, mesh, of_field);
    if (!stick || !contact || !(*contact > 0) || !(*stick >= 0)) return {};
    const double share = *stick / *contact;
    return reference.geometry == Geometry::plane ? share : std::sqrt(share);
}

}  // namespace

Standing standing_of(double difference, double uncertainty, double tolerance) {
    if (std::abs(difference) + uncertainty <= tolerance) return Standing::pass;
    if (std::abs(difference) - uncertainty > tolerance) return Standing::fail;
    return Standing::not_resolved;
}

bool is_decisive(const ComparedNumber& number, const Tolerances& tolerances) {
    return tolerances.of.contains(number.key) ||
           std::ranges::find(decisive, number.key) != decisive.end() ||
           std::ranges::find(decisive_targets, number.key) != decisive_targets.end();
}

void judge(ComparedNumber& n, const std::vector<double>& sizes, const MeshFamily& family) {
    std::vector<double> h, values;
    for (std::size_t k = 0; k < sizes.size(); ++k)
        if (n.values[k]) {
            h.push_back(sizes[k]);
            values.push_back(relative(n, *n.values[k]));
        }
    if (values.empty()) return;
    const double scale = n.is_norm ? 1 : std::abs(n.reference.value);
    const double reference_bar = n.reference.bar() / scale;
    n.finest = n.difference = values.back();
    n.discretisation = unknown;
    if (values.size() >= 3 && family.is_family) {
        // A hundredth of a tolerance decides nothing, nor does what the reference leaves.
        const double noise = std::max(reference_bar, 1e-3 * n.tolerance);
        n.limit = comparisons::estimate_limit(h, values, noise);
        // A norm is never negative, though an extrapolation may be.
        n.difference = n.is_norm ? std::max(0., n.limit->value) : n.limit->value;
        n.discretisation = n.limit->error;
    } else if (values.size() == 2 && h[0] > 1.02 * h[1]) {
        n.discretisation = comparisons::value_of_levels(h, values).error;
    }
    double explained_bar = 0;
    for (const Explained& e : n.explained) explained_bar = std::hypot(explained_bar, e.bar);
    const double without = std::hypot(n.discretisation, reference_bar);
    n.uncertainty = std::hypot(without, explained_bar);
    n.unexplained_standing = standing_of(n.difference, without, n.tolerance);
    n.standing = standing_of(n.left(), n.uncertainty, n.tolerance);
    name_the_blame(n, values.size(), family, reference_bar, explained_bar);
}

namespace {

constexpr std::array explained_norms{"load_within", "pressure_l2", "pressure_l2_inside",
                                     "pressure_max_inside", "edge_band"};
constexpr std::array explained_traction_norms{"traction_l2", "traction_load_within"};

/// What explains a norm; empty where nothing does, or coupling leaves too much open.
std::optional<NamedEffect> effect_on(const ComparedNumber& n,
                                     const std::vector<ExplainedField>& fields) {
    if (fields.empty()) return {};
    const auto is_among = [&](const auto& keys) {
        return std::ranges::find(keys, n.key) != keys.end();
    };
    std::optional<NamedEffect> effect;
    if (is_among(explained_norms)) effect = fields.back().of_pressure;
    if (is_among(explained_traction_norms)) effect = fields.back().of_traction;
    return effect && effect->miss <= ExplainedField::most_miss ? effect : std::nullopt;
}

/// A norm is of the difference that is left, not less what is explained: the same beside the
/// reference with the effects, over the same family.
void explain_norm(ComparedNumber& n, const Understanding& all,
                  const std::vector<ExplainedField>& fields, const std::vector<double>& sizes,
                  const MeshFamily& family, const Reference& reference) {
    const auto effect = effect_on(n, fields);
    if (!effect) return;
    ComparedNumber left = n;
    left.values.clear();
    double finest = 0, of_fewer_rings = 0;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto value = [&](const ReferenceSamples& samples) -> std::optional<double> {
            const auto norms = field_norms(all.meshes[k], samples, reference);
            const auto found = std::ranges::find(norms, n.key, &FieldNorm::key);
            return found == norms.end() ? std::nullopt : found->value;
        };
        left.values.push_back(value(fields[k].fine));
        finest = left.values.back().value_or(0);
        of_fewer_rings = value(fields[k].coarse).value_or(0);
    }
    if (!left.values.back()) return;
    judge(left, sizes, family);
    // Pressures on displaced areas are no matter of tractions.
    const bool of_pressure = std::ranges::find(explained_norms, n.key) != explained_norms.end();
    const double bar = std::hypot(finest - of_fewer_rings, of_pressure ? fields.back().bar : 0.,
                                  effect->miss * (n.difference - left.difference));
    n.explained = {{effect->id, effect->title, n.difference - left.difference, bar}};
    n.uncertainty = std::hypot(left.uncertainty, bar);
    n.standing = standing_of(left.difference, n.uncertainty, n.tolerance);
    left.standing = n.standing;  // its meshes are to blame, not those of the whole difference
    left.blame.clear();
    left.remedy.clear();
    name_the_blame(left, n.values.size(), family, n.reference.bar(), bar);
    n.blame = left.blame;
    n.remedy = left.remedy;
}

}  // namespace

std::vector<ComparedNumber> compared_numbers(const Submission& submission, const Understanding& all,
                                             const std::vector<ReferenceSamples>& samples,
                                             const MeshFamily& family, const Reference& reference) {
    std::vector<ComparedNumber> numbers;
    std::vector<double> sizes;
    std::vector<std::vector<FieldNumber>> of_fields;
    std::vector<std::vector<FieldNorm>> norms;
    for (std::size_t k = 0; k < all.meshes.size(); ++k) {
        sizes.push_back(all.meshes[k].result.size);
        of_fields.push_back(samples.empty() ? std::vector<FieldNumber>{}
                                            : field_numbers(all.meshes[k], samples[k], reference));
        norms.push_back(samples.empty() ? std::vector<FieldNorm>{}
                                        : field_norms(all.meshes[k], samples[k], reference));
    }
    const double strain_of_area = strain_of_pressed_area(submission, all, reference);
    for (const std::string_view shown : shown_quantities()) {
        const std::string key(shown);
        const ReferenceValue* value = reference.find(key);
        if (!value || value->value == 0 || !std::isfinite(value->value) ||
            reference.is_prescribed(key))
            continue;
        ComparedNumber n = named(key, reference);
        n.reference = *value;
        for (std::size_t k = 0; k < all.meshes.size(); ++k)
            n.values.push_back(ratio_or_value(key, all.meshes[k], of_fields[k], reference));
        if (!n.values.back()) continue;
        n.tolerance = submission.tolerances.at(key);
        n.explained = explained(key, submission, reference, strain_of_area);
        judge(n, sizes, family);
        numbers.push_back(std::move(n));
    }
    if (norms.empty()) return numbers;
    const auto fields =
        explained_fields(submission, reference, all.meshes, samples, strain_of_area);
    for (const FieldNorm& norm : norms.back()) {
        ComparedNumber n;
        n.key = norm.key;
        n.title = norm.title;
        n.is_norm = true;
        n.expected_order = norm.expected_order;
        n.reference.grid = norm.reference_bar;
        for (const auto& of_mesh : norms) {
            const auto found = std::ranges::find(of_mesh, norm.key, &FieldNorm::key);
            n.values.push_back(found == of_mesh.end() ? std::nullopt : found->value);
        }
        if (!n.values.back()) continue;
        n.tolerance = submission.tolerances.at(norm.key);
        judge(n, sizes, family);
        explain_norm(n, all, fields, sizes, family, reference);
        numbers.push_back(std::move(n));
    }
    return numbers;
}

}  // namespace tricontact::benchmarks

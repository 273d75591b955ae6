#include "benchmarks/problems/target_reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "benchmarks/reference/reference_kinds.h"
#include "contact/base/error.h"
#include "contact/half_space_scales.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;

/// Numbers of problems that no reference computes: only a target has them.
const std::array ratio_keys{keys::stick_ratio,
                            keys::creepage_ratio,
                            keys::shift_ratio,
                            keys::settled_shift_ratio,
                            keys::increment_ratio,
                            keys::stiffness_ratio,
                            keys::von_mises_ratio,
                            keys::von_mises_depth_ratio,
                            keys::c11,
                            keys::c22,
                            keys::c23,
                            keys::c33,
                            keys::force_ratio,
                            keys::displacement,
                            keys::pressure_at_axis,
                            keys::pressure_at_0_9,
                            keys::edge_exponent};

bool is_target_key(const std::string& key) {
    return std::ranges::find(ratio_keys, key) != ratio_keys.end();
}

const Target* solution_of(const Problem& problem, const std::string& key) {
    for (const Target& target : problem.targets)
        if (target.is_solution && target.key == key) return &target;
    return nullptr;
}

/// The number of another program, or of a closed form, beside that of our elements.
void note_target(Reference& reference, const Target& target) {
    const auto found = reference.values.find(target.key);
    if (found == reference.values.end() || reference.is_prescribed(target.key)) return;
    double& difference = found->second.model;
    difference = std::max(difference, std::abs(target.value - found->second.value));
}

/// What the ratios of a problem are over, by closed forms of its case.
std::map<std::string, RatioOf> ratios_of(const Problem& problem, const Reference& reference) {
    const contact::Case& c = reference.c;
    const double a = reference.contact_radius, radius = c.indenter.radius,
                 shear_modulus = c.substrate.young / (2 * (1 + c.substrate.poisson));
    std::map<std::string, RatioOf> ratios{
        {keys::stiffness_ratio, {keys::normal_stiffness, 4 * shear_modulus * a}}};
    if (problem.name == "carter" || problem.name == "carter_two_cylinders")
        ratios[keys::creepage_ratio] = {keys::creepage, c.friction_coefficient() * a / radius};
    if (problem.name == "bentall_johnson")
        ratios[keys::creepage_ratio] = {keys::creepage, a / radius};
    if (c.tractive_rolling && c.tractive_rolling->longitudinal_creepage)
        ratios[keys::c11] = {keys::tangential_force,
                             shear_modulus * a * a * *c.tractive_rolling->longitudinal_creepage};
    const double all_slipping = contact::half_space_scales(c).unit_shift;
    ratios[keys::shift_ratio] = {keys::shift, all_slipping};
    ratios[keys::settled_shift_ratio] = {keys::settled_shift, all_slipping};
    ratios[keys::increment_ratio] = {keys::shift_increment, all_slipping};
    return ratios;
}

}  // namespace

void add_targets(Reference& reference, const Problem& problem) {
    const auto ratios = ratios_of(problem, reference);
    for (const Target& target : problem.targets) {
        if (!target.is_solution) continue;
        if (!is_target_key(target.key)) {
            if (has_finite_body(reference.c)) note_target(reference, target);
            continue;
        }
        reference.values[target.key] = {
            .value = target.value, .grid = target.bar, .source = target.source};
        reference.titles[target.key] = target.title;
        const auto ratio = ratios.find(target.key);
        if (ratio != ratios.end() && std::isfinite(ratio->second.denominator) &&
            ratio->second.denominator > 0)
            reference.ratios[target.key] = ratio->second;
    }
}

void check_stated_targets(const Submission& submission, const Problem* problem) {
    for (const MeshField& mesh : submission.meshes)
        for (const auto& [key, total] : mesh.totals) {
            if (!is_target_key(key) || (problem && solution_of(*problem, key))) continue;
            std::string known;
            if (problem)
                for (const Target& target : problem->targets)
                    if (target.is_solution && is_target_key(target.key))
                        known += (known.empty() ? "" : ", ") + target.key;
            throw contact::InputError(
                total.place + ": " + key + ": " +
                (problem ? "is no target of " + problem->name : "a case file has no such target") +
                (known.empty() ? "; omit it" : "; its targets of this kind are " + known));
        }
}

}  // namespace tricontact::benchmarks

#include "benchmarks/comparison/diagnoses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "benchmarks/comparison/field_sums.h"

namespace tricontact::benchmarks {

namespace {

// Causes that decide come first, then those that explain, then what was found out about the files.
constexpr std::array<DiagnosisRule, 27> rules{locking,
                                              other_parameters,
                                              half_load,
                                              other_load,
                                              no_friction_in_pressing,
                                              penalty,
                                              elastic_slip,
                                              displaced_kinematics,
                                              unknown_kinematics,
                                              finite_strains,
                                              finite_block,
                                              pressed_in_one_step,
                                              facets,
                                              faceted_indenter,
                                              alternating_pressure,
                                              axis_spike_found,
                                              resultant_mismatch,
                                              base_reaction,
                                              bound_violated,
                                              dissimilar_meshes,
                                              edge_between_nodes,
                                              few_elements,
                                              nodal_forces,
                                              part_of_contact,
                                              units_found,
                                              sign_or_axes,
                                              deformed_positions};

}  // namespace

const ComparedNumber* Evidence::find(const std::string& key) const {
    const auto found = std::ranges::find(c.numbers, key, &ComparedNumber::key);
    return found == c.numbers.end() ? nullptr : &*found;
}

double Evidence::peak_pressure() const {
    return peak_of(c.reference);
}

void diagnose(Comparison& c, const Understanding& all, const std::vector<ReferenceSamples>& samples,
              const MeshFamily& family) {
    const Evidence evidence{c, all, samples, family};
    std::vector<Diagnosis> found;
    for (const DiagnosisRule rule : rules)
        if (auto one = rule(evidence)) found.push_back(*one);
    c.diagnoses = found;
    if (found.empty() || found.front().id != "locking") return;
    for (ComparedNumber& n : c.numbers) {
        if (n.is_norm || std::abs(n.finest) <= n.tolerance) continue;
        n.standing = n.unexplained_standing = Standing::fail;
        n.blame = "locking: the finest mesh differs by " + fmt::format("{:.3g} %", 100 * n.finest);
    }
}

}  // namespace tricontact::benchmarks

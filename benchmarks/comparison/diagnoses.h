#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/compared_numbers.h"

namespace tricontact::benchmarks {

/// What diagnoses look at.
struct Evidence {
    const Comparison& c;
    const Understanding& all;
    const std::vector<ReferenceSamples>& samples;
    const MeshFamily& family;

    const UnderstoodMesh& finest() const { return all.meshes.back(); }
    const ComparedNumber* find(const std::string& key) const;
    /// Largest pressure of the reference [Pa].
    double peak_pressure() const;
};

/// Changes below this share of a tolerance are not worth a diagnosis.
inline constexpr double noteworthy_share = .1;

using DiagnosisRule = std::optional<Diagnosis> (*)(const Evidence&);

// Rules, one a diagnosis: what a number shows, with its formula, and what helps. Empty where it
// does not show it.
std::optional<Diagnosis> nodal_forces(const Evidence& e);
std::optional<Diagnosis> part_of_contact(const Evidence& e);
std::optional<Diagnosis> units_found(const Evidence& e);
std::optional<Diagnosis> sign_or_axes(const Evidence& e);
std::optional<Diagnosis> deformed_positions(const Evidence& e);
std::optional<Diagnosis> half_load(const Evidence& e);
std::optional<Diagnosis> other_load(const Evidence& e);
std::optional<Diagnosis> resultant_mismatch(const Evidence& e);
std::optional<Diagnosis> axis_spike_found(const Evidence& e);
std::optional<Diagnosis> alternating_pressure(const Evidence& e);
std::optional<Diagnosis> bound_violated(const Evidence& e);
std::optional<Diagnosis> base_reaction(const Evidence& e);
std::optional<Diagnosis> penalty(const Evidence& e);
std::optional<Diagnosis> elastic_slip(const Evidence& e);
std::optional<Diagnosis> facets(const Evidence& e);
std::optional<Diagnosis> faceted_indenter(const Evidence& e);
std::optional<Diagnosis> displaced_kinematics(const Evidence& e);
std::optional<Diagnosis> unknown_kinematics(const Evidence& e);
std::optional<Diagnosis> finite_strains(const Evidence& e);
std::optional<Diagnosis> finite_block(const Evidence& e);
std::optional<Diagnosis> pressed_in_one_step(const Evidence& e);
std::optional<Diagnosis> no_friction_in_pressing(const Evidence& e);
std::optional<Diagnosis> locking(const Evidence& e);
std::optional<Diagnosis> dissimilar_meshes(const Evidence& e);
std::optional<Diagnosis> edge_between_nodes(const Evidence& e);
std::optional<Diagnosis> few_elements(const Evidence& e);
std::optional<Diagnosis> other_parameters(const Evidence& e);

/// Adds what the rules find. Locking decides: numbers that it makes too stiff fail, however an
/// extrapolation would have it.
void diagnose(Comparison& c, const Understanding& all, const std::vector<ReferenceSamples>& samples,
              const MeshFamily& family);

}  // namespace tricontact::benchmarks

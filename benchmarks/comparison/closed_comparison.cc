#include "benchmarks/comparison/closed_comparison.h"

#include <cmath>
#include <stdexcept>

#include "benchmarks/comparison/exact_comparison.h"
#include "benchmarks/reference/closed_reference.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double alike = 1e-6;

/// Whether the finest mesh states the force of the problem and a depth of its own.
bool is_pressed_by_force(const Submission& submission, const Reference& reference) {
    if (submission.meshes.empty()) return false;
    const auto& totals = submission.meshes.back().totals;
    const auto is_due = [&](const char* key) {
        const auto found = totals.find(key);
        return found != totals.end() && found->second.unit &&
               std::abs(found->second.value / reference.find(key)->value - 1) < alike;
    };
    return totals.contains(keys::indentation) && !is_due(keys::indentation) &&
           is_due(keys::normal_force);
}

Comparison compare_complete_punch(Submission submission) {
    const bool by_force = is_pressed_by_force(submission, complete_punch_reference(false));
    return compare(std::move(submission), complete_punch_reference(by_force));
}

Comparison compare_rounded_punch(Submission submission) {
    return compare(std::move(submission), rounded_punch_plane_reference());
}

Comparison compare_pin_in_hole(Submission submission) {
    return compare(std::move(submission), pin_in_hole_reference());
}

struct ClosedComparison {
    std::string_view name;
    Comparison (*compare)(Submission);
};
constexpr ClosedComparison closed_comparisons[]{{"patch_test", compare_patch_test},
                                                {"wedge", compare_wedge},
                                                {"complete_punch", compare_complete_punch},
                                                {"rounded_punch_plane", compare_rounded_punch},
                                                {"pin_in_hole", compare_pin_in_hole}};

const ClosedComparison* find_comparison(std::string_view problem) {
    for (const ClosedComparison& one : closed_comparisons)
        if (one.name == problem) return &one;
    return nullptr;
}

}  // namespace

bool has_closed_comparison(std::string_view problem) {
    return find_comparison(problem) != nullptr;
}

Comparison compare_closed(Submission submission) {
    const ClosedComparison* found = find_comparison(submission.problem);
    if (!found) throw std::logic_error(submission.problem + " has no closed form to compare");
    return found->compare(std::move(submission));
}

}  // namespace tricontact::benchmarks

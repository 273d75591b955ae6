#include "benchmarks/comparison/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "benchmarks/comparison/compared_numbers.h"
#include "benchmarks/comparison/diagnoses.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

/// The numbers that decide: resultants, paths and what has a tolerance of its own; where there is
/// none of these, as of a field under a prescribed force, all that are no norms, else the load
/// inside r.
std::vector<const ComparedNumber*> deciding(const Comparison& c) {
    std::vector<const ComparedNumber*> found;
    const auto add = [&](const auto& decides) {
        if (!found.empty()) return;
        for (const ComparedNumber& n : c.numbers)
            if (decides(n)) found.push_back(&n);
    };
    add([&](const ComparedNumber& n) { return is_decisive(n, c.submission.tolerances); });
    add([](const ComparedNumber& n) { return !n.is_norm; });
    add([](const ComparedNumber& n) { return n.key == "load_within"; });
    return found;
}

/// Worst of those that decide: one that fails, then one that is not resolved.
template <class StandingOf>
Standing overall(const std::vector<const ComparedNumber*>& numbers,
                 const StandingOf& standing_of_number) {
    bool any = false, open = false;
    for (const ComparedNumber* number : numbers) {
        const ComparedNumber& n = *number;
        any = true;
        if (standing_of_number(n) == Standing::fail) return Standing::fail;
        open = open || standing_of_number(n) == Standing::not_resolved;
    }
    return any && !open ? Standing::pass : Standing::not_resolved;
}

/// What a submission may have a tolerance for.
void check_tolerances(const Comparison& c) {
    for (const auto& [key, tolerance] : c.submission.tolerances.of) {
        const bool is_known =
            std::ranges::find(c.numbers, key, &ComparedNumber::key) != c.numbers.end();
        if (is_known) continue;
        std::string known;
        for (const ComparedNumber& n : c.numbers) known += (known.empty() ? "" : ", ") + n.key;
        throw contact::InputError(fmt::format(
            "tolerance.{}: nothing of this name is compared; compared are {}", key, known));
    }
}

}  // namespace

const char* name_of(Standing standing) {
    constexpr const char* names[] = {"pass", "fail", "not-resolved"};
    return names[static_cast<int>(standing)];
}

double ComparedNumber::explained_change() const {
    double sum = 0;
    for (const Explained& e : explained) sum += e.change;
    return sum;
}

Comparison compare(Submission submission, Reference reference) {
    Comparison c;
    c.name = submission.problem;
    c.title = reference.c.title;
    c.submission = std::move(submission);
    c.reference = std::move(reference);
    const Understanding all = understand(c.submission, c.reference);
    c.conventions = all.conventions;
    std::vector<ReferenceSamples> samples;
    for (const UnderstoodMesh& mesh : all.meshes) {
        c.meshes.push_back(mesh.result);
        if (!mesh.result.points.empty()) samples.push_back(reference_samples(mesh, c.reference));
    }
    const MeshFamily family = mesh_family(c.submission, c.meshes, c.reference);
    c.is_family = family.is_family;
    c.numbers = compared_numbers(c.submission, all, samples, family, c.reference);
    if (c.numbers.empty())
        throw contact::InputError(
            "nothing to compare: the files have neither a field of pressures nor a total that the "
            "case leaves open");
    check_tolerances(c);
    diagnose(c, all, samples, family);
    const auto decide = deciding(c);
    c.standing = overall(decide, [](const ComparedNumber& n) { return n.standing; });
    c.unexplained_standing =
        overall(decide, [](const ComparedNumber& n) { return n.unexplained_standing; });
    for (const ComparedNumber* n : decide)
        if (c.blame.empty() && n->standing == c.standing && !n->blame.empty())
            c.blame = n->title + ": " + n->blame;
    return c;
}

}  // namespace tricontact::benchmarks

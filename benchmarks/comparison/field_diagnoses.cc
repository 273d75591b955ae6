#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "benchmarks/comparison/diagnoses.h"
#include "benchmarks/comparison/field_sums.h"

// Of fields, meshes and files.
namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double large_mismatch = .03, large_bound = .02, large_alternation = .05;
constexpr int least_elements = 4;

const Convention* convention(const Evidence& e, const char* id) {
    const auto found = std::ranges::find(e.c.conventions, id, &Convention::id);
    return found == e.c.conventions.end() ? nullptr : &*found;
}

Diagnosis of_convention(const char* id, const Convention& found, const char* remedy) {
    return {id, found.choice + ": " + found.number, remedy};
}

}  // namespace

std::optional<Diagnosis> nodal_forces(const Evidence& e) {
    const Convention* kind = convention(e, "kind");
    if (!kind || kind->choice.find("nodal forces") == std::string::npos) return {};
    return of_convention("nodal_forces", *kind,
                         "nothing: they were divided by the areas of their nodes; tractions at "
                         "integration points say more near the edge");
}

std::optional<Diagnosis> part_of_contact(const Evidence& e) {
    for (const Convention& c : e.c.conventions)
        if (c.id == "share" && c.choice.starts_with("the force given"))
            return of_convention("share", c, "nothing: it was multiplied; state it to be sure");
    return {};
}

std::optional<Diagnosis> units_found(const Evidence& e) {
    for (const char* id : {"kind", "coordinates"})
        if (const Convention* c = convention(e, id))
            if (c->choice.find("(found)") != std::string::npos)
                return of_convention("units", *c,
                                     "state units in brackets behind names of columns");
    return {};
}

std::optional<Diagnosis> sign_or_axes(const Evidence& e) {
    for (const char* id : {"sign", "axes", "origin"})
        if (const Convention* c = convention(e, id))
            return of_convention("sign_or_axes", *c, "nothing: it was turned to the reference's");
    return {};
}

std::optional<Diagnosis> deformed_positions(const Evidence& e) {
    const Convention* c = convention(e, "deformed");
    if (!c) return {};
    return of_convention("deformed_positions", *c,
                         "write undeformed positions beside displacements");
}

std::optional<Diagnosis> resultant_mismatch(const Evidence& e) {
    const UnderstoodMesh& mesh = e.finest();
    const auto total = mesh.result.totals.find(keys::normal_force);
    if (!mesh.field_force || total == mesh.result.totals.end() || !(total->second > 0)) return {};
    const double mismatch = *mesh.field_force / total->second - 1;
    if (std::abs(mismatch) < large_mismatch) return {};
    std::string stress;
    if (mesh.stress_force)
        stress = fmt::format("; the stress at the surface integrates to {:+.2g} % of it",
                             100 * (*mesh.stress_force / total->second - 1));
    return Diagnosis{"resultant_mismatch",
                     fmt::format("The pressures integrate to {:+.3g} % of the force on the finest "
                                 "mesh: values at nodes are averaged and extrapolated{}",
                                 100 * mismatch, stress),
                     "write tractions at integration points with their areas, or the stress at the "
                     "surface; for axisymmetric models of CalculiX OUTPUT=3D"};
}

std::optional<Diagnosis> axis_spike_found(const Evidence& e) {
    const UnderstoodMesh& mesh = e.finest();
    if (e.samples.empty()) return {};
    const auto spike = axis_spike(mesh, e.c.reference);
    if (spike.empty()) return {};
    double most = 0, at = 0;
    for (const std::size_t i : spike)
        if (std::abs(mesh.result.points[i].values.pressure) > std::abs(most)) {
            most = mesh.result.points[i].values.pressure;
            at = distance(mesh, mesh.result.points[i]);
        }
    return Diagnosis{
        "axis_spike",
        fmt::format("At r = {:.3g} mm, beside the axis, the pressure is {:.2g} p0 among "
                    "values near p0; p0 is fitted without it",
                    1e3 * at, most / e.peak_pressure()),
        "nothing for resultants: the ring at the axis has no area; a half model shows "
        "whether the element or the search for contact makes it"};
}

std::optional<Diagnosis> alternating_pressure(const Evidence& e) {
    const UnderstoodMesh& mesh = e.finest();
    if (e.samples.empty() || mesh.result.geometry == Geometry::spatial) return {};
    const double a = e.c.reference.contact_radius;
    const auto& points = mesh.result.points;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (distance(mesh, points[i]) < .75 * a) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return points[i].x; });
    const auto spike = axis_spike(mesh, e.c.reference);
    std::erase_if(order, [&](std::size_t i) { return std::ranges::find(spike, i) != spike.end(); });
    if (order.size() < 6) return {};
    int n = 0, changes = 0;
    double sum = 0, last = 0;
    for (std::size_t k = 1; k + 1 < order.size(); ++k) {
        const double bend = points[order[k - 1]].values.pressure -
                            2 * points[order[k]].values.pressure +
                            points[order[k + 1]].values.pressure;
        if (k > 1) {
            ++n;
            changes += bend * last < 0;
        }
        sum += bend * bend;
        last = bend;
    }
    const double size = std::sqrt(sum / static_cast<double>(order.size() - 2)) / 4;
    if (changes < .9 * n || size < large_alternation * e.peak_pressure()) return {};
    return Diagnosis{
        "alternating",
        fmt::format("Pressures alternate from point to point by {:.2g} p0: {} of {} second "
                    "differences change their sign",
                    size / e.peak_pressure(), changes, n),
        "another pair of spaces for displacements and pressures, a softer penalty, or "
        "quadratic faces; means over two points may still be right"};
}

std::optional<Diagnosis> bound_violated(const Evidence& e) {
    const ComparedNumber* n = e.find("bound");
    if (!n || n->finest < large_bound) return {};
    return Diagnosis{
        "bound",
        fmt::format("Tangential tractions exceed mu p by up to {:.2g} % of mu p0: they "
                    "are averaged at nodes, or the law of friction is regularised",
                    100 * n->finest),
        "write tractions at integration points"};
}

std::optional<Diagnosis> base_reaction(const Evidence& e) {
    const auto& totals = e.finest().result.totals;
    const auto top = totals.find(keys::normal_force), base = totals.find("balancing_force");
    if (top == totals.end() || base == totals.end() || !(top->second > 0)) return {};
    const double mismatch = base->second / top->second - 1;
    if (std::abs(mismatch) < 1e-3) return {};
    return Diagnosis{
        "equilibrium",
        fmt::format("The reaction of the base is {:+.2g} % of the indenter's force: not "
                    "in equilibrium",
                    100 * mismatch),
        "a stricter tolerance of the solver's iteration, or forces of all nodes"};
}

std::optional<Diagnosis> dissimilar_meshes(const Evidence& e) {
    if (e.family.is_family || e.c.meshes.size() < 3) return {};
    return Diagnosis{
        "family",
        "The meshes are no family, so that no order and no error can be had: " + e.family.why_not,
        "meshes that are finer by one factor in every direction: tricontact benchmark "
        "deck writes them"};
}

std::optional<Diagnosis> edge_between_nodes(const Evidence& e) {
    if (!e.family.is_family || e.family.edges_alike || e.family.edge_places.size() < 3) return {};
    std::string places;
    for (const double p : e.family.edge_places)
        places += (places.empty() ? "" : ", ") + fmt::format("{:.2f}", p);
    return Diagnosis{"edge_places",
                     fmt::format("The contact ends {} of a spacing behind a node, mesh by mesh: "
                                 "observed orders of pressures are accidents",
                                 places),
                     "a family whose elements are parts of the contact's radius"};
}

std::optional<Diagnosis> few_elements(const Evidence& e) {
    const double n = e.c.reference.contact_radius / e.finest().result.size;
    if (!(e.finest().result.size > 0) || n >= least_elements - .01) return {};
    return Diagnosis{"few_elements",
                     fmt::format("The finest mesh has {:.2g} elements in the contact's radius", n),
                     "at least four, better eight: the edge's error acts on the whole below that"};
}

}  // namespace tricontact::benchmarks

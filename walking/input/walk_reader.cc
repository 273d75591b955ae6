#include "walking/input/walk_reader.h"

#include <algorithm>
#include <cmath>

#include "io/case/case_reader.h"
#include "io/case/rig_file.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "walking/input/walk_keys.h"
#include "walking/machine/linear_stability.h"

namespace tricontact::walking {

namespace {

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(WalkCase& c, const io::Document& document) {
    for (const io::Entry& entry : document.entries)
        if (const io::Key* key = walk_key_list().find(entry.path); key && is_dimensional(*key))
            c.dimensional = DimensionalMachine{};
    if (document.find_section("bed")) c.machine.bed = Bed{};
    if (!document.find("contact.diameter")) return;
    c.input.contact = SpotContact{};
    if (document.find("contact.substrate_young") || document.find("contact.substrate_poisson"))
        c.input.contact->substrate = contact::Material{};
}

void derive_spots(WalkCase& c) {
    const auto& [ratio, contact, duration, positions, heights, stiffnesses] = c.input;
    for (std::size_t i = 0; i < positions.size(); ++i)
        c.machine.spots.push_back({.position = positions[i],
                                   .height = heights.empty() ? 0 : heights[i],
                                   .stiffness = stiffnesses.empty() ? 1 : stiffnesses[i]});
}

void derive_kappas(WalkCase& c) {
    if (!c.dimensional) return;
    DimensionalMachine& machine = *c.dimensional;
    if (c.input.height_ratio) machine.lever_arm = *c.input.height_ratio * machine.half_height;
    if (c.input.contact) {
        machine.normal_stiffness = c.input.contact->normal_stiffness();
        machine.tangential_stiffness = c.input.contact->tangential_stiffness();
    }
    c.machine.kappas = kappas_of(machine);
    if (c.input.duration) c.time.end = *c.input.duration / characteristic_time(machine);
}

constexpr double most_steps = 1e12;  // months of computing

// Of kappas that follow from dimensions: what overflowed, or became 0 where it divides.
void check_kappas(const Kappas& k, const io::Document& document) {
    const auto positive = {k.kappa1, k.kappa2, k.kappa3, k.kappa4, k.kappa7};
    const auto is_positive = [](double kappa) { return kappa > 0 && std::isfinite(kappa); };
    if (!std::ranges::all_of(positive, is_positive) || !std::isfinite(k.kappa6) ||
        !std::isfinite(k.kappa8))
        io::refuse(document, "machine.mass",
                   "the dimensionless parameters kappa of this machine leave double precision",
                   "check the units of [machine]");
}

void check_substrate(const io::Document& document) {
    std::string given = "contact.substrate_young", other = "contact.substrate_poisson";
    if (!document.find(given)) std::swap(given, other);
    if (!document.find(given) || document.find(other)) return;
    io::refuse(document, given, "has no effect without " + other + ", which is missing",
               "give " + other + " too, or omit this key");
}

void check_excitation(const Excitation& excitation, const io::Document& document) {
    const bool loaded = excitation.moment > 0 || excitation.force > 0;
    if (loaded && excitation.frequency == 0)
        io::refuse(document, excitation.moment > 0 ? "excitation.moment" : "excitation.force",
                   "sin(omega t) is 0 with excitation.frequency = 0",
                   "give excitation.frequency, in units of sqrt(k_x/m)");
    if (!loaded && excitation.frequency > 0)
        io::refuse(document, "excitation.frequency", "has no effect without a moment or a force",
                   "give excitation.moment or excitation.force, or omit it");
}

void check_start(const WalkCase& c, const io::Document& document) {
    if (c.machine.kappas.kappa6 > 0) return;
    const std::string velocity = c.dimensional ? "machine.base_velocity" : "machine.kappa6";
    for (const auto& [key, value] : {std::pair("start.x_velocity", c.start.x_velocity),
                                     std::pair("start.z_velocity", c.start.z_velocity),
                                     std::pair("start.phi_velocity", c.start.phi_velocity)})
        if (value != 0)
            io::refuse(document, key,
                       "velocities are in units of the base's, and " + velocity + " = 0",
                       "let the base move, or omit this key");
}

void check_time(const WalkCase& c, const io::Document& document) {
    const double stable = stable_step(c.machine);
    if (!(c.time.step < stable))
        io::refuse(document, "time.step",
                   "exceeds the stable limit " + io::rounded(stable) +
                       " of velocity Verlet with these stiffnesses",
                   "take at most " + io::rounded(stable / 20) + ", a twentieth of it");
    const std::string end = io::used(document, "time.end", "time.duration");
    if (c.time.end < c.time.step)
        io::refuse(
            document, end,
            "the run of " + io::rounded(c.time.end) + " characteristic times ends within a step",
            "take a later end or a smaller time.step");
    if (c.time.end / c.time.step > most_steps)
        io::refuse(
            document, end,
            io::rounded(c.time.end / c.time.step) + " steps exceed " + io::rounded(most_steps),
            "take an earlier end or a larger time.step");
}

void check_one_kind(const io::Document& document) {
    const io::Entry *kappa = nullptr, *dimension = nullptr;
    for (const io::Entry& entry : document.entries) {
        const io::Key* key = walk_key_list().find(entry.path);
        if (!key) continue;  // of the rig
        if (!kappa && key->path.starts_with("machine.kappa")) kappa = &entry;
        if (is_dimensional(*key) && !dimension) dimension = &entry;
    }
    if (!kappa || !dimension) return;
    const auto& [earlier, later] = std::minmax(kappa, dimension);
    io::fail(later->place, later->subject(),
             "contradicts " + earlier->subject() + ": a machine has kappas or dimensions",
             "give kappa1 to kappa8, or mass, half_height and so on");
}

void check_spots(const WalkCase& c, const io::Document& document) {
    const auto& [ratio, contact, duration, positions, heights, stiffnesses] = c.input;
    const bool own = c.machine.model == Machine::Model::spots;
    if (own && positions.empty())
        io::fail(document.place_of("spots.positions"), "",
                 "missing key spots.positions: machine.model = \"spots\" has none of its own",
                 "add a section [spots] with positions = [-1, 0, 1]");
    if (!own && !positions.empty())
        io::refuse(document, "spots.positions", "has no effect without machine.model = \"spots\"",
                   "set the model, or omit [spots]");
    for (const auto& [key, list] :
         {std::pair("spots.heights", &heights), std::pair("spots.stiffnesses", &stiffnesses)})
        if (!list->empty() && list->size() != positions.size())
            io::refuse(document, key,
                       "has " + std::to_string(list->size()) + " elements, spots.positions has " +
                           std::to_string(positions.size()),
                       "give one for each spot");
    if (c.machine.bed && c.machine.model == Machine::Model::prism)
        io::refuse(document, "bed.radius", "the spots of a prism have no beds of springs",
                   "take another machine.model, or omit [bed]");
    if (!heights.empty() && std::ranges::min(heights) > 0)
        io::refuse(document, "spots.heights",
                   "all spots are in the air: heights are above the lowest tip, whose height is 0",
                   "subtract " + io::shortest(std::ranges::min(heights)) + " from each");
}

WalkCase resolve(const io::Document& document) {
    if (!io::is_walk_case(document))
        io::fail(document.name + ":1:1", "",
                 "missing section [machine]: no case of the walking machine",
                 "add a section [machine] with its kappas");
    const io::KeyList& keys = walk_key_list();
    io::check_known_of_rig(document, walk_file_keys(), io::walking_rig_keys());
    check_one_kind(document);
    WalkCase c;
    make_optional_parts(c, document);
    for (const WalkKey& key : walk_keys()) io::read_or_default(key, key.field(c), document, keys);
    check_spots(c, document);
    derive_spots(c);
    derive_kappas(c);
    check_substrate(document);
    if (c.dimensional) check_kappas(c.machine.kappas, document);
    check_excitation(c.machine.excitation, document);
    check_start(c, document);
    check_time(c, document);
    return c;
}

}  // namespace

WalkCase parse_walk_case(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides) {
    io::Document document = io::parse_document(text, name);
    io::require_kind(io::FileKind::walking, document);
    io::apply_overrides(document, overrides, walk_file_keys());
    return resolve(document);
}

WalkCase resolve_walk_case(io::Document document, const std::vector<io::Entry>& overrides) {
    io::apply_overrides(document, overrides, walk_file_keys());
    return resolve(document);
}

WalkCase read_walk_case(const std::string& path, const std::vector<std::string>& overrides) {
    return parse_walk_case(io::read_input_file(path), path, overrides);
}

std::string write_walk_case(const WalkCase& c) {
    WalkCase copy = c;  // fields are mutable places; the writer reads a copy
    io::KeyWriter writer;
    for (const WalkKey& key : walk_keys()) writer.add(key, key.field(copy));
    return writer.text();
}

AnyCase read_any_case(const std::string& path, const std::vector<std::string>& overrides) {
    const std::string text = io::read_input_file(path);
    if (io::is_walk_case(io::parse_document(text, path)))
        return parse_walk_case(text, path, overrides);
    return io::parse_case(text, path, overrides);
}

bool is_walk_case_file(const std::string& path) {
    return io::is_walk_case(io::parse_document(io::read_input_file(path), path));
}

}  // namespace tricontact::walking

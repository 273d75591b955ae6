#include "io/walk_reader.h"

#include "io/file_kind.h"
#include "io/input_file.h"
#include "io/key_checks.h"
#include "io/messages.h"
#include "io/overrides.h"
#include "io/walk_checks.h"
#include "io/walk_keys.h"

namespace tricontact::io {

namespace {

using dynamics::DimensionalMachine;
using dynamics::WalkCase;

void check_machine_there(const Document& document) {
    if (is_walk_case(document)) return;
    fail(document.name + ":1:1", "", "missing section [machine]: no case of the walking machine",
         "add a section [machine] with its kappas");
}

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(WalkCase& c, const Document& document) {
    for (const Entry& entry : document.entries)
        if (is_dimensional(*walk_key_list().find(entry.path))) c.dimensional = DimensionalMachine{};
    if (document.find_section("bed")) c.machine.bed = dynamics::Bed{};
    if (!document.find("contact.diameter")) return;
    c.input.contact = dynamics::SpotContact{};
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

WalkCase resolve(const Document& document) {
    check_machine_there(document);
    const KeyList& keys = walk_key_list();
    check_known(document, keys);
    check_one_kind(document);
    WalkCase c;
    make_optional_parts(c, document);
    for (const WalkKey& key : walk_keys()) read_or_default(key, key.field(c), document, keys);
    check_spots(c, document);
    derive_spots(c);
    derive_kappas(c);
    check_walk_case(c, document);
    return c;
}

}  // namespace

bool is_walk_case(const Document& document) {
    return document.find_section("machine") != nullptr;
}

WalkCase parse_walk_case(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides) {
    Document document = parse_document(text, name);
    require_kind(FileKind::walking, document);
    apply_overrides(document, overrides, walk_key_list());
    return resolve(document);
}

WalkCase resolve_walk_case(Document document, const std::vector<Entry>& overrides) {
    apply_overrides(document, overrides, walk_key_list());
    return resolve(document);
}

WalkCase read_walk_case(const std::string& path, const std::vector<std::string>& overrides) {
    return parse_walk_case(read_input_file(path), path, overrides);
}

}  // namespace tricontact::io

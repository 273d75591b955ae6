#include "walking/input/walk_reader.h"

#include "io/case/overrides.h"
#include "io/keys/field_text.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "walking/input/walk_checks.h"
#include "walking/input/walk_keys.h"

namespace tricontact::walking {

namespace {

void check_machine_there(const io::Document& document) {
    if (io::is_walk_case(document)) return;
    io::fail(document.name + ":1:1", "",
             "missing section [machine]: no case of the walking machine",
             "add a section [machine] with its kappas");
}

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(WalkCase& c, const io::Document& document) {
    for (const io::Entry& entry : document.entries)
        if (is_dimensional(*walk_key_list().find(entry.path))) c.dimensional = DimensionalMachine{};
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

WalkCase resolve(const io::Document& document) {
    check_machine_there(document);
    const io::KeyList& keys = walk_key_list();
    io::check_known(document, keys);
    check_one_kind(document);
    WalkCase c;
    make_optional_parts(c, document);
    for (const WalkKey& key : walk_keys()) io::read_or_default(key, key.field(c), document, keys);
    check_spots(c, document);
    derive_spots(c);
    derive_kappas(c);
    check_walk_case(c, document);
    return c;
}

}  // namespace

WalkCase parse_walk_case(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides) {
    io::Document document = io::parse_document(text, name);
    io::require_kind(io::FileKind::walking, document);
    io::apply_overrides(document, overrides, walk_key_list());
    return resolve(document);
}

WalkCase resolve_walk_case(io::Document document, const std::vector<io::Entry>& overrides) {
    io::apply_overrides(document, overrides, walk_key_list());
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

}  // namespace tricontact::walking

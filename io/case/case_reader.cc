#include "io/case/case_reader.h"

#include <fmt/format.h>

#include <filesystem>

#include "bem/settings.h"
#include "contact/heat.h"
#include "contact/wearing_contact.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"
#include "io/case/rig_file.h"
#include "io/case/rig_keys.h"
#include "io/keys/input_file.h"

namespace tricontact::io {

namespace {

using contact::Case;

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(Case& c, const Document& document) {
    if (document.find("indenter.young")) c.indenter.material = contact::Material{};
    if (document.find("indenter.length")) c.indenter.length = 1;  // until it is read
    if (document.find("indenter.body")) c.indenter.body = contact::ElasticBody{};
    if (document.find("indenter.mesh")) {
        if (document.find("indenter.body"))
            refuse(document, "indenter.mesh", "indenter.body gives the indenter another body",
                   "keep one of them");
        c.indenter.body = contact::ElasticBody{.form = contact::ElasticBody::Form::mesh};
    }
    c.has_rigid_substrate = document.find("substrate.rigid");  // until it is read
    if (document.find("substrate.shape"))
        c.substrate_shape = Case::SubstrateShape::hole;  // as well
    make_upper_plate(c, document);
    if (document.find_section("indenter.roughness")) c.indenter.roughness = contact::Roughness{};
    if (document.find_section("substrate.relaxation")) c.relaxation = contact::Relaxation{};
    if (document.find_section("friction.rate")) c.friction.rate = contact::FrictionRate{};
    if (document.find_section("friction.weakening"))
        c.friction.weakening = contact::FrictionWeakening{};
    if (document.find("interface.yield_stress")) c.friction.yield = contact::InterfaceYield{};
    if (document.find_section("indenter.heat") || document.find_section("substrate.heat"))
        c.of<contact::ContactHeat>();
    if (document.find_section("friction.temperature"))
        c.friction.temperature = contact::FrictionTemperature{};
    if (document.find_section("lower_layer")) c.of<LayersInput>().lower.emplace();
    if (document.find_section("ground")) c.layer.ground = contact::Material{};
    if (document.find_section("adhesion")) c.adhesion = contact::Adhesion{};
    if (document.find_section("tractive_rolling")) c.tractive_rolling = Case::TractiveRolling{};
    if (document.find_section("path")) c.of<PathInput>();
    for (const char* key : oscillation_keys)
        if (document.find(key)) c.of<OscillationInput>();
    if (document.find_section("wear")) c.of<contact::Wear>();
    if (!document.find_section("rolling")) return;
    c.rolling = Case::Rolling{};
    if (document.find("rolling.speed")) c.rolling->speed = 1;
    if (document.find("rolling.increment")) c.rolling->steps = Case::Steps::increment;
    if (document.find("rolling.steps")) c.rolling->steps = Case::Steps::turning_points;
}

// A relative file name is meant from the folder of the case file, one of an override from the
// working directory. Absolute, it survives in a resolved case that stands elsewhere.
std::string absolute_path(const std::string& path, const Entry& entry, const Document& document) {
    namespace fs = std::filesystem;
    if (path.empty())
        fail(entry.place, entry.subject(), "names no file", "name one, or omit this key");
    const fs::path folder = entry.overridden ? fs::path() : fs::path(document.name).parent_path();
    std::error_code error;
    const fs::path absolute = fs::absolute(folder / path, error);
    return error ? path : absolute.lexically_normal().string();
}

void make_paths_absolute(Case& c, const Document& document) {
    const auto make_absolute = [&](std::optional<std::string>& path, const char* key) {
        if (path) path = absolute_path(*path, *document.find(key), document);
    };
    auto& mesh = c.of<fem::Settings>().mesh;
    auto& influence = c.of<bem::Settings>().influence;
    make_absolute(mesh, "fem.mesh");
    make_absolute(influence, "bem.influence");
    std::string& cache = c.of<fem::Settings>().cache;
    if (!cache.empty() && cache != "none")
        cache = absolute_path(cache, *document.find("fem.cache"), document);
    make_absolute(c.indenter.file, "indenter.file");
    if (c.indenter.body) {
        make_absolute(c.indenter.body->mesh, "indenter.mesh");
        if (c.indenter.body->mesh) note_input_file(*c.indenter.body->mesh);
    }
    make_absolute(c.friction.map_file, "friction.map");
    if (c.kept.find<PathInput>()) make_absolute(c.of<PathInput>().file, "path.file");
    make_absolute(c.of<RelaxationInput>().dma, "substrate.relaxation.dma");
    make_absolute(c.of<RelaxationInput>().test, "substrate.relaxation.test");
    for (const auto* file : {&mesh, &influence})  // the models read them
        if (*file) note_input_file(**file);
}

Case resolve(const Document& document) {
    const KeyList& keys = case_key_list();
    check_known_of_rig(document, case_file_keys(), rolling_rig_keys());
    Case c;
    make_optional_parts(c, document);
    const CaseKey& shape = *find_key("indenter.shape");  // other keys depend on it
    read_or_default(shape, shape.field(c), document, keys);
    check_indenter_keys(c, document);
    for (const CaseKey& key : case_keys()) read_or_default(key, place_of(key, c), document, keys);
    if (c.has_rigid_substrate) c.substrate = contact::rigid_material;
    make_paths_absolute(c, document);
    // There is friction if it is asked for, see check_hole(), check_bodies().
    if ((c.has_hole() || document.find_section("upper_plate")) &&
        !document.find("contact.coupling"))
        c.contact.coupling = false;
    check_bodies(c, document);
    resolve_oscillation(c, document);
    resolve_path(c, document);
    resolve_height_map(c, document);
    resolve_lower_layers(c, document);
    resolve_relaxation(c, document);
    resolve_indenter_file(c, document);
    resolve_friction_map(c, document);
    resolve_thickness(c, document);
    c.kept.reset<LayersInput>();
    check_case(c, document);
    return c;
}

Entry entry_of(const std::string& text) {
    if (first_non_utf8(text) != std::string::npos)
        fail("--set", "", "the text is not UTF-8", "use a terminal in UTF-8");
    const std::string place = "--set " + shortened(text, 80);
    const auto equals = text.find('=');
    const std::string path(trimmed(std::string_view(text).substr(0, equals)));
    if (equals == std::string::npos || path.empty())
        fail(place, "", "is not of the form key=value",
             "write for example --set load.tangential_ratio=0.3");
    const std::string value(trimmed(std::string_view(text).substr(equals + 1)));
    return overriding(path, parse_value(value), place);
}

void erase_from_file(Document& document, std::string_view path) {
    std::erase_if(document.entries,
                  [&](const Entry& entry) { return entry.path == path && !entry.overridden; });
}

void erase_alternatives(Document& document, const Key& key, const KeyList& keys) {
    for (const Key* other : keys.alternatives(key)) {
        if (other == &key) continue;
        erase_from_file(document, other->path);
        if (key.stands_for == other->path) continue;
        for (const Key* hanging : keys.keys())
            if (hanging->needs == other->path) erase_from_file(document, hanging->path);
    }
}

void put(Document& document, Entry entry, const KeyList& keys) {
    const Entry* old = document.find(entry.path);
    if (old && old->overridden)
        fail(entry.place, entry.subject(), "is set twice", "keep one of the two --set");
    erase_from_file(document, entry.path);
    if (const Key* key = keys.find(entry.path)) erase_alternatives(document, *key, keys);
    const std::string section(section_of(entry.path));
    if (!section.empty() && !document.find_section(section))
        document.sections.push_back({section, entry.place});
    document.entries.push_back(std::move(entry));
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides) {
    Document document = parse_document(text, name);
    require_kind(FileKind::contact, document);
    apply_overrides(document, overrides, case_file_keys());
    return resolve(document);
}

Case resolve_case(Document document, const std::vector<Entry>& overrides) {
    apply_overrides(document, overrides, case_file_keys());
    return resolve(document);
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides,
               const std::vector<std::string>& models) {
    std::vector<std::string> all = overrides;
    if (!models.empty()) all.push_back(fmt::format("models=[\"{}\"]", fmt::join(models, "\", \"")));
    return parse_case(read_input_file(path), path, all);
}

std::string write_case(const contact::Case& c) {
    contact::Case copy = c;  // fields are mutable places; the writer reads a copy
    state_relaxation(copy);
    state_lower_layers(copy);
    KeyWriter writer;
    for (const CaseKey& key : case_keys()) writer.add(key, place_of(key, copy));
    return writer.text();
}

void apply_overrides(Document& document, const std::vector<std::string>& overrides,
                     const KeyList& keys) {
    for (const std::string& text : overrides) put(document, entry_of(text), keys);
}

void apply_overrides(Document& document, const std::vector<Entry>& overrides, const KeyList& keys) {
    for (Entry entry : overrides) {
        entry.overridden = true;
        put(document, std::move(entry), keys);
    }
}

}  // namespace tricontact::io

#include "io/case/case_reader.h"

#include <fmt/format.h>

#include <filesystem>

#include "io/case/case_checks.h"
#include "io/case/case_keys.h"
#include "io/case/indenter_keys.h"
#include "io/case/overrides.h"
#include "io/case/relaxation_input.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

namespace {

using contact::Case;

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(Case& c, const Document& document) {
    if (document.find("indenter.young")) c.indenter.material = contact::Material{};
    if (document.find_section("indenter.roughness")) c.indenter.roughness = contact::Roughness{};
    if (document.find_section("substrate.relaxation")) c.relaxation = contact::Relaxation{};
    if (document.find_section("lower_layer")) c.lower_layers_input = Case::LowerLayersInput{};
    if (document.find_section("ground")) c.layer.ground = contact::Material{};
    if (document.find_section("tractive_rolling")) c.tractive_rolling = Case::TractiveRolling{};
    if (!document.find_section("rolling")) return;
    c.rolling = Case::Rolling{};
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
    if (c.fem.mesh) c.fem.mesh = absolute_path(*c.fem.mesh, *document.find("fem.mesh"), document);
    if (c.bem.influence)
        c.bem.influence =
            absolute_path(*c.bem.influence, *document.find("bem.influence"), document);
    if (!c.fem.cache.empty() && c.fem.cache != "none")
        c.fem.cache = absolute_path(c.fem.cache, *document.find("fem.cache"), document);
    if (c.indenter.file)
        c.indenter.file =
            absolute_path(*c.indenter.file, *document.find("indenter.file"), document);
    if (auto& dma = c.relaxation_input.dma)
        dma = absolute_path(*dma, *document.find("substrate.relaxation.dma"), document);
    for (const auto* file : {&c.fem.mesh, &c.bem.influence})  // the models read them
        if (*file) note_input_file(**file);
}

Case resolve(const Document& document) {
    const KeyList& keys = case_key_list();
    check_known(document, keys);
    Case c;
    make_optional_parts(c, document);
    const CaseKey& shape = *find_key("indenter.shape");  // other keys depend on it
    read_or_default(shape, shape.field(c), document, keys);
    check_indenter_keys(c, document);
    for (const CaseKey& key : case_keys()) read_or_default(key, key.field(c), document, keys);
    make_paths_absolute(c, document);
    resolve_height_map(c, document);
    resolve_lower_layers(c, document);
    resolve_relaxation(c, document);
    resolve_indenter_file(c, document);
    check_case(c, document);
    return c;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides) {
    Document document = parse_document(text, name);
    require_kind(FileKind::contact, document);
    apply_overrides(document, overrides, case_key_list());
    return resolve(document);
}

Case resolve_case(Document document, const std::vector<Entry>& overrides) {
    apply_overrides(document, overrides, case_key_list());
    return resolve(document);
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides,
               const std::vector<std::string>& models) {
    std::vector<std::string> all = overrides;
    if (!models.empty()) all.push_back(fmt::format("models=[\"{}\"]", fmt::join(models, "\", \"")));
    return parse_case(read_input_file(path), path, all);
}

}  // namespace tricontact::io

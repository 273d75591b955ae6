#include "benchmarks/submissions/read_field.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/dat_totals.h"
#include "benchmarks/submissions/frd_file.h"
#include "benchmarks/submissions/own_surface.h"
#include "benchmarks/submissions/rpt_file.h"
#include "benchmarks/submissions/surface_field.h"
#include "benchmarks/submissions/table_field.h"
#include "benchmarks/submissions/vtk_file.h"
#include "contact/base/error.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/results/surface_file.h"
#include "io/tables/divided_text.h"

namespace tricontact::benchmarks {

namespace {

std::string ending_of(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

std::string text_of(const std::string& file, const std::string& kind) {
    return io::utf8_text(io::read_input_file(file, kind, most_megabytes), file);
}

/// The mesh of the set, or the only one with contact values.
const MeshData& chosen(const std::vector<MeshData>& meshes, const std::string& set,
                       const std::string& file, std::vector<std::string>& notes) {
    const auto name_of = [](const MeshData& mesh) { return mesh.name; };
    if (!set.empty()) {
        const auto found = std::ranges::find(meshes, set, &MeshData::name);
        if (found == meshes.end())
            io::fail(file, "", "has no set " + io::toml_string(set),
                     "known are " + io::joined(meshes, name_of));
        return *found;
    }
    std::vector<const MeshData*> with;
    for (const MeshData& mesh : meshes)
        if (has_contact_values(mesh)) with.push_back(&mesh);
    if (with.size() > 1)
        io::fail(file, "",
                 "several sets have contact values: " +
                     io::joined(with, [](const MeshData* mesh) { return mesh->name; }),
                 "name one: set = " + io::toml_string(with[0]->name));
    const MeshData& mesh = with.empty() ? meshes.front() : *with.front();
    if (meshes.size() > 1) notes.push_back("set " + io::toml_string(mesh.name) + " is read");
    return mesh;
}

/// What a second file states.
void add_totals(MeshField& field, const std::string& file, const std::string& axes) {
    for (const auto& [key, total] : read_totals(file, field.notes, axes))
        if (!field.totals.emplace(key, total).second)
            io::fail(file, key, "stands also in the field's file", "keep one of both");
}

/// The .dat that CalculiX writes beside an .frd.
std::string print_beside(const std::string& frd) {
    const auto dat = std::filesystem::path(frd).replace_extension(".dat");
    std::error_code ignored;
    return std::filesystem::is_regular_file(dat, ignored) ? dat.string() : std::string();
}

MeshField read_frd(const FieldSource& source) {
    const FrdFile frd = parse_frd(text_of(source.file, "result file of CalculiX"), source.file);
    MeshField field{.file = source.file, .format = "CalculiX frd", .notes = frd.notes};
    const MeshData& mesh = chosen(frd.meshes, source.set, source.file, field.notes);
    const std::string axes = add_surface(field, mesh, source.file);
    if (!source.totals.empty()) {
        add_totals(field, source.totals, axes);
    } else if (const std::string beside = print_beside(source.file); !beside.empty()) {
        try {
            add_totals(field, beside, axes);
            field.notes.push_back("resultants are read from " + beside);
        } catch (const contact::InputError& why) {  // nobody named it
            field.notes.push_back(std::string("no resultants: ") + why.what());
        }
    }
    // Along r the set of a rigid indenter carries what holds its nodes.
    if (mesh.is_axisymmetric) field.totals.erase(quantity_keys::tangential_force);
    return field;
}

MeshField read_mesh_file(const FieldSource& source) {
    MeshField field{.file = source.file, .format = ending_of(source.file).substr(1)};
    const std::vector<MeshData> meshes = read_vtk(source.file, field.notes);
    add_surface(field, chosen(meshes, source.set, source.file, field.notes), source.file);
    if (!source.totals.empty()) add_totals(field, source.totals, {});
    return field;
}

MeshField read_rpt(const FieldSource& source) {
    const std::string text = text_of(source.file, "report of Abaqus");
    MeshField field = is_field_report(text) ? parse_rpt(text, source.file, source.set)
                                            : parse_table(text, source.file);
    if (!source.totals.empty()) add_totals(field, source.totals, {});
    return field;
}

MeshField read_table(const FieldSource& source) {
    const std::string text = text_of(source.file, "table of a contact's field");
    if (is_calculix_print(text))
        io::fail(source.file, "", "holds resultants of CalculiX, and values without positions",
                 "name the .frd file as the field, and this one as totals");
    if (!source.set.empty())
        io::fail(source.file, "set = " + io::toml_string(source.set),
                 "a table of columns has no sets", "omit it");
    MeshField field = parse_table(text, source.file);
    if (!source.totals.empty()) add_totals(field, source.totals, {});
    return field;
}

}  // namespace

std::map<std::string, Total> read_totals(const std::string& file, std::vector<std::string>& notes,
                                         const std::string& axes) {
    const std::string text = text_of(file, "file of resultants");
    if (is_field_report(text)) return parse_rpt_totals(text, file);
    return is_calculix_print(text) ? parse_dat(text, file, axes, notes) : parse_totals(text, file);
}

MeshField read_field(const FieldSource& source) {
    const std::string ending = ending_of(source.file);
    if (io::is_state_series(source.file)) {
        MeshField field = read_own_surface(source.file);
        if (!source.totals.empty()) add_totals(field, source.totals, {});
        return field;
    }
    if (ending == ".csv" || ending == ".txt" || ending == ".dat") return read_table(source);
    if (ending == ".frd") return read_frd(source);
    if (ending == ".rpt") return read_rpt(source);
    if (is_vtk_ending(ending)) return read_mesh_file(source);
    io::fail(source.file, "", "unknown kind of file",
             "known are .csv .txt .frd .rpt, .vtu .vtp .vtk .pvtu .pvd, .e .exo, .case, .cgns, "
             ".vtkhdf");
}

}  // namespace tricontact::benchmarks

#include "benchmarks/decks/inp_text.h"

#include <fmt/format.h>

#include <iterator>

namespace tricontact::benchmarks {

namespace {

// Numbers of a list, so many to a line, which ends in a comma where the list goes on.
template <class Numbers>
void write_list(std::string& text, const Numbers& numbers, int per_line) {
    int column = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool is_last = i + 1 == numbers.size();
        fmt::format_to(std::back_inserter(text), "{}{}", numbers[i] + 1, is_last ? "\n" : ",");
        if (++column == per_line && !is_last) {
            text += '\n';
            column = 0;
        }
    }
}

void write_elements(std::string& text, const DeckMesh& mesh, const std::string& element, int first,
                    int last, const char* set) {
    if (first == last) return;
    fmt::format_to(std::back_inserter(text), "*ELEMENT, TYPE={}, ELSET={}\n", element, set);
    for (int e = first; e < last; ++e) {
        fmt::format_to(std::back_inserter(text), "{},", e + 1);
        write_list(text, mesh.elements[e], 15);
    }
}

}  // namespace

void write_inp_mesh(std::string& text, const DeckMesh& mesh, const std::string& element) {
    const auto out = std::back_inserter(text);
    text += "*NODE, NSET=NALL\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const DeckMesh::Point& p = mesh.nodes[i];
        fmt::format_to(out, "{},{:.10g},{:.10g}", i + 1, p[0], p[1]);
        if (mesh.dimension == 3) fmt::format_to(out, ",{:.10g}", p[2]);
        text += '\n';
    }
    write_elements(text, mesh, element, 0, mesh.n_body_elements, "EBODY");
    write_elements(text, mesh, element, mesh.n_body_elements, mesh.n_elements(), "EIND");
    for (const auto& [name, nodes] : mesh.node_sets) {
        fmt::format_to(out, "*NSET, NSET={}\n", name);
        write_list(text, nodes, 10);
    }
    for (const auto& [name, faces] : mesh.surfaces) {
        fmt::format_to(out, "*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
        for (const ElementFace& face : faces)
            fmt::format_to(out, "{}, S{}\n", face.element + 1, face.face);
    }
}

void write_inp_friction(std::string& text, const InpInteraction& interaction, bool is_abaqus) {
    const auto out = std::back_inserter(text);
    // CalculiX takes the slope of the traction over elastic slip, Abaqus the largest elastic slip.
    if (interaction.mu > 0 && is_abaqus)
        fmt::format_to(out, "*FRICTION, ELASTIC SLIP={:.6g}\n{:.9g}\n", interaction.elastic_slip,
                       interaction.mu);
    else if (interaction.mu > 0)
        fmt::format_to(out, "*FRICTION\n{:.9g}, {:.9g}\n", interaction.mu, interaction.stick_slope);
}

void write_inp_contact(std::string& text, const InpInteraction& interaction, bool is_abaqus) {
    const auto out = std::back_inserter(text);
    text += "*SURFACE INTERACTION, NAME=CONTACT\n";
    if (is_abaqus) text += "1.\n";
    fmt::format_to(out, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:.9g}\n",
                   interaction.stiffness);
    write_inp_friction(text, interaction, is_abaqus);
    text += "*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE\nSLAYER, SIND\n";
}

void write_inp_output(std::string& text, const std::vector<std::string>& force_sets,
                      const std::string& moved, bool is_abaqus) {
    const auto out = std::back_inserter(text);
    for (const std::string& set : force_sets)
        fmt::format_to(out, "*NODE PRINT, NSET={}, FREQUENCY=99999, {}\nRF\n", set,
                       is_abaqus ? "TOTALS=YES, SUMMARY=NO" : "TOTALS=ONLY");
    if (!moved.empty()) fmt::format_to(out, "*NODE PRINT, NSET={}, FREQUENCY=99999\nU\n", moved);
    if (is_abaqus) {
        text +=
            "*CONTACT PRINT, SLAVE=SLAYER, MASTER=SIND, FREQUENCY=99999\n"
            "CPRESS, CSHEAR1, CSHEAR2, COPEN\n"
            "*OUTPUT, FIELD, FREQUENCY=99999\n*NODE OUTPUT\nU, RF\n"
            "*ELEMENT OUTPUT\nS\n*CONTACT OUTPUT\nCSTRESS, CDISP, CFORCE\n";
        return;
    }
    // OUTPUT=3D: else contact values of plane elements stand at nodes that the file has not.
    text +=
        "*NODE FILE, OUTPUT=3D, FREQUENCY=99999\nU, RF\n"
        "*EL FILE, OUTPUT=3D, FREQUENCY=99999\nS\n"
        "*CONTACT FILE, FREQUENCY=99999\nCDIS, CSTR\n";
}

}  // namespace tricontact::benchmarks

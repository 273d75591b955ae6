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

}  // namespace tricontact::benchmarks

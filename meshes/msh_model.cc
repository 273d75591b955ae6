#include "meshes/msh_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshes/messages.h"
#include "meshes/msh_cursor.h"
#include "meshes/tetrahedra.h"

namespace tricontact::meshes {

namespace {

constexpr const char* save_again = "save or copy the mesh again";

// `2 1 "contact"`: dimension, group, name.
void read_names(const MshFile& file, MshModel& model) {
    const auto section = file.sections.find("PhysicalNames");
    if (section == file.sections.end()) return;
    MshCursor in(file, section->second, false);
    const std::size_t n = in.next_count("the number of physical names");
    for (std::size_t i = 0; i < n; ++i) {
        const int dimension = in.next<int>("the dimension of a physical name");
        if (dimension < 0 || dimension > 3)
            in.refuse(fmt::format("a physical name of dimension {}, not 0 to 3", dimension),
                      save_again);
        const long group = in.next<int>("the number of a physical name");
        const std::string_view line = in.rest_of_line();
        const auto begin = line.find('"'), end = line.rfind('"');
        if (begin == end)
            in.refuse("a physical name that does not stand between quotes", save_again);
        const std::string name(line.substr(begin + 1, end - begin - 1));
        if (!model.names.emplace(MshModel::Key{dimension, group}, name).second)
            in.refuse(
                fmt::format("a second name of physical group {} of dimension {}", group, dimension),
                "name each group once");
    }
    in.expect_end("the physical names");
}

void sort_nodes(const MshFile& file, MshModel& model) {
    std::ranges::stable_sort(model.nodes, {}, &MshModel::Node::tag);
    const auto twice = std::ranges::adjacent_find(model.nodes, {}, &MshModel::Node::tag);
    if (twice != model.nodes.end())
        fail(file.name, fmt::format("has node {} twice", twice->tag), save_again);
    for (const auto& [tag, position] : model.nodes)
        if (!std::ranges::all_of(position, [](double x) { return std::isfinite(x); }))
            fail(file.name, fmt::format("node {} is at {}", tag, place(position)), save_again);
}

}  // namespace

const MshType* msh_type(int number) {
    static constexpr std::array<MshType, 19> types{{{1, 2, "Line 2"},
                                                    {2, 3, "Triangle 3"},
                                                    {2, 4, "Quadrilateral 4"},
                                                    {3, 4, "Tetrahedron 4"},
                                                    {3, 8, "Hexahedron 8"},
                                                    {3, 6, "Prism 6"},
                                                    {3, 5, "Pyramid 5"},
                                                    {1, 3, "Line 3"},
                                                    {2, 6, "Triangle 6"},
                                                    {2, 9, "Quadrilateral 9"},
                                                    {3, 10, "Tetrahedron 10"},
                                                    {3, 27, "Hexahedron 27"},
                                                    {3, 18, "Prism 18"},
                                                    {3, 14, "Pyramid 14"},
                                                    {0, 1, "Point"},
                                                    {2, 8, "Quadrilateral 8"},
                                                    {3, 20, "Hexahedron 20"},
                                                    {3, 15, "Prism 15"},
                                                    {3, 13, "Pyramid 13"}}};
    return number >= 1 && number <= static_cast<int>(types.size()) ? &types[number - 1] : nullptr;
}

MshModel read_msh_model(const MshFile& file) {
    MshModel model;
    read_names(file, model);
    if (file.old)
        read_old_sections(file, model);
    else
        read_new_sections(file, model);
    sort_nodes(file, model);
    divide_tetrahedra(model);
    return model;
}

}  // namespace tricontact::meshes

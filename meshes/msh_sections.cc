// The sections of gmsh's files: reference manual of gmsh 4.8, chapter "MSH file format".

#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "meshes/msh_cursor.h"
#include "meshes/msh_model.h"

namespace tricontact::meshes {

namespace {

constexpr const char* copy_again = "save or copy the mesh again";

int next_dimension(MshCursor& in) {
    const int dimension = in.next<int>("the dimension of an entity");
    if (dimension < 0 || dimension > 3)
        in.refuse(fmt::format("an entity of dimension {}, not 0 to 3", dimension), copy_again);
    return dimension;
}

const MshType& next_type(MshCursor& in) {
    const int number = in.next<int>("the type of an element");
    const MshType* type = msh_type(number);
    if (!type)
        in.refuse(fmt::format("elements of gmsh's type {}, not of first or second order", number),
                  "use straight hexahedra with 8 nodes (gmsh: Mesh.ElementOrder = 1)");
    return *type;
}

int number_of(const MshType& type) {
    return static_cast<int>(&type - msh_type(1)) + 1;
}

void check_total(const MshCursor& in, std::size_t found, std::size_t announced, const char* what) {
    if (found != announced)
        in.refuse(fmt::format("{} {} where the section announces {}", found, what, announced),
                  copy_again);
}

Point next_position(MshCursor& in) {
    Point position{};
    for (double& x : position) x = in.next<double>("a coordinate of a node");
    return position;
}

/// Entity of version 4.1: tag, point or box, physical groups, what bounds it.
void read_entity(MshCursor& in, int dimension, MshModel& model) {
    const int tag = in.next<int>("the number of an entity");
    const auto [entity, is_new] = model.groups.try_emplace({dimension, tag});
    if (!is_new)
        in.refuse(fmt::format("a second entity {} of dimension {}", tag, dimension), copy_again);
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) in.next<double>("a bound of an entity");
    const std::size_t n_groups = in.next_count("the number of an entity's physical groups");
    for (std::size_t i = 0; i < n_groups; ++i) {
        const long group = in.next<int>("a physical group of an entity");
        entity->second.insert(std::abs(group));  // negative: the other orientation
    }
    if (dimension == 0) return;
    const std::size_t n_bounds = in.next_count("the number of entities that bound one");
    for (std::size_t i = 0; i < n_bounds; ++i) in.next<int>("an entity that bounds one");
}

void read_entities(const MshFile& file, MshModel& model) {
    const auto section = file.sections.find("Entities");
    if (section == file.sections.end()) return;
    MshCursor in(file, section->second);
    std::array<std::size_t, 4> n{};
    for (std::size_t& of_dimension : n) of_dimension = in.next_count("the number of entities");
    for (int dimension = 0; dimension <= 3; ++dimension)
        for (std::size_t i = 0; i < n[dimension]; ++i) read_entity(in, dimension, model);
    in.expect_end("the entities");
}

/// Number of blocks and of all that they hold; least and greatest tag are of no use here.
std::array<std::size_t, 2> next_totals(MshCursor& in) {
    const std::size_t n_blocks = in.next_count("the number of blocks");
    const std::size_t total = in.next_count("the number of nodes or elements");
    in.next<std::size_t>("the least number"), in.next<std::size_t>("the greatest number");
    return {n_blocks, total};
}

void read_nodes(const MshFile& file, MshModel& model) {
    MshCursor in(file, file.sections.at("Nodes"));
    const auto [n_blocks, total] = next_totals(in);
    for (std::size_t block = 0; block < n_blocks; ++block) {
        const int dimension = next_dimension(in);
        in.next<int>("the number of an entity");
        const int parametric = in.next<int>("whether nodes are parametric");
        if (parametric != 0 && parametric != 1)
            in.refuse(fmt::format("nodes parametric by {}, not 0 or 1", parametric), copy_again);
        const std::size_t n = in.next_count("the number of nodes of a block");
        const std::size_t first = model.nodes.size();
        for (std::size_t i = 0; i < n; ++i)
            model.nodes.push_back({in.next<std::size_t>("the number of a node"), {}});
        for (std::size_t i = 0; i < n; ++i) {
            model.nodes[first + i].position = next_position(in);
            for (int k = 0; k < parametric * dimension; ++k)
                in.next<double>("a parameter of a node");
        }
    }
    check_total(in, model.nodes.size(), total, "nodes");
    in.expect_end("the nodes");
}

void read_elements(const MshFile& file, MshModel& model) {
    MshCursor in(file, file.sections.at("Elements"));
    const auto [n_blocks, total] = next_totals(in);
    std::size_t found = 0;
    for (std::size_t block = 0; block < n_blocks; ++block) {
        const int dimension = next_dimension(in);
        const int entity = in.next<int>("the number of an entity");
        const MshType& type = next_type(in);
        if (type.dimension != dimension)
            in.refuse(fmt::format("elements of type \"{}\" in an entity of dimension {}", type.name,
                                  dimension),
                      copy_again);
        const std::size_t n = in.next_count("the number of elements of a block");
        auto& [tags, nodes] = model.elements[{dimension, entity, number_of(type)}];
        for (std::size_t i = 0; i < n; ++i) {
            tags.push_back(in.next<std::size_t>("the number of an element"));
            for (int k = 0; k < type.n_nodes; ++k)
                nodes.push_back(in.next<std::size_t>("a node of an element"));
        }
        found += n;
    }
    check_total(in, found, total, "elements");
    in.expect_end("the elements");
}

/// A number of version 2.2 that counts from 1.
std::size_t next_tag(MshCursor& in, const char* what) {
    const int tag = in.next<int>(what);
    if (tag < 1) in.refuse(fmt::format("{} is {}, below 1", what, tag), copy_again);
    return static_cast<std::size_t>(tag);
}

void read_old_nodes(const MshFile& file, MshModel& model) {
    MshCursor head(file, file.sections.at("Nodes"), false);
    const std::size_t n = head.next_count("the number of nodes");
    MshCursor in = head.after_line();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t tag = next_tag(in, "the number of a node");
        model.nodes.push_back({tag, next_position(in)});
    }
    in.expect_end("the nodes");
}

/// Tags of an element of version 2.2: physical group (0: none), entity, number of partitions,
/// those.
void read_old_element(MshCursor& in, const MshType& type, int n_tags, std::size_t tag,
                      MshModel& model) {
    int group = 0, entity = 0;
    for (int i = 0; i < n_tags; ++i) {
        const int number = in.next<int>("a tag of an element");
        if (i == 0) group = entity = number;
        if (i == 1) entity = number;
        if (i >= 2 && number != 0)
            in.refuse(fmt::format("element {} belongs to a partition", tag),
                      "save the mesh in one piece");
    }
    auto& groups = model.groups[{type.dimension, entity}];
    if (group != 0) groups.insert(std::abs(long{group}));
    auto& [tags, nodes] = model.elements[{type.dimension, entity, number_of(type)}];
    tags.push_back(tag);
    for (int k = 0; k < type.n_nodes; ++k) nodes.push_back(next_tag(in, "a node of an element"));
}

int next_n_tags(MshCursor& in) {
    const int n = in.next<int>("the number of an element's tags");
    if (n < 0) in.refuse(fmt::format("{} tags of an element", n), copy_again);
    return n;
}

/// Text gives type and number of tags for each element, binary for each block of them.
void read_old_elements(const MshFile& file, MshModel& model) {
    MshCursor head(file, file.sections.at("Elements"), false);
    std::size_t n = head.next_count("the number of elements");
    MshCursor in = head.after_line();
    while (n > 0) {
        std::size_t tag = file.binary ? 0 : next_tag(in, "the number of an element");
        const MshType& type = next_type(in);
        const int n_block = file.binary ? in.next<int>("the number of elements of a block") : 1;
        const int n_tags = next_n_tags(in);
        if (n_block < 1 || static_cast<std::size_t>(n_block) > n)
            in.refuse(fmt::format("a block of {} elements where {} are left", n_block, n),
                      copy_again);
        for (int i = 0; i < n_block; ++i) {
            if (file.binary) tag = next_tag(in, "the number of an element");
            read_old_element(in, type, n_tags, tag, model);
        }
        n -= static_cast<std::size_t>(n_block);
    }
    in.expect_end("the elements");
}

}  // namespace

void read_old_sections(const MshFile& file, MshModel& model) {
    read_old_nodes(file, model);
    read_old_elements(file, model);
}

void read_new_sections(const MshFile& file, MshModel& model) {
    read_entities(file, model);
    read_nodes(file, model);
    read_elements(file, model);
}

}  // namespace tricontact::meshes

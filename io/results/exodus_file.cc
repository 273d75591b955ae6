#include "io/results/exodus_file.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tricontact::io {

namespace {

// Exodus II: a schema of Sandia National Laboratories on netCDF (SAND92-2137, revised).
constexpr std::size_t name_length = 65, line_length = 81, word_length = 33;

std::string text_table(const std::vector<std::string>& texts, std::size_t length) {
    std::string out;
    for (const std::string& text : texts) {
        const std::size_t begin = out.size();
        out += text.substr(0, length - 1);
        out.resize(begin + length, '\0');
    }
    return out;
}

NetcdfAttribute text_attribute(std::string name, std::string text) {
    return {std::move(name), NetcdfType::text, std::move(text)};
}

std::string coordinates(const ExodusMesh& mesh, std::size_t axis) {
    std::vector<double> values;
    values.reserve(mesh.points.size());
    for (const auto& point : mesh.points) values.push_back(point.at(axis));
    return big_endian(std::span<const double>(values));
}

/// Lines of at most 80 letters.
std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (; !text.empty(); text.remove_prefix(std::min(text.size(), line_length - 1)))
        lines.emplace_back(text.substr(0, line_length - 1));
    return lines;
}

std::string nodal_name(std::size_t k) {
    return "vals_nod_var" + std::to_string(k);
}
/// Blocks have numbers from 1.
std::string of_block(const char* name, std::size_t block) {
    return name + std::to_string(block);
}
std::string element_name(std::size_t k, std::size_t block) {
    return of_block(("vals_elem_var" + std::to_string(k) + "eb").c_str(), block);
}

/// The numbers of the fields, in their order: nodes' and elements' have numbers of their own.
std::vector<std::size_t> numbers_of(const ExodusNames& names) {
    std::vector<std::size_t> numbers;
    std::size_t n_nodal = 0, n_elements = 0;
    for (const ExodusNames::Field& field : names.fields)
        numbers.push_back(field.is_of_elements ? ++n_elements : ++n_nodal);
    return numbers;
}

std::vector<std::string> fields_at(const ExodusNames& names, bool elements) {
    std::vector<std::string> found;
    for (const ExodusNames::Field& field : names.fields)
        if (field.is_of_elements == elements) found.push_back(field.name);
    return found;
}

class LayoutMaker {
  public:
    LayoutMaker(const ExodusMesh& mesh, const ExodusNames& names, const Provenance& provenance)
        : mesh_(mesh), names_(names), provenance_(provenance) {}

    NetcdfLayout make() {
        add_attributes();
        time_ = layout_.add_dimension("time_step", 0);
        name_ = layout_.add_dimension("len_name", name_length);
        word_ = layout_.add_dimension("len_string", word_length);
        line_ = layout_.add_dimension("len_line", line_length);
        layout_.variables.push_back({"time_whole", NetcdfType::real, {time_}});
        add_mesh();
        add_origin();
        add_fields();
        layout_.place();
        return std::move(layout_);
    }

  private:
    void add(std::string name, NetcdfType type, std::vector<std::uint32_t> dimensions,
             std::string values, std::vector<NetcdfAttribute> attributes = {}) {
        layout_.variables.push_back({std::move(name), type, std::move(dimensions),
                                     std::move(attributes), std::move(values)});
    }
    void add_names(const std::string& variable, const std::string& dimension,
                   const std::vector<std::string>& names) {
        add(variable, NetcdfType::text, {layout_.add_dimension(dimension, names.size()), name_},
            text_table(names, name_length));
    }
    void add_attributes() {
        const auto number = [](std::int32_t value) { return big_endian(value); };
        layout_.attributes = {
            {"api_version", NetcdfType::single, big_endian(5.1f)},
            {"version", NetcdfType::single, big_endian(5.1f)},
            {"floating_point_word_size", NetcdfType::integer, number(8)},
            {"file_size", NetcdfType::integer, number(1)},
            {"maximum_name_length", NetcdfType::integer, number(name_length - 1)},
            {"int64_status", NetcdfType::integer, number(0)},
            text_attribute("title", "Tricontact " + provenance_.program_version),
        };
        layout_.attributes.push_back(text_attribute("tricontact_layout", mesh_.layout));
        layout_.attributes.push_back(
            {"tricontact_grid", NetcdfType::real, big_endian(std::span<const double>(mesh_.grid))});
    }
    void add_mesh() {
        std::size_t n_elements = 0;
        for (const ExodusBlock& block : mesh_.blocks) n_elements += block.size();
        const auto axes = layout_.add_dimension("num_dim", 3);
        nodes_ = layout_.add_dimension("num_nodes", mesh_.points.size());
        layout_.add_dimension("num_elem", n_elements);
        blocks_ = layout_.add_dimension("num_el_blk", mesh_.blocks.size());
        std::vector<std::int32_t> ids, present;
        std::vector<std::string> names;
        for (const ExodusBlock& block : mesh_.blocks) {
            ids.push_back(static_cast<std::int32_t>(ids.size()) + 1);
            present.push_back(1);
            names.push_back(block.name);
        }
        const auto bytes = [](const auto& list) {
            return big_endian(std::span<const std::int32_t>(list));
        };
        add("eb_status", NetcdfType::integer, {blocks_}, bytes(present));
        add("eb_prop1", NetcdfType::integer, {blocks_}, bytes(ids), {text_attribute("name", "ID")});
        add("eb_names", NetcdfType::text, {blocks_, name_}, text_table(names, name_length));
        add("coordx", NetcdfType::real, {nodes_}, coordinates(mesh_, 0));
        add("coordy", NetcdfType::real, {nodes_}, coordinates(mesh_, 1));
        add("coordz", NetcdfType::real, {nodes_}, coordinates(mesh_, 2));
        add("coor_names", NetcdfType::text, {axes, name_},
            text_table({"x", "y", "z"}, name_length));
        for (std::size_t k = 1; k <= mesh_.blocks.size(); ++k) add_block(mesh_.blocks[k - 1], k);
    }
    void add_block(const ExodusBlock& block, std::size_t k) {
        elements_.push_back(layout_.add_dimension(of_block("num_el_in_blk", k), block.size()));
        const auto of_element = layout_.add_dimension(
            of_block("num_nod_per_el", k), static_cast<std::size_t>(block.nodes_per_element));
        add(of_block("connect", k), NetcdfType::integer, {elements_.back(), of_element},
            big_endian(std::span<const std::int32_t>(block.nodes)),
            {text_attribute("elem_type", block.element)});
    }
    void add_origin() {
        const auto four = layout_.add_dimension("four", 4);
        add("qa_records", NetcdfType::text, {layout_.add_dimension("num_qa_rec", 1), four, word_},
            text_table({"Tricontact", provenance_.program_version, "", ""}, word_length));
        std::vector<std::string> lines = lines_of(provenance_.command_line);
        for (std::string& line : lines_of(mesh_.remark)) lines.push_back(std::move(line));
        add("info_records", NetcdfType::text,
            {layout_.add_dimension("num_info", lines.size()), line_},
            text_table(lines, line_length));
    }
    void add_fields() {
        const auto of_nodes = fields_at(names_, false), of_elements = fields_at(names_, true);
        if (!names_.numbers.empty()) {
            add_names("name_glo_var", "num_glo_var", names_.numbers);
            const auto numbers = static_cast<std::uint32_t>(layout_.dimensions.size() - 1);
            add("vals_glo_var", NetcdfType::real, {time_, numbers}, {});
        }
        if (!of_nodes.empty()) add_names("name_nod_var", "num_nod_var", of_nodes);
        if (!of_elements.empty()) {
            add_names("name_elem_var", "num_elem_var", of_elements);
            const auto numbers = static_cast<std::uint32_t>(layout_.dimensions.size() - 1);
            const std::vector<std::int32_t> all(mesh_.blocks.size() * of_elements.size(), 1);
            add("elem_var_tab", NetcdfType::integer, {blocks_, numbers},
                big_endian(std::span<const std::int32_t>(all)));
        }
        const auto numbers = numbers_of(names_);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto& [name, is_byte, is_of_elements] = names_.fields[i];
            const NetcdfType type = is_byte ? NetcdfType::byte : NetcdfType::single;
            if (!is_of_elements) add(nodal_name(numbers[i]), type, {time_, nodes_}, {});
            for (std::size_t k = 1; is_of_elements && k <= elements_.size(); ++k)
                add(element_name(numbers[i], k), type, {time_, elements_[k - 1]}, {});
        }
    }

    const ExodusMesh& mesh_;
    const ExodusNames& names_;
    const Provenance& provenance_;
    NetcdfLayout layout_;
    std::uint32_t time_ = 0, name_ = 0, word_ = 0, line_ = 0, nodes_ = 0, blocks_ = 0;
    std::vector<std::uint32_t> elements_;  // of each block
};

}  // namespace

bool ExodusNames::take(const ExodusFields& state) {
    bool is_new = false;
    for (const auto& field : state.fields()) {
        const auto found = std::ranges::find_if(fields, [&](const Field& one) {
            return one.name == field.name && one.is_of_elements == field.is_of_elements;
        });
        if (found == fields.end()) {
            fields.push_back({field.name, field.is_byte, field.is_of_elements});
            is_new = true;
        } else if (found->is_byte && !field.is_byte) {
            found->is_byte = false;
            is_new = true;
        }
    }
    for (const auto& [name, value] : state.numbers())
        if (std::ranges::find(numbers, name) == numbers.end()) {
            numbers.push_back(name);
            is_new = true;
        }
    return is_new;
}

NetcdfLayout exodus_layout(const ExodusMesh& mesh, const ExodusNames& names,
                           const Provenance& provenance) {
    return LayoutMaker(mesh, names, provenance).make();
}

}  // namespace tricontact::io

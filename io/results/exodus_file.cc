#include "io/results/exodus_file.h"

#include <algorithm>
#include <optional>

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
std::string element_name(std::size_t k) {
    return "vals_elem_var" + std::to_string(k) + "eb1";
}

/// The variable of each field, in their order: nodes' and elements' have numbers of their own.
std::vector<std::string> variables_of(const ExodusNames& names) {
    std::vector<std::string> variables;
    std::size_t n_nodal = 0, n_elements = 0;
    for (const ExodusNames::Field& field : names.fields)
        variables.push_back(field.is_of_elements ? element_name(++n_elements)
                                                 : nodal_name(++n_nodal));
    return variables;
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
        const auto n_elements =
            mesh_.nodes.size() / static_cast<std::size_t>(mesh_.nodes_per_element);
        const auto axes = layout_.add_dimension("num_dim", 3);
        nodes_ = layout_.add_dimension("num_nodes", mesh_.points.size());
        layout_.add_dimension("num_elem", n_elements);
        blocks_ = layout_.add_dimension("num_el_blk", 1);
        elements_ = layout_.add_dimension("num_el_in_blk1", n_elements);
        const auto of_element = layout_.add_dimension(
            "num_nod_per_el1", static_cast<std::size_t>(mesh_.nodes_per_element));
        const std::string one = big_endian(std::int32_t{1});
        add("eb_status", NetcdfType::integer, {blocks_}, one);
        add("eb_prop1", NetcdfType::integer, {blocks_}, one, {text_attribute("name", "ID")});
        add("eb_names", NetcdfType::text, {blocks_, name_}, text_table({mesh_.block}, name_length));
        add("coordx", NetcdfType::real, {nodes_}, coordinates(mesh_, 0));
        add("coordy", NetcdfType::real, {nodes_}, coordinates(mesh_, 1));
        add("coordz", NetcdfType::real, {nodes_}, coordinates(mesh_, 2));
        add("coor_names", NetcdfType::text, {axes, name_},
            text_table({"x", "y", "z"}, name_length));
        add("connect1", NetcdfType::integer, {elements_, of_element},
            big_endian(std::span<const std::int32_t>(mesh_.nodes)),
            {text_attribute("elem_type", mesh_.element)});
    }
    void add_origin() {
        const auto four = layout_.add_dimension("four", 4);
        add("qa_records", NetcdfType::text, {layout_.add_dimension("num_qa_rec", 1), four, word_},
            text_table({"Tricontact", provenance_.program_version, "", ""}, word_length));
        std::vector<std::string> lines = lines_of(provenance_.command_line);
        lines.emplace_back("SI units, z out of the substrate; contact_state 0 open 1 stick 2 slip");
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
            const std::vector<std::int32_t> all(of_elements.size(), 1);
            add("elem_var_tab", NetcdfType::integer, {blocks_, numbers},
                big_endian(std::span<const std::int32_t>(all)));
        }
        const auto variables = variables_of(names_);
        for (std::size_t i = 0; i < variables.size(); ++i) {
            const auto& [name, is_byte, is_of_elements] = names_.fields[i];
            add(variables[i], is_byte ? NetcdfType::byte : NetcdfType::single,
                {time_, is_of_elements ? elements_ : nodes_}, {});
        }
    }

    const ExodusMesh& mesh_;
    const ExodusNames& names_;
    const Provenance& provenance_;
    NetcdfLayout layout_;
    std::uint32_t time_ = 0, name_ = 0, word_ = 0, line_ = 0, nodes_ = 0, blocks_ = 0,
                  elements_ = 0;
};

/// Bytes of a field in single precision.
std::string widened(std::string_view bytes) {
    std::vector<float> values;
    for (const char byte : bytes) values.push_back(static_cast<float>(byte));
    return big_endian(std::span<const float>(values));
}

void put(std::string& record, const NetcdfLayout& layout, const NetcdfVariable& variable,
         std::string_view bytes) {
    std::ranges::copy(
        bytes.substr(0, variable.size),
        record.begin() + static_cast<std::ptrdiff_t>(variable.begin - layout.records_begin));
}

void put_numbers(std::string& record, const NetcdfLayout& layout, const ExodusNames& names,
                 const std::vector<std::pair<std::string, double>>& numbers) {
    if (names.numbers.empty()) return;
    std::vector<double> values(names.numbers.size(), 0.);
    for (const auto& [name, value] : numbers)
        values.at(static_cast<std::size_t>(std::ranges::find(names.numbers, name) -
                                           names.numbers.begin())) = value;
    put(record, layout, *layout.find("vals_glo_var"), big_endian(std::span<const double>(values)));
}

void put_field(std::string& record, const NetcdfLayout& layout, const ExodusNames& names,
               const ExodusNames::Field& field, std::string_view bytes) {
    const auto same = [&](const ExodusNames::Field& one) {
        return one.name == field.name && one.is_of_elements == field.is_of_elements;
    };
    const auto found = std::ranges::find_if(names.fields, same);
    const auto k = static_cast<std::size_t>(found - names.fields.begin());
    const std::string variable = variables_of(names).at(k);
    const bool widens = field.is_byte && !found->is_byte;
    put(record, layout, *layout.find(variable), widens ? widened(bytes) : std::string(bytes));
}

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

std::string exodus_record(const NetcdfLayout& layout, const ExodusNames& names, double time,
                          const ExodusFields& state) {
    std::string record(layout.record_size, '\0');
    put(record, layout, *layout.find("time_whole"), big_endian(time));
    put_numbers(record, layout, names, state.numbers());
    for (const auto& [name, is_byte, is_of_elements, bytes] : state.fields())
        put_field(record, layout, names, {name, is_byte, is_of_elements}, bytes);
    return record;
}

std::string exodus_record(const NetcdfLayout& layout, const ExodusNames& names,
                          const NetcdfLayout& old_layout, const ExodusNames& old_names,
                          std::string_view old_record) {
    std::string record(layout.record_size, '\0');
    const auto old = [&](const std::string& name) {
        const NetcdfVariable& variable = *old_layout.find(name);
        return old_record.substr(variable.begin - old_layout.records_begin, variable.size);
    };
    put(record, layout, *layout.find("time_whole"), old("time_whole"));
    std::vector<std::pair<std::string, double>> numbers;
    if (!old_names.numbers.empty()) {
        const auto values = from_big_endian<double>(old("vals_glo_var"));
        for (std::size_t i = 0; i < values.size(); ++i)
            numbers.emplace_back(old_names.numbers[i], values[i]);
    }
    put_numbers(record, layout, names, numbers);
    const auto variables = variables_of(old_names);
    for (std::size_t i = 0; i < variables.size(); ++i)
        put_field(record, layout, names, old_names.fields[i], old(variables[i]));
    return record;
}

}  // namespace tricontact::io

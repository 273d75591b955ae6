#include "io/results/exodus_record.h"

#include <algorithm>
#include <array>

namespace tricontact::io {

namespace {

constexpr std::array<char, 4096> zeros{};

/// Bytes of a field in single precision.
std::string widened(std::string_view bytes) {
    std::vector<float> values;
    values.reserve(bytes.size());
    for (const char byte : bytes) values.push_back(static_cast<float>(byte));
    return big_endian(std::span<const float>(values));
}

/// The field of the name, most often at the same place; null: the state has none.
const ExodusFields::Field* found_in(const ExodusFields& state, const ExodusNames::Field& name,
                                    std::size_t place) {
    const auto is_it = [&](const ExodusFields::Field& one) {
        return one.name == name.name && one.is_of_elements == name.is_of_elements;
    };
    const auto& fields = state.fields();
    if (place < fields.size() && is_it(fields[place])) return &fields[place];
    const auto found = std::ranges::find_if(fields, is_it);
    return found == fields.end() ? nullptr : &*found;
}

}  // namespace

ExodusRecord::Part ExodusRecord::part_of(const NetcdfLayout& layout,
                                         const NetcdfVariable& variable) const {
    std::uint64_t n_bytes = size_of(variable.type);
    for (std::size_t i = 1; i < variable.dimensions.size(); ++i)
        n_bytes *= layout.dimensions.at(variable.dimensions[i]).length;
    return {variable.begin - layout.records_begin, variable.size, n_bytes};
}

ExodusRecord::ExodusRecord(const NetcdfLayout& layout, ExodusNames names)
    : names_(std::move(names)), size_(layout.record_size) {
    std::vector<Part> parts;
    for (const NetcdfVariable& variable : layout.variables)
        if (layout.is_of_records(variable)) parts.push_back(part_of(layout, variable));
    auto next = parts.begin();
    time_ = *next++;
    if (!names_.numbers.empty()) numbers_ = *next++;
    const auto n_blocks = static_cast<std::ptrdiff_t>(layout.length("num_el_blk"));
    for (const ExodusNames::Field& field : names_.fields) {
        const auto end = next + (field.is_of_elements ? n_blocks : 1);
        fields_.emplace_back(next, end);
        next = end;
    }
}

void ExodusRecord::begin(double time, const std::vector<std::pair<std::string, double>>& numbers) {
    pieces_.clear();
    own_.clear();
    pieces_.push_back(kept(big_endian(time)));
    if (names_.numbers.empty()) return;
    std::vector<double> values(names_.numbers.size(), 0.);
    for (const auto& [name, value] : numbers)
        values.at(static_cast<std::size_t>(std::ranges::find(names_.numbers, name) -
                                           names_.numbers.begin())) = value;
    pieces_.push_back(kept(big_endian(std::span<const double>(values))));
}

void ExodusRecord::add_zeros(std::uint64_t n) {
    for (; n > 0; n -= std::min<std::uint64_t>(n, zeros.size()))
        pieces_.emplace_back(zeros.data(), std::min<std::uint64_t>(n, zeros.size()));
}

bool ExodusRecord::is_zeros(std::string_view piece) {
    return piece.data() == zeros.data();
}

void ExodusRecord::add_field(std::size_t field, bool is_byte,
                             std::optional<std::string_view> bytes) {
    if (bytes && is_byte && !names_.fields[field].is_byte) bytes = kept(widened(*bytes));
    for (const Part& part : fields_[field]) {
        if (bytes) {
            pieces_.push_back(bytes->substr(0, part.n_bytes));
            bytes->remove_prefix(part.n_bytes);
        }
        add_zeros(part.size - (bytes ? part.n_bytes : 0));
    }
}

const std::vector<std::string_view>& ExodusRecord::pieces(double time, const ExodusFields& state) {
    begin(time, state.numbers());
    for (std::size_t i = 0; i < names_.fields.size(); ++i) {
        const ExodusFields::Field* field = found_in(state, names_.fields[i], i);
        if (field != nullptr && field->bytes != nullptr)
            add_field(i, field->is_byte, std::string_view(field->bytes, field->n_bytes));
        else
            add_field(i, true, std::nullopt);
    }
    return pieces_;
}

std::string ExodusRecord::joined() const {
    std::string record;
    record.reserve(size_);
    for (const std::string_view piece : pieces_) record += piece;
    return record;
}

std::string ExodusRecord::bytes(const ExodusRecord& earlier, std::string_view record) {
    std::vector<std::pair<std::string, double>> numbers;
    if (!earlier.names_.numbers.empty()) {
        const auto values = from_big_endian<double>(earlier.numbers_.of(record));
        for (std::size_t i = 0; i < values.size(); ++i)
            numbers.emplace_back(earlier.names_.numbers[i], values[i]);
    }
    begin(from_big_endian<double>(earlier.time_.of(record)).at(0), numbers);
    for (std::size_t i = 0; i < names_.fields.size(); ++i) {
        const ExodusNames::Field& field = names_.fields[i];
        const auto found = std::ranges::find_if(earlier.names_.fields, [&](const auto& one) {
            return one.name == field.name && one.is_of_elements == field.is_of_elements;
        });
        if (found == earlier.names_.fields.end()) {
            add_field(i, true, std::nullopt);
            continue;
        }
        std::string bytes;
        for (const Part& part :
             earlier.fields_[static_cast<std::size_t>(found - earlier.names_.fields.begin())])
            bytes += part.of(record);
        add_field(i, found->is_byte, kept(std::move(bytes)));
    }
    return joined();
}

}  // namespace tricontact::io

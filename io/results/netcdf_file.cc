#include "io/results/netcdf_file.h"

#include <filesystem>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

// Of lists in the header.
constexpr std::uint32_t dimensions_tag = 10, variables_tag = 11, attributes_tag = 12;
constexpr std::string_view magic = "CDF\x02";

std::uint64_t padded(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

std::string word(std::uint64_t value) {
    return big_endian(static_cast<std::uint32_t>(value));
}

std::string padded_bytes(std::string_view bytes) {
    std::string out(bytes);
    out.resize(padded(bytes.size()), '\0');
    return out;
}

std::string name_bytes(std::string_view name) {
    return word(name.size()) + padded_bytes(name);
}

std::string begin_of_list(std::uint32_t tag, std::size_t n) {
    return n == 0 ? word(0) + word(0) : word(tag) + word(n);
}

std::string attribute_bytes(const std::vector<NetcdfAttribute>& attributes) {
    std::string out = begin_of_list(attributes_tag, attributes.size());
    for (const auto& [name, type, values] : attributes)
        out += name_bytes(name) + word(static_cast<std::uint32_t>(type)) +
               word(values.size() / size_of(type)) + padded_bytes(values);
    return out;
}

/// Takes a header apart; `refuse` hears of one that ends too early.
class HeaderParser {
  public:
    explicit HeaderParser(std::string_view bytes) : rest_(bytes) {}

    bool failed() const { return failed_; }
    std::uint32_t word() { return number<std::uint32_t>(); }
    std::string_view take(std::size_t n) {
        if (n > rest_.size()) {
            failed_ = true;
            return {};
        }
        const std::string_view taken = rest_.substr(0, n);
        rest_.remove_prefix(n);
        return taken;
    }
    template <class T>
    T number() {
        const std::string_view bytes = take(sizeof(T));
        return bytes.empty() ? T{} : from_big_endian<T>(bytes)[0];
    }
    std::string name() {
        const std::size_t n = word();
        const std::string_view bytes = take(padded(n));
        return failed_ ? std::string() : std::string(bytes.substr(0, n));
    }
    /// Number of what a list has.
    std::size_t list(std::uint32_t tag) {
        const std::uint32_t found = word();
        const std::size_t n = word();
        if (n > 0 && found != tag) failed_ = true;
        return failed_ ? 0 : n;
    }
    NetcdfType type() {
        const auto type = static_cast<NetcdfType>(word());
        if (size_of(type) == 0) failed_ = true;
        return failed_ ? NetcdfType::byte : type;
    }
    std::vector<NetcdfAttribute> attributes() {
        std::vector<NetcdfAttribute> out;
        for (std::size_t n = list(attributes_tag); n > 0 && !failed_; --n) {
            NetcdfAttribute attribute{.name = name(), .type = type(), .values = {}};
            const std::size_t size = word() * size_of(attribute.type);
            attribute.values = std::string(take(padded(size)).substr(0, size));
            out.push_back(std::move(attribute));
        }
        return out;
    }

  private:
    std::string_view rest_;
    bool failed_ = false;
};

}  // namespace

std::size_t size_of(NetcdfType type) {
    switch (type) {
        case NetcdfType::byte:
        case NetcdfType::text:
            return 1;
        case NetcdfType::integer:
        case NetcdfType::single:
            return 4;
        case NetcdfType::real:
            return 8;
    }
    return 0;
}

std::uint32_t NetcdfLayout::add_dimension(std::string name, std::size_t length) {
    dimensions.push_back({std::move(name), static_cast<std::uint32_t>(length)});
    return static_cast<std::uint32_t>(dimensions.size() - 1);
}

bool NetcdfLayout::is_of_records(const NetcdfVariable& variable) const {
    return !variable.dimensions.empty() && dimensions.at(variable.dimensions.front()).length == 0;
}

const NetcdfVariable* NetcdfLayout::find(std::string_view name) const {
    const auto found = std::ranges::find(variables, name, &NetcdfVariable::name);
    return found == variables.end() ? nullptr : &*found;
}

const NetcdfAttribute* NetcdfLayout::attribute(std::string_view name) const {
    const auto found = std::ranges::find(attributes, name, &NetcdfAttribute::name);
    return found == attributes.end() ? nullptr : &*found;
}

std::size_t NetcdfLayout::length(std::string_view name) const {
    const auto found = std::ranges::find(dimensions, name, &NetcdfDimension::name);
    return found == dimensions.end() ? 0 : found->length;
}

void NetcdfLayout::place() {
    for (NetcdfVariable& variable : variables) {
        std::uint64_t size = size_of(variable.type);
        for (std::size_t i = is_of_records(variable) ? 1 : 0; i < variable.dimensions.size(); ++i)
            size *= dimensions.at(variable.dimensions[i]).length;
        variable.size = padded(size);
    }
    std::uint64_t at = header(0).size();
    for (NetcdfVariable& variable : variables)
        if (!is_of_records(variable)) {
            variable.begin = at;
            at += variable.size;
        }
    records_begin = at;
    for (NetcdfVariable& variable : variables)
        if (is_of_records(variable)) {
            variable.begin = at;
            at += variable.size;
        }
    record_size = at - records_begin;
}

std::vector<std::string_view> NetcdfLayout::pieces(std::string_view header) const {
    static constexpr std::string_view padding("\0\0\0", 3);
    std::vector<std::string_view> pieces{header};
    for (const NetcdfVariable& variable : variables)
        if (!is_of_records(variable)) {
            pieces.emplace_back(variable.values);
            pieces.push_back(padding.substr(0, variable.size - variable.values.size()));
        }
    return pieces;
}

std::string NetcdfLayout::header(std::uint32_t n_records) const {
    std::string out = std::string(magic) + word(n_records);
    out += begin_of_list(dimensions_tag, dimensions.size());
    for (const auto& [name, length] : dimensions) out += name_bytes(name) + word(length);
    out += attribute_bytes(attributes);
    out += begin_of_list(variables_tag, variables.size());
    for (const NetcdfVariable& variable : variables) {
        out += name_bytes(variable.name) + word(variable.dimensions.size());
        for (const std::uint32_t dimension : variable.dimensions) out += word(dimension);
        out += attribute_bytes(variable.attributes) +
               word(static_cast<std::uint32_t>(variable.type)) + word(variable.size) +
               big_endian(variable.begin);
    }
    return out;
}

NetcdfReader::NetcdfReader(const std::string& path) : path_(path) {
    // Nearly all headers are short.
    constexpr std::uint64_t usual_header = 1 << 16, longest_header = 1 << 20;  // [bytes]
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) refuse("is no file that can be read");
    file_.open(path, std::ios::binary);
    file_size_ = std::filesystem::file_size(path, error);
    if (!file_ || error) refuse("cannot be read");
    if (!parse(read(0, std::min(file_size_, usual_header))) &&
        !parse(read(0, std::min(file_size_, longest_header))))
        refuse("has a damaged header");
    layout_.place();  // as it was written
}

bool NetcdfReader::parse(std::string_view head) {
    HeaderParser parser(head);
    layout_ = {};
    if (parser.take(magic.size()) != magic) refuse("was not written by this program");
    n_records_ = parser.word();
    for (std::size_t n = parser.list(dimensions_tag); n > 0 && !parser.failed(); --n) {
        std::string name = parser.name();
        layout_.dimensions.push_back({std::move(name), parser.word()});
    }
    layout_.attributes = parser.attributes();
    for (std::size_t n = parser.list(variables_tag); n > 0 && !parser.failed(); --n) {
        NetcdfVariable variable{.name = parser.name(), .type = {}, .dimensions = {}};
        for (std::size_t d = parser.word(); d > 0 && !parser.failed(); --d) {
            variable.dimensions.push_back(parser.word());
            if (variable.dimensions.back() >= layout_.dimensions.size())
                refuse("has a damaged header");
        }
        variable.attributes = parser.attributes();
        variable.type = parser.type();
        parser.word();
        parser.number<std::uint64_t>();
        layout_.variables.push_back(std::move(variable));
    }
    return !parser.failed();
}

std::string NetcdfReader::bytes(std::string_view name, std::size_t record) {
    const NetcdfVariable* variable = layout_.find(name);
    if (!variable) return {};
    const bool has_records = layout_.is_of_records(*variable);
    if (has_records && record >= n_records_) refuse("has fewer states");
    return read(variable->begin + (has_records ? record * layout_.record_size : 0), variable->size);
}

std::string NetcdfReader::record(std::size_t record) {
    return read(layout_.records_begin + record * layout_.record_size, layout_.record_size);
}

std::string NetcdfReader::read(std::uint64_t at, std::uint64_t size) {
    if (at > file_size_ || size > file_size_ - at) refuse("is cut off");
    std::string bytes(size, '\0');
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at));
    file_.read(bytes.data(), static_cast<std::streamsize>(size));
    if (file_.gcount() != static_cast<std::streamsize>(size)) refuse("is cut off");
    return bytes;
}

void NetcdfReader::refuse(const std::string& why) const {
    fail(path_, "", why, "compute the case anew with tricontact run");
}

}  // namespace tricontact::io

#include <stdexcept>

#include "benchmarks/reference/reference_cache.h"
#include "benchmarks/reference/tabled_fields.h"
#include "contact/base/state_bytes.h"
#include "files/digest.h"
#include "io/case/case_reader.h"

namespace tricontact::benchmarks {

namespace {

// One function of each kind for both directions: `archive` writes or reads its arguments.

template <class Archive, class Value>
void transfer_value(Archive& archive, Value& v) {
    archive(v.value, v.grid, v.model, v.domain, v.source);
}

void transfer(contact::StateWriter& out, const std::map<std::string, ReferenceValue>& values) {
    out(values.size());
    for (const auto& [key, value] : values) {
        out(key);
        transfer_value(out, value);
    }
}
void transfer(contact::StateReader& in, std::map<std::string, ReferenceValue>& values) {
    std::size_t n = 0;
    in(n);
    for (std::size_t k = 0; k < n; ++k) {
        std::string key;
        in(key);
        transfer_value(in, values[key]);
    }
}

void transfer(contact::StateWriter& out, const std::optional<ReferenceValue>& value) {
    out(value.has_value());
    if (value) transfer_value(out, *value);
}
void transfer(contact::StateReader& in, std::optional<ReferenceValue>& value) {
    bool is_there = false;
    in(is_there);
    if (is_there) transfer_value(in, value.emplace());
}

void transfer(contact::StateWriter& out, const std::vector<std::string>& texts) {
    out(texts.size());
    for (const std::string& text : texts) out(text);
}
void transfer(contact::StateReader& in, std::vector<std::string>& texts) {
    std::size_t n = 0;
    in(n);
    for (std::size_t k = 0; k < n; ++k) in(texts.emplace_back());
}

template <class Archive, class Any>
void transfer_all(Archive& archive, Any& r) {
    archive(r.geometry, r.contact_radius, r.has_tractions);
    transfer(archive, r.values);
    transfer(archive, r.prescribed);
    transfer(archive, r.effects.normal_compliance);
    transfer(archive, r.effects.tangential_compliance);
    transfer(archive, r.effects.displaced_surface);
    transfer(archive, r.effects.one_step);
    transfer(archive, r.models);
    transfer(archive, r.remarks);
}

}  // namespace

std::string written_reference(const Reference& reference) {
    contact::StateWriter out;
    transfer_all(out, reference);
    out(dynamic_cast<const TabledFields&>(*reference.fields).write());
    const std::string bytes = out.take();
    return files::digest_of(bytes) + bytes;
}

std::optional<Reference> read_reference(std::string_view bytes, const contact::Case& c) {
    constexpr std::size_t digest_length = 32;
    if (bytes.size() < digest_length) return {};
    const std::string_view digest = bytes.substr(0, digest_length);
    bytes.remove_prefix(digest_length);
    if (files::digest_of(bytes) != digest) return {};
    Reference result{.c = c, .digest = files::digest_of(io::write_case(c))};
    try {
        contact::StateReader in(bytes);
        transfer_all(in, result);
        std::string fields;
        in(fields);
        result.fields = read_fields(fields);
        if (!in.at_end()) return {};
    } catch (const std::runtime_error&) {
        return {};
    }
    return result;
}

}  // namespace tricontact::benchmarks

#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/results/exodus_file.h"

namespace tricontact::io {

/// Records of an Exodus II file as it is laid out: what a state lacks is 0, and none has anything
/// that is not in the names.
class ExodusRecord {
  public:
    ExodusRecord() = default;
    ExodusRecord(const NetcdfLayout& layout, ExodusNames names);

    /// Parts of the record of a state, one after another, so that nothing is copied to be written.
    /// They are there as long as the state, and until the next call.
    const std::vector<std::string_view>& pieces(double time, const ExodusFields& state);
    /// Whether a piece is zeros.
    static bool is_zeros(std::string_view piece);
    /// A record of an earlier file of fewer names, or of bytes that have become numbers.
    std::string bytes(const ExodusRecord& earlier, std::string_view record);

  private:
    struct Part {
        std::uint64_t begin, size, n_bytes;  // in the record, with padding, without

        std::string_view of(std::string_view record) const { return record.substr(begin, n_bytes); }
    };
    /// The part of a variable. Those of records come in the order of layout and names.
    Part part_of(const NetcdfLayout& layout, const NetcdfVariable& variable) const;
    void begin(double time, const std::vector<std::pair<std::string, double>>& numbers);
    /// `bytes`: none of zeros.
    void add_field(std::size_t field, bool is_byte, std::optional<std::string_view> bytes);
    void add_zeros(std::uint64_t n);
    std::string_view kept(std::string bytes) { return own_.emplace_back(std::move(bytes)); }
    std::string joined() const;

    ExodusNames names_;
    Part time_{}, numbers_{};
    std::vector<std::vector<Part>> fields_;  // of elements one for each block
    std::uint64_t size_ = 0;
    std::vector<std::string_view> pieces_;
    std::deque<std::string> own_;  // what the pieces are of
};

}  // namespace tricontact::io

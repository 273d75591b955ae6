#include "io/results/state_series.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <filesystem>
#include <system_error>

#include "files/partial_file.h"
#include "io/results/atomic_file.h"
#include "io/results/former_series.h"

namespace tricontact::io {

/// A file that is there, written at places.
class OpenFile {
  public:
    explicit OpenFile(const std::string& path)
        : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW)) {
        if (descriptor_ < 0) refuse(errno);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        // Gives back what was reserved. Where that fails it stays, beyond the end of the file.
        [[maybe_unused]] int failed = 0;
        if (reserved_ > end_) failed = ::ftruncate(descriptor_, static_cast<off_t>(end_));
        ::close(descriptor_);
    }

    void write(std::uint64_t at, std::string_view bytes) const { write_all(at, {&bytes, 1}); }
    /// A record at the end of the file. Long runs of zeros are left out, which the file then has as
    /// a hole; what it ends with is written.
    void append(std::uint64_t at, std::span<const std::string_view> pieces) {
        constexpr std::size_t shortest_hole = 8192;  // two pages: one of them is whole
        std::size_t begin = 0;
        end_ = at;
        if (!has_holes_) reserve(at, pieces);
        has_holes_ = false;
        for (std::size_t i = 0; i < pieces.size();) {
            std::size_t end = i, n_zeros = 0;
            for (; end < pieces.size() && ExodusRecord::is_zeros(pieces[end]); ++end)
                n_zeros += pieces[end].size();
            if (end < pieces.size() && n_zeros >= shortest_hole) {
                has_holes_ = true;
                at = write_all(at, pieces.subspan(begin, i - begin)) + n_zeros;
                begin = end;
            }
            i = std::max(end, i + 1);
        }
        end_ = write_all(at, pieces.subspan(begin));
    }

  private:
    /// Room on the disk for a long record and for more like it: blocks one by one cost more. The
    /// size of the file stays. Where there is no room, writing says so.
    void reserve(std::uint64_t at, std::span<const std::string_view> record) {
        constexpr std::uint64_t at_once = 4 << 20, least = 1 << 16;  // [bytes]
        std::uint64_t n_bytes = 0;
        for (const std::string_view piece : record) n_bytes += piece.size();
        if (n_bytes < least || at + n_bytes <= reserved_) return;
#ifdef FALLOC_FL_KEEP_SIZE
        const std::uint64_t n = std::max(at_once, n_bytes);
        reserved_ = at + n;  // a failure may have reserved a part
        [[maybe_unused]] const int failed = ::fallocate(
            descriptor_, FALLOC_FL_KEEP_SIZE, static_cast<off_t>(at), static_cast<off_t>(n));
#endif
    }
    /// One after another; where they end.
    std::uint64_t write_all(std::uint64_t at, std::span<const std::string_view> pieces) const {
        try {
            return files::write_all(descriptor_, at, pieces);
        } catch (const std::system_error& error) {
            refuse(error.code().value());
        }
    }
    [[noreturn]] void refuse(int error) const {
        refuse_output(path_, "cannot be written", error);
    }

    std::string path_;
    int descriptor_;
    std::uint64_t end_ = 0, reserved_ = 0;  // of the records, of the room on the disk [bytes]
    bool has_holes_ = false;                // the last record: then no room is reserved
};

std::vector<double> times_from_start(const std::vector<double>& times) {
    const auto n = times.size();
    const auto end_of = [&](std::size_t begin) {
        std::size_t end = begin;
        while (end < n && times[end] <= times[begin]) ++end;
        return end;
    };
    std::vector<double> apart = times;
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
        end = end_of(begin);
        const auto n_here = static_cast<double>(end - begin);
        if (begin == 0) {
            // 1 where nothing says what a time is
            const double step = end < n ? (times[end] - times[0]) / (2 * n_here) : 1;
            for (std::size_t k = 0; k < end; ++k)
                apart[k] = times[0] + static_cast<double>(k) * step;
            continue;
        }
        const double before = apart[begin - 1], step = (times[begin] - before) / n_here;
        for (std::size_t k = begin; k + 1 < end; ++k)
            apart[k] = before + static_cast<double>(k + 1 - begin) * step;
    }
    return apart;
}

void StateSeries::clear() {
    n_files_ = 0;
    mesh_ = nullptr;
    names_ = {};
    layout_ = {};
    record_ = {};
    file_ = nullptr;
    times_.clear();
    shown_times_.clear();
}

std::string StateSeries::path(int number) const {
    const std::string end = number > 1 ? "_" + std::to_string(number) : "";
    return (std::filesystem::path(folder_) / (name_ + end + states_extension)).string();
}

void StateSeries::add(double time, const std::shared_ptr<const ExodusMesh>& mesh,
                      const ExodusFields& fields) {
    const bool is_new = n_files_ == 0 || (mesh != mesh_ && *mesh != *mesh_);
    if (mesh != mesh_) mesh_ = mesh;
    if (is_new) return begin_file(time, fields);
    take_more_names(fields);
    append(time, fields);
}

void StateSeries::lay_out() {
    layout_ = exodus_layout(*mesh_, names_, provenance_);
    record_ = ExodusRecord(layout_, names_);
    file_ = nullptr;  // that will be replaced
}

// The first state comes with the header, at once. What an earlier run left of further files goes.
void StateSeries::begin_file(double time, const ExodusFields& fields) {
    names_ = {};
    names_.take(fields);
    lay_out();
    times_ = shown_times_ = {time};
    ++n_files_;
    if (n_files_ == 1) remove_former_series(folder_, name_);
    std::error_code ignored;
    for (int number = n_files_ + 1; std::filesystem::exists(path(number), ignored); ++number)
        remove_file(path(number));
    const std::string header = layout_.header(1);
    std::vector<std::string_view> pieces = layout_.pieces(header);
    const auto& of_state = record_.pieces(time, fields);
    pieces.insert(pieces.end(), of_state.begin(), of_state.end());
    write_unsynced(path(n_files_), pieces);
}

// Of rolling, some fields begin with its first period.
void StateSeries::take_more_names(const ExodusFields& fields) {
    if (!names_.take(fields)) return;
    const ExodusRecord earlier = std::move(record_);
    lay_out();
    NetcdfReader old(path(n_files_));
    const std::string header = layout_.header(static_cast<std::uint32_t>(times_.size()));
    std::vector<std::string_view> pieces = layout_.pieces(header);
    std::deque<std::string> records;
    for (std::size_t i = 0; i < times_.size(); ++i)
        pieces.emplace_back(records.emplace_back(record_.bytes(earlier, old.record(i))));
    write_unsynced(path(n_files_), pieces);
}

// After a later time than all others none of those moves, once there are two.
std::vector<double> StateSeries::shown_with(double time) const {
    std::vector<double> shown;
    if (time > times_.back() && times_.back() > times_.front()) {
        shown = shown_times_;
        shown.push_back(time);
        return shown;
    }
    shown = times_;
    shown.push_back(time);
    return times_from_start(shown);
}

// The number of records comes last. Times that move are never out of order, not even meanwhile.
void StateSeries::append(double time, const ExodusFields& fields) {
    const std::vector<double> shown = shown_with(time);
    times_.push_back(time);
    const std::size_t last = shown.size() - 1;
    if (!file_) file_ = std::make_shared<OpenFile>(path(n_files_));
    OpenFile& file = *file_;
    const auto place_of = [&](std::size_t record) {
        return layout_.records_begin + record * layout_.record_size;
    };
    file.append(place_of(last), record_.pieces(shown[last], fields));
    const auto move = [&](std::size_t i) {
        if (shown[i] != shown_times_[i]) file.write(place_of(i), big_endian(shown[i]));
    };
    if (shown[last - 1] > shown_times_[last - 1])
        for (std::size_t i = last; i-- > 0;) move(i);
    else
        for (std::size_t i = 0; i < last; ++i) move(i);
    file.write(netcdf_number_of_records_at, big_endian(static_cast<std::uint32_t>(last + 1)));
    shown_times_ = shown;
}

void StateSeries::finish() const {
    sync_files(folder_);
}

}  // namespace tricontact::io

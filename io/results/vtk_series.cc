// Files over time for ParaView.

#include <fmt/format.h>

#include <filesystem>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

namespace {

std::string xml_attribute(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

}  // namespace

std::vector<double> times_apart(const std::vector<double>& times) {
    const auto n = times.size();
    const auto end_of = [&](std::size_t begin) {
        std::size_t end = begin;
        while (end < n && times[end] <= times[begin]) ++end;
        return end;
    };
    std::vector<double> apart = times;
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
        end = end_of(begin);
        double step = 1;  // where nothing says what a time is
        if (begin > 0)
            step = (times[begin] - times[begin - 1]) / static_cast<double>(end - begin);
        else if (end < n)
            step = (times[end] - times[begin]) / static_cast<double>(end_of(end) - end);
        for (std::size_t k = begin; k < end; ++k)
            apart[k] = times[begin] - static_cast<double>(end - 1 - k) * step;
    }
    return apart;
}

// The collection of an earlier run goes first: it lists files that are written over.
void VtkSeries::add(double time, const VtkFile& file) {
    const std::string name = fmt::format("{}_{:06}{}", name_, files_.size(), file.extension);
    if (files_.empty()) remove_file(path_of(name_ + ".pvd"));
    write_over(path_of(name), file.bytes);
    last_size_ = file.bytes.size();
    files_.push_back(name);
    add_again(time, files_.size() - 1);
}

void VtkSeries::add_again(double time, std::size_t file) {
    states_.push_back({time, file});
    const auto now = std::chrono::steady_clock::now();
    if (now < next_collection_) return;
    write_unsynced(path_of(name_ + ".pvd"), collection());
    next_collection_ = now + std::chrono::seconds(1);
}

void VtkSeries::list_all() const {
    write_unsynced(path_of(name_ + ".pvd"), collection());
}

void VtkSeries::finish() const {
    list_all();
    sync_files(folder_);
}

std::string VtkSeries::path_of(const std::string& name) const {
    return (std::filesystem::path(folder_) / name).string();
}

std::string VtkSeries::collection() const {
    std::vector<double> times;
    for (const State& state : states_) times.push_back(state.time);
    times = times_apart(times);
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (std::size_t i = 0; i < states_.size(); ++i)
        out += "    <DataSet timestep=\"" + shortest(times[i]) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(files_.at(states_[i].file)) +
               "\"/>\n";
    return out + "  </Collection>\n</VTKFile>\n";
}

}  // namespace tricontact::io

#include "io/vtk_series.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include "io/atomic_file.h"
#include "io/messages.h"
#include "io/vtk_files.h"

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

VtkSeries::VtkSeries(std::string folder, std::string name, Provenance provenance)
    : folder_(std::move(folder)), name_(std::move(name)), provenance_(std::move(provenance)) {}

template <class State>
void VtkSeries::add_state(double phase, const State& state) {
    const VtkFile file = vtk_file(phase, state, provenance_);
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "_%06zu", entries_.size());
    const std::string name = name_ + number.data() + std::string(file.extension);
    write_file((std::filesystem::path(folder_) / name).string(), file.bytes);
    entries_.push_back({phase, name});
}

void VtkSeries::add(double phase, const contact::Surface& surface) {
    add_state(phase, surface);
}
void VtkSeries::add(double phase, const contact::Interior& interior) {
    add_state(phase, interior);
}

void VtkSeries::finish() const {
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const Entry& entry : entries_)
        out += "    <DataSet timestep=\"" + shortest(entry.phase) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(entry.file) + "\"/>\n";
    out += "  </Collection>\n</VTKFile>\n";
    write_file((std::filesystem::path(folder_) / (name_ + ".pvd")).string(), out);
}

}  // namespace tricontact::io

#include "io/results/vtk_series.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"

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

void VtkSeries::add(double time, const VtkFile& file) {
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "_%06zu", entries_.size());
    const std::string name = name_ + number.data() + std::string(file.extension);
    write_file((std::filesystem::path(folder_) / name).string(), file.bytes);
    entries_.push_back({time, name});
}

void VtkSeries::add(double phase, const contact::Surface& surface) {
    add(phase, vtk_file(phase, surface, provenance_));
}
void VtkSeries::add(double phase, const contact::Interior& interior) {
    add(phase, vtk_file(phase, interior, provenance_));
}

void VtkSeries::finish() const {
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const Entry& entry : entries_)
        out += "    <DataSet timestep=\"" + shortest(entry.time) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(entry.file) + "\"/>\n";
    out += "  </Collection>\n</VTKFile>\n";
    write_file((std::filesystem::path(folder_) / (name_ + ".pvd")).string(), out);
}

}  // namespace tricontact::io

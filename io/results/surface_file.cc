#include "io/results/surface_file.h"

#include <lz4.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/results/saved_states.h"
#include "io/results/state_series.h"

namespace tricontact::io {

namespace {

using contact::Surface;

constexpr std::size_t most_megabytes = 512;
constexpr std::size_t most_surface_points = 20'000'000;
constexpr const char* kind_of_file = "surface for ParaView";

/// A tag of XML with its attributes.
struct Tag {
    std::string_view name;
    std::map<std::string_view, std::string_view> attributes;

    std::string_view operator[](std::string_view key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? std::string_view() : found->second;
    }
};

/// Begin and empty tags of a text without comments, as this program writes them.
std::vector<Tag> tags_of(std::string_view text) {
    std::vector<Tag> tags;
    for (auto at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
        const auto end = text.find('>', at);
        if (end == text.npos) break;
        std::string_view inside = text.substr(at + 1, end - at - 1);
        Tag tag{inside.substr(0, inside.find_first_of(" /?")), {}};
        for (auto quote = inside.find("=\""); quote != inside.npos; quote = inside.find("=\"")) {
            const auto close = inside.find('"', quote + 2);
            if (close == inside.npos) break;
            const auto blank = inside.substr(0, quote).rfind(' ');
            tag.attributes[inside.substr(blank + 1, quote - blank - 1)] =
                inside.substr(quote + 2, close - quote - 2);
            inside.remove_prefix(close + 1);
        }
        if (!tag.name.empty()) tags.push_back(std::move(tag));
    }
    return tags;
}

template <class T>
std::optional<T> number_in(std::string_view text) {
    T value{};
    const auto end = text.data() + text.size();
    const auto [ptr, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || ptr != end) return {};
    return value;
}

/// Numbers divided by blanks.
template <class T>
std::vector<T> numbers_in(std::string_view text) {
    std::vector<T> values;
    while (!text.empty()) {
        const auto blank = std::min(text.find(' '), text.size());
        const auto value = number_in<T>(text.substr(0, blank));
        if (!value) return {};
        values.push_back(*value);
        text.remove_prefix(std::min(blank + 1, text.size()));
    }
    return values;
}

/// The file's tags and its arrays, decompressed when they are asked for.
class SavedData {
  public:
    explicit SavedData(const std::string& path)
        : path_(path), bytes_(read_input_file(path, kind_of_file, most_megabytes)) {
        constexpr std::string_view mark = "<AppendedData encoding=\"raw\">\n   _";
        const auto at = bytes_.find(mark);
        if (at == std::string::npos) refuse("has no arrays as this program writes them");
        tags_ = tags_of(std::string_view(bytes_).substr(0, at));
        blocks_ = std::string_view(bytes_).substr(at + mark.size());
        if (tag("VTKFile")["compressor"] != "vtkLZ4DataCompressor" ||
            tag("VTKFile")["byte_order"] != "LittleEndian")
            refuse("was not written by this program");
    }
    const Tag& tag(std::string_view name) const {
        const auto found = std::ranges::find(tags_, name, &Tag::name);
        if (found == tags_.end()) refuse("has no element " + std::string(name));
        return *found;
    }
    bool has(std::string_view name) const {
        return std::ranges::find(tags_, name, &Tag::name) != tags_.end();
    }
    bool is_of(std::string_view type) const { return tag("VTKFile")["type"] == type; }
    std::size_t count(std::string_view attribute) const {
        const auto n = number_in<std::size_t>(tag("Piece")[attribute]);
        if (!n || *n > most_surface_points) refuse("has no sound number of points and cells");
        return *n;
    }
    /// Empty where there is none of the name.
    template <class T>
    std::vector<T> values(std::string_view name, std::size_t n) const {
        const auto found =
            std::ranges::find_if(tags_, [&](const Tag& one) { return one["Name"] == name; });
        if (found == tags_.end()) return {};
        std::vector<T> values(n);
        fill(*found, values.data(), n * sizeof(T));
        return values;
    }
    [[noreturn]] void refuse(const std::string& why) const {
        fail(path_, "", why, "compute the case anew with tricontact run");
    }

  private:
    std::uint64_t word(std::size_t at) const {
        std::uint64_t value = 0;
        if (at > blocks_.size() || blocks_.size() - at < sizeof value) refuse("is cut off");
        std::memcpy(&value, blocks_.data() + at, sizeof value);
        return value;
    }
    /// Number of blocks, size of each and of a smaller last one, then sizes and blocks.
    void fill(const Tag& array, void* values, std::size_t n_bytes) const {
        const auto offset = number_in<std::size_t>(array["offset"]);
        if (!offset) refuse("has an array without its place");
        const std::size_t n_blocks = word(*offset), block = word(*offset + 8);
        const std::size_t last = word(*offset + 16);
        if (n_blocks > blocks_.size() / 8 || block > n_bytes + (1 << 20))
            refuse("has an array of another size than its points");
        std::size_t at = *offset + 8 * (3 + n_blocks), done = 0;
        for (std::size_t i = 0; i < n_blocks; ++i) {
            const std::size_t size = word(*offset + 8 * (3 + i));
            const std::size_t due = i + 1 == n_blocks && last > 0 ? last : block;
            if (at > blocks_.size() || blocks_.size() - at < size || n_bytes - done < due)
                refuse("has an array of another size than its points");
            const int got =
                LZ4_decompress_safe(blocks_.data() + at, static_cast<char*>(values) + done,
                                    static_cast<int>(size), static_cast<int>(due));
            if (got != static_cast<int>(due)) refuse("has a damaged array");
            at += size;
            done += due;
        }
        if (done != n_bytes) refuse("has an array of another size than its points");
    }

    std::string path_, bytes_;
    std::string_view blocks_;
    std::vector<Tag> tags_;
};

std::vector<double> widened(const std::vector<float>& values) {
    return {values.begin(), values.end()};
}

/// Into which members the components of a vector go; null: nowhere.
void read_vector(const SavedData& data, std::string_view name, std::size_t n,
                 const std::array<std::vector<double>*, 3>& members, double z_sign) {
    const auto values = data.values<float>(name, 3 * n);
    for (std::size_t d = 0; d < members.size() && !values.empty(); ++d) {
        if (!members[d]) continue;
        members[d]->resize(n);
        for (std::size_t i = 0; i < n; ++i)
            (*members[d])[i] = (d == 2 ? z_sign : 1) * static_cast<double>(values[3 * i + d]);
    }
}

void read_fields(const SavedData& data, Surface& s) {
    const std::size_t n = s.size();
    const auto scalar = [&](std::string_view name) { return widened(data.values<float>(name, n)); };
    s.normal_traction = scalar("normal_traction_Pa");
    if (s.normal_traction.empty()) data.refuse("has no normal_traction_Pa");
    read_vector(data, "tangential_traction_Pa", n,
                {&s.tangential_traction_x, &s.tangential_traction_y, nullptr}, 1);
    s.friction_bound = scalar("friction_bound_Pa");
    read_vector(data, "displacement_m", n,
                {&s.displacement_x, &s.displacement_y, &s.displacement_z}, -1);
    s.gap = scalar("gap_m");
    read_vector(data, "slip_m", n, {&s.slip_x, &s.slip_y, nullptr}, 1);
    for (const std::uint8_t state : data.values<std::uint8_t>("contact_state", n)) {
        if (state > 2) data.refuse("has a contact_state that is none");
        s.contact_state.push_back(static_cast<contact::ContactState>(state));
    }
    s.normal_line_load = scalar("normal_line_load_N_per_m");
    s.tangential_line_load = scalar("tangential_line_load_N_per_m");
    const auto position = data.values<double>("indenter_position_m", 3);
    if (!position.empty()) s.offset = {position[0], position[1]};
}

Surface image(const SavedData& data) {
    const Tag& tag = data.tag("ImageData");
    const auto extent = numbers_in<int>(tag["WholeExtent"]);
    const auto origin = numbers_in<double>(tag["Origin"]),
               spacing = numbers_in<double>(tag["Spacing"]);
    if (extent.size() != 6 || origin.size() != 3 || spacing.size() != 3 || extent[1] < 1 ||
        extent[3] < 1 || !(spacing[0] > 0) || !(spacing[1] > 0) ||
        static_cast<double>(extent[1]) * extent[3] > most_surface_points)
        data.refuse("has no sound grid");
    Surface s;
    s.n_x = extent[1], s.n_y = extent[3];
    s.spacing = {spacing[0], spacing[1]};
    s.first = {origin[0], origin[1]};
    // Of a single row, and of versions that wrote no points, cells.
    if (data.has("PointData")) {
        ++s.n_x, ++s.n_y;
    } else {
        s.first = {s.first[0] + spacing[0] / 2, s.first[1] + spacing[1] / 2};
    }
    return s;
}

Surface line(const SavedData& data) {
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = static_cast<int>(data.count("NumberOfPoints")), s.n_y = 1;
    const auto points = data.values<double>("Points", 3 * s.size());
    if (s.n_x < 2 || points.empty()) data.refuse("has no points");
    s.first = {points[0], points[1]};
    s.spacing = {(points[3 * s.size() - 3] - points[0]) / (s.n_x - 1), 0};
    return s;
}

Surface nodes(const SavedData& data) {
    const std::size_t n = data.count("NumberOfPoints"), n_cells = data.count("NumberOfCells");
    Surface s;
    s.layout = Surface::Layout::nodes;
    const auto points = data.values<double>("Points", 3 * n);
    if (points.empty()) data.refuse("has no points");
    for (std::size_t i = 0; i < n; ++i) {
        s.node_x.push_back(points[3 * i]);
        s.node_y.push_back(points[3 * i + 1]);
    }
    constexpr std::size_t n_corners = 9;
    const auto joined = data.values<std::int64_t>("connectivity", n_corners * n_cells);
    if (joined.empty()) data.refuse("has no cells");
    s.quads.resize(joined.size() / n_corners);
    for (std::size_t i = 0; i < joined.size(); ++i) {
        if (joined[i] < 0 || joined[i] >= static_cast<std::int64_t>(n))
            data.refuse("has a cell of points that are not there");
        s.quads[i / n_corners][i % n_corners] = static_cast<int>(joined[i]);
    }
    return s;
}

}  // namespace

std::vector<SeriesFile> read_series(const std::string& path) {
    const std::string text = read_input_file(path, "collection of files for ParaView", 64);
    const auto folder = std::filesystem::path(path).parent_path();
    std::vector<SeriesFile> files;
    for (const Tag& tag : tags_of(text)) {
        if (tag.name != "DataSet") continue;
        const auto time = number_in<double>(tag["timestep"]);
        const std::filesystem::path name(tag["file"]);
        if (!time || name.empty() || name != name.filename())
            fail(path, "", "has a data set without a time or with a file elsewhere",
                 "compute the case anew with tricontact run");
        files.push_back({*time, (folder / name).string(), 0});
    }
    return files;
}

Surface read_surface_file(const std::string& path, int state) {
    if (path.ends_with(states_extension)) return read_state(path, state);
    const SavedData data(path);
    Surface s = data.is_of("ImageData")          ? image(data)
                : data.is_of("PolyData")         ? line(data)
                : data.is_of("UnstructuredGrid") ? nodes(data)
                                                 : Surface();
    if (s.size() == 0) data.refuse("is no surface of a contact");
    read_fields(data, s);
    return s;
}

}  // namespace tricontact::io

#include "benchmarks/submissions/mesh_stream.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace tricontact::benchmarks {

namespace {

constexpr std::string_view stream_begin = "tricontact mesh 1\n";

class StreamWriter {
  public:
    explicit StreamWriter(std::string& out) : out_(out) {}

    void add(std::uint64_t n) { out_.append(reinterpret_cast<const char*>(&n), sizeof(n)); }
    void add(std::string_view text) {
        add(text.size());
        out_ += text;
    }
    template <class T>
    void add_all(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(values.size());
        if (!values.empty())
            out_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void add_texts(const std::vector<std::string>& texts) {
        add(texts.size());
        for (const std::string& text : texts) add(text);
    }

  private:
    std::string& out_;
};

/// All members are false where the bytes end.
class StreamReader {
  public:
    explicit StreamReader(std::string_view bytes) : rest_(bytes) {}

    bool get(std::uint64_t& n) {
        if (rest_.size() < sizeof(n)) return false;
        std::memcpy(&n, rest_.data(), sizeof(n));
        rest_.remove_prefix(sizeof(n));
        return true;
    }
    bool get(std::string& text) {
        std::uint64_t n = 0;
        if (!get(n) || n > rest_.size()) return false;
        text = rest_.substr(0, n);
        rest_.remove_prefix(n);
        return true;
    }
    template <class T>
    bool get_all(std::vector<T>& values) {
        std::uint64_t n = 0;
        if (!get(n) || n > rest_.size() / sizeof(T)) return false;
        values.resize(n);
        if (n > 0) std::memcpy(values.data(), rest_.data(), n * sizeof(T));
        rest_.remove_prefix(n * sizeof(T));
        return true;
    }
    bool get_texts(std::vector<std::string>& texts) {
        std::uint64_t n = 0;
        if (!get(n) || n > rest_.size()) return false;
        texts.resize(n);
        return std::ranges::all_of(texts, [&](std::string& text) { return get(text); });
    }

    bool is_at_end() const { return rest_.empty(); }

  private:
    std::string_view rest_;
};

void add_arrays(StreamWriter& out, const std::vector<MeshArray>& arrays) {
    out.add(arrays.size());
    for (const MeshArray& array : arrays) {
        out.add(array.name);
        out.add(static_cast<std::uint64_t>(array.n_components));
        out.add_all(array.values);
    }
}

bool get_arrays(StreamReader& in, std::vector<MeshArray>& arrays, std::size_t n_items) {
    std::uint64_t n = 0;
    if (!in.get(n) || n > 10'000) return false;
    arrays.resize(n);
    return std::ranges::all_of(arrays, [&](MeshArray& array) {
        std::uint64_t n_components = 0;
        if (!in.get(array.name) || !in.get(n_components) || n_components == 0 || n_components > 9)
            return false;
        array.n_components = static_cast<int>(n_components);
        return in.get_all(array.values) && array.values.size() == n_items * n_components;
    });
}

bool is_consistent(const MeshData& mesh) {
    if (mesh.offsets.size() != mesh.types.size() + 1 || mesh.offsets.front() != 0 ||
        mesh.offsets.back() != static_cast<std::int64_t>(mesh.connectivity.size()) ||
        !std::ranges::is_sorted(mesh.offsets))
        return false;
    const auto n_points = static_cast<std::int64_t>(mesh.points.size());
    return std::ranges::all_of(mesh.connectivity,
                               [&](int node) { return node >= 0 && node < n_points; });
}

bool get_mesh(StreamReader& in, MeshData& mesh) {
    std::uint64_t has_pieces = 0;
    if (!in.get(mesh.name) || !in.get(has_pieces) || !in.get_all(mesh.points) ||
        !in.get_all(mesh.types) || !in.get_all(mesh.offsets) || !in.get_all(mesh.connectivity) ||
        !is_consistent(mesh))
        return false;
    mesh.has_pieces = has_pieces != 0;
    return get_arrays(in, mesh.point_arrays, mesh.points.size()) &&
           get_arrays(in, mesh.cell_arrays, mesh.n_cells());
}

}  // namespace

std::string written(const MeshAnswer& answer) {
    std::string bytes(stream_begin);
    StreamWriter out(bytes);
    out.add(answer.error);
    out.add_texts(answer.notes);
    out.add(answer.meshes.size());
    for (const MeshData& mesh : answer.meshes) {
        out.add(mesh.name);
        out.add(static_cast<std::uint64_t>(mesh.has_pieces));
        out.add_all(mesh.points);
        out.add_all(mesh.types);
        out.add_all(mesh.offsets);
        out.add_all(mesh.connectivity);
        add_arrays(out, mesh.point_arrays);
        add_arrays(out, mesh.cell_arrays);
    }
    return bytes;
}

bool read_answer(std::string_view bytes, MeshAnswer& answer) {
    if (!bytes.starts_with(stream_begin)) return false;
    StreamReader in(bytes.substr(stream_begin.size()));
    std::uint64_t n = 0;
    if (!in.get(answer.error) || !in.get_texts(answer.notes) || !in.get(n) || n > 100'000)
        return false;
    answer.meshes.resize(n);
    return std::ranges::all_of(answer.meshes, [&](MeshData& mesh) { return get_mesh(in, mesh); }) &&
           in.is_at_end();
}

}  // namespace tricontact::benchmarks

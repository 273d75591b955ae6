#include <fmt/chrono.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/models/fem_entries.h"
#include "app/models/mesh_entries.h"
#include "fem/case/body_cells.h"
#include "fem/case/indenter_body.h"
#include "fem/case/layer_condenser.h"
#include "fem/case/model.h"
#include "fem/case/section_cells.h"
#include "fem/case/section_model.h"
#include "fem/launcher.h"
#include "fem/layer_cache.h"
#include "fem/settings.h"
#include "files/partial_file.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"
#include "io/results/vtk_files.h"
#include "meshes/mesh_file.h"

namespace tricontact::app {

namespace {

using Json = nlohmann::ordered_json;
using runs::Answer;

LoadMeshEntries* load_mesh_entries = nullptr;
const MeshEntries& mesh_libraries() {
    return load_mesh_entries();
}

/// Enumerators as the indices that a mesh view holds.
template <class T, class Get>
std::vector<std::uint8_t> indices(const std::vector<T>& items, Get get) {
    std::vector<std::uint8_t> result;
    for (const T& item : items) result.push_back(static_cast<std::uint8_t>(get(item)));
    return result;
}

void write_view(const meshes::HexMesh& mesh, const std::string& path,
                const std::string& command_line) {
    std::vector<std::array<int, 4>> faces;
    for (const auto& face : mesh.faces) faces.push_back(face.nodes);
    const auto regions = indices(mesh.regions, [](meshes::Region region) { return region; });
    const auto boundaries =
        indices(mesh.faces, [](const meshes::HexMesh::Face& face) { return face.boundary; });
    io::MeshView view{.points = mesh.nodes,
                      .hexes = mesh.hexes,
                      .regions = regions,
                      .faces = faces,
                      .boundaries = boundaries,
                      .region_names = {},
                      .boundary_names = {}};
    for (int k = 0; k < meshes::n_regions; ++k)
        view.region_names.emplace_back(name_of(static_cast<meshes::Region>(k)));
    for (int k = 0; k < meshes::n_boundaries; ++k)
        view.boundary_names.emplace_back(name_of(static_cast<meshes::Boundary>(k)));
    io::write_mesh_vtu(path, view, {files::version, command_line});
}

/// What `mesh` wrote of it, and its quality.
Answer mesh_answer(const meshes::HexMesh& mesh, const std::string& folder,
                   const std::vector<std::string>& written) {
    const meshes::MeshQuality q = meshes::quality(mesh);
    const bool half = mesh.has_symmetry();
    std::array<double, 3> block{};
    for (std::size_t i = 0; i < 3; ++i) block[i] = q.high[i] - q.low[i];
    return Answer(
        [=] {
            return Json{{"version", files::version},
                        {"hexahedra", q.n_hexes},
                        {"nodes", q.n_nodes},
                        {"contact_faces", q.n_contact_faces},
                        {"element_at_contact_m", q.contact_size},
                        {"block_m", block},
                        {"half", half},
                        {"least_jacobian", q.least_jacobian},
                        {"largest_aspect_ratio", q.largest_aspect_ratio},
                        {"folder", folder},
                        {"files", written}}
                .dump(2);
        },
        fmt::format("hexahedra            {}\n"
                    "nodes                {}\n"
                    "contact faces        {}\n"
                    "element at contact   {:.6g} mm\n"
                    "block                {:.6g} x {:.6g} x {:.6g} mm{}\n"
                    "least Jacobian       {:.4g} (1: a box)\n"
                    "aspect ratio         {:.4g} at worst\n"
                    "written              {}/{}\n",
                    q.n_hexes, q.n_nodes, q.n_contact_faces, 1e3 * q.contact_size, 1e3 * block[0],
                    1e3 * block[1], 1e3 * block[2], half ? " (half, plane of symmetry y = 0)" : "",
                    q.least_jacobian, q.largest_aspect_ratio, folder, fmt::join(written, ", ")));
}

void say_plainly(const std::string& line) {
    std::cerr << line << '\n';
}
void say(const std::string& line) {
    say_plainly("fem: " + line);
}

/// `does`: "mesh writes"; what it does with layers, and with no body of an indenter.
void require_rigid_indenter(const Case& c, const std::string& does) {
    if (c.indenter.body)
        throw contact::InputError(std::string(c.indenter.body->key()) + ": " + does +
                                  " the layer under a rigid indenter; leave " +
                                  c.indenter.body->key() + " out");
}

/// What a case condenses, on its way into the cache: its layer, its indenter's body.
class Order {
  public:
    explicit Order(const CondenseOptions& options)
        : case_(io::read_case(options.file, options.overrides)),
          cache_(case_.of<fem::Settings>().cache) {
        io::refuse_rolling_on(case_, options.file);
        if (cache_.folder().empty())
            throw contact::InputError(
                "fem.cache: cache condense keeps the layer for later runs, but nothing is to be "
                "kept; "
                "name a folder");
    }

    /// The next body that is not there already; empty: there is none any more.
    std::optional<fem::LayerProblem> problem() {
        if (!is_read_) read();
        while (!bodies_.empty()) {
            auto [what, problem] = std::move(bodies_.front());
            bodies_.erase(bodies_.begin());
            what_ = what;
            key_ = fem::LayerCache::key(problem);
            n_elements_ = problem.mesh.hexes.size();
            auto claim = cache_.claim(key_, [&] {
                say(fmt::format("another process condenses this {}, which is waited for", what_));
            });
            if (claim.layer) {
                say(fmt::format("condensed {} is there already: {} ({} contact nodes)", what_,
                                cache_.path_of(key_), claim.layer->points.size()));
                continue;
            }
            if (!claim.why.empty())
                say(fmt::format("condensed {} recomputed: {}", what_, claim.why));
            reservation_ = std::move(claim.reservation);
            return std::move(problem);
        }
        return std::nullopt;
    }

    void keep(const fem::CondensedLayer& layer) {
        std::string why;
        if (!cache_.store(key_, layer, &why))
            throw std::runtime_error("condensed layer not kept: " + why);
        const auto taken = std::chrono::steady_clock::now() - start_;
        say(fmt::format("{} of {} elements condensed to {} contact nodes in {:.1f} s, kept in {}",
                        what_, n_elements_, layer.points.size(),
                        std::chrono::duration<double>(taken).count(), cache_.path_of(key_)));
        reservation_.reset();
    }

  private:
    /// The bodies that a run of the case condenses.
    void read() {
        is_read_ = true;
        if (case_.of<fem::Settings>().solver == fem::Solver::iterative)
            throw contact::InputError(
                "fem.solver: the iterative solver condenses nothing; leave it out");
        if (!case_.indenter.body) {
            bodies_.emplace_back("layer",
                                 fem::problem_of(case_, fem::make_mesh(case_, say_plainly)));
            return;
        }
        if (case_.indenter.body->mesh)
            throw contact::InputError(
                "indenter.mesh: cache condense condenses bodies of its own meshes; leave it out");
        const meshes::LayerMeshSpec spec = fem::mesh_spec(case_, say_plainly);
        bodies_.emplace_back("indenter", fem::indenter_problem(case_, spec));
        if (!case_.has_rigid_substrate)
            bodies_.emplace_back("layer", fem::problem_of(case_, make_layer_mesh(spec)));
    }

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Case case_;
    fem::LayerCache cache_;
    bool is_read_ = false;
    std::vector<std::pair<const char*, fem::LayerProblem>> bodies_;
    const char* what_ = "layer";
    std::string key_;
    std::unique_ptr<files::PartialFile> reservation_;
    std::size_t n_elements_ = 0;
};

namespace fs = std::filesystem;

std::string summary_of(const std::vector<fem::KeptLayer>& layers) {
    return fmt::format("{} condensed layer{}, {}", layers.size(), layers.size() == 1 ? "" : "s",
                       fem::size_text(fem::bytes_of(layers)));
}

Answer clear(const std::string& folder, const std::vector<fem::KeptLayer>& layers) {
    for (const fem::KeptLayer& layer : layers) {
        std::error_code error;
        fs::remove(layer.path, error);
        if (error)
            throw contact::InputError(fmt::format(
                "{}: cannot be removed ({}); check the permissions", layer.path, error.message()));
    }
    return Answer(
        [=] {
            return Json{
                {"folder", folder}, {"removed", layers.size()}, {"bytes", fem::bytes_of(layers)}}
                .dump(2);
        },
        fmt::format("{}: removed {}\n", folder, summary_of(layers)));
}

Answer write_mesh_of(CommandOptions options) {
    const Case c = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(c, options.file);
    require_rigid_indenter(c, "mesh writes");
    options.choose_folder();
    std::string geometry;  // of a mesh of our own
    meshes::HexMesh mesh;
    options.fill({{"mesh.msh", "mesh.geo", "mesh.vtu"}}, [&] {
        if (c.of<fem::Settings>().mesh) {
            mesh = fem::make_mesh(c, say_plainly);
        } else {
            const meshes::LayerMeshSpec spec = fem::mesh_spec(c, say_plainly);
            mesh = make_layer_mesh(spec);
            geometry = layer_geometry(spec);
        }
        mesh_libraries().write_mesh(mesh, options.output + "/mesh.msh");
        if (!geometry.empty()) options.write("mesh.geo", geometry);
        write_view(mesh, options.output + "/mesh.vtu",
                   "tricontact mesh " + std::filesystem::path(options.file).filename().string());
    });
    std::vector<std::string> written{"mesh.msh", "mesh.vtu"};
    if (!geometry.empty()) written.emplace_back("mesh.geo");
    return mesh_answer(mesh, options.output, written);
}

void condense_layer(const CondenseOptions& options) {
    if (options.distributed || fem::started_by_launcher()) {
        std::optional<Order> order;
        mesh_libraries().condense_together({[&] { return order.emplace(options).problem(); },
                                            [&](const auto& layer) { order->keep(layer); }, say});
        return;
    }
    Order order(options);
    while (const auto problem = order.problem()) order.keep(fem::condense(*problem));
}

/// "2026-01-31 08:15" of a layer's last use.
std::string last_use(const fem::KeptLayer& layer) {
    return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(layer.used.tv_sec));
}

Answer list_or_clear_cache(const CacheOptions& options) {
    const std::string folder = fem::LayerCache(options.folder).folder();
    if (folder.empty())
        throw contact::InputError(
            "cache: layers are kept nowhere (neither XDG_CACHE_HOME nor HOME is set, or the folder "
            "is \"none\"); name one by --folder");
    files::remove_left_partial_files(folder);
    const std::vector<fem::KeptLayer> layers = fem::kept_layers(folder);
    if (options.clear) return clear(folder, layers);
    const auto name_of = [](const fem::KeptLayer& layer) {
        return fs::path(layer.path).stem().string();
    };
    std::string text = fmt::format("{}: {}, at most {} (TRICONTACT_CACHE_LIMIT)\n", folder,
                                   summary_of(layers), fem::size_text(fem::cache_limit()));
    for (const fem::KeptLayer& layer : layers)
        text += fmt::format("{:>8}  {}  {}\n", fem::size_text(layer.bytes), last_use(layer),
                            name_of(layer));
    return Answer(
        [=] {
            Json list = Json::array();
            for (const fem::KeptLayer& layer : layers)
                list.push_back({{"key", name_of(layer)},
                                {"bytes", layer.bytes},
                                {"last_use", last_use(layer)}});
            return Json{{"folder", folder},
                        {"bytes", fem::bytes_of(layers)},
                        {"limit_bytes", fem::cache_limit()},
                        {"layers", list}}
                .dump(2);
        },
        text);
}

}  // namespace

}  // namespace tricontact::app

// What links deal.II is loaded when a mesh first needs it.
std::unique_ptr<const tricontact::fem::Q2Elements> tricontact::fem::q2_elements(
    const meshes::HexMesh& mesh, Q2Space& space) {
    return app::mesh_libraries().q2_elements(mesh, space);
}

extern "C" const tricontact::app::FemEntries* tricontact_fem_entries() {
    using namespace tricontact;
    static const app::FemEntries entries = {
        [](const app::Case& c, int n_threads, const app::Say& say) {
            return fem::make_model(c, say, n_threads);
        },
        [](const contact::ModelKind& kind, const app::Case& c, const app::Say& say) {
            return fem::make_section_model(kind, c, say);
        },
        [](const contact::ModelKind& kind, const app::Case& c) {
            return fem::section_size(kind, c);
        },
        [](const contact::ModelKind& kind, const app::Case& c, double half_width,
           const app::Say& say) {
            return kind.is_section() ? fem::section_cells(kind, c, half_width, say)
                                     : fem::body_cells(c, half_width, say);
        },
        [](const app::Case& c, const app::Say& say) { return fem::mesh_spec(c, say); },
        app::write_mesh_of,
        app::condense_layer,
        app::list_or_clear_cache,
        fem::is_further_rank,
        [](app::LoadMeshEntries* load) { app::load_mesh_entries = load; },
    };
    return &entries;
}

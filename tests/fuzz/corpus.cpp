#include "tests/fuzz/corpus.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "FoamSim/run/scene_motion.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/pvd.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/run/sealed_bytes.h"
#include "MultiTracker/run/tracking.h"
#include "tests/fuzz/harnesses.h"

namespace fuzz {

namespace fs = std::filesystem;

namespace {

fs::path file_in(const fs::path& corpus, const std::string& harness, const std::string& name) {
  fs::create_directories(corpus / harness);
  return corpus / harness / name;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

foamsim::Scene small_scene(const char* name, const std::vector<const char*>& options) {
  foamsim::Scene scene = foamsim::built_in_scene(name);
  for (const char* option : options) scene.options.set_assignment(option, "corpus");
  return scene;
}

// Two tetrahedra that share a triangle, one vertex held, with circulation.
lostopos::SurfaceData two_bubbles() {
  const lostopos::Region one{1}, two{2};
  lostopos::SurfaceData data;
  data.positions = {{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}, {0.25, 0.25, 1}, {0.25, 0.25, -1}};
  data.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  data.labels = {{one, lostopos::air}, {one, lostopos::air}, {one, lostopos::air}, {one, two},
                 {lostopos::air, two}, {lostopos::air, two}, {lostopos::air, two}};
  data.held = {{4, {0.25, 0.25, -1}}};
  data.vertex_arrays = {{"speed", 1, {1, 2, 3, 4, 5}}};
  lostopos::PairArray& circulation = data.pair_arrays.emplace_back();
  circulation.name = lostopos::rec_pair_array;
  circulation.offsets = {0, 1, 2, 2, 2, 2};
  circulation.values = {{lostopos::air, one, 0.5}, {one, two, -1}};
  return data;
}

void write_meshes(const fs::path& corpus) {
  for (const lostopos::MeshFormat& format : lostopos::mesh_formats()) {
    const std::string kind(format.extension.substr(1));
    write_surface(file_in(corpus, kind, "bubbles" + std::string(format.extension)), two_bubbles());
  }
  lostopos::SurfaceData several_blocks = two_bubbles();  // of 32 kB, which zlib makes a few bytes of
  several_blocks.vertex_arrays = {{"zero", 1000, std::vector<double>(1000 * several_blocks.positions.size(), 0)}};
  write_surface(file_in(corpus, "vtp", "blocks.vtp"), several_blocks);
  write_surface(file_in(corpus, "vtu", "blocks.vtu"), several_blocks);
  write_rec(file_in(corpus, "rec", "tracker.rec"), two_bubbles(), lostopos::RecFlavour::Tracker);
  write_text(file_in(corpus, "ply", "ascii.ply"),
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
             "face 1\nproperty list uchar int vertex_indices\nproperty int region_a\nproperty int "
             "region_b\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0\n");
  write_text(file_in(corpus, "fe", "dumped.fe"),
             "// of Evolver\nfacets_predicted 4\nSOAPFILM\nSCALE: 0.25\nVIEW_MATRIX\n 1 0 0 0\nslice_coeff = { 1, 0 "
             "}\n\nvertices /* x */\n1 0 0 0 fixed\n2 1 0 0\n3 0 1 0\n4 0 0 1 original 7\nedges\n1 1 2 fixed\n2 2 "
             "3\n3 3 1\n4 1 4 color red\n5 2 4\n6 3 4\nfaces\n1 -3 -2 -1 density 2.5 /*area 0.5*/\n2 1 5 -4 backbody "
             "1\n3 2 6 -5 tension 2\n4 3 4 -6\nbodies\n1 1 2 \\\n 3 4 volume 0.2 lagrange_multiplier 0 centerofmass "
             "original 5\nread\n");
  lostopos::write_pvd(file_in(corpus, "pvd", "two.pvd"), {{0, "a.vtp"}, {0.5, "b.vtp"}});
}

void write_texts(const fs::path& corpus) {
  write_text(
      file_in(corpus, "toml", "scene.toml"),
      "scene = \"tworingspinching\"\ndt = 0.01\n[remeshing]\nenabled = false\n[[wire]]\nselection = \"held and x "
      "< 0\"\nmotion = \"move 0.1 0 0\"\nfrom = 0.5\nuntil = 1\n");
  write_text(file_in(corpus, "options", "options.txt"),
             "# reference\nscene doublebubble\ntime-step 0.01\nmesh-size-n 8\nsigma 1.0\n");
  write_text(file_in(corpus, "tracker_options", "options.txt"),
             "scene mcf\ntime-step 0.5 # large\nsimulation-time 46\nremeshing-resolution 0.05\n");
  write_text(file_in(corpus, "grid", "grid.toml"),
             "scene = \"doublebubble\"\nsteps = 10\n[options]\ndt = 0.01\n[sweep]\nn = [8, 12]\narea = [\"naive\", "
             "\"averaged\"]\n");
}

void write_checkpoint(const fs::path& corpus, const std::string& harness, const std::string& name,
                      const lostopos::run::Motion& motion, const lostopos::run::CheckpointFormat& format) {
  nlohmann::json content;
  motion.save(content);
  const auto bytes = lostopos::run::checkpoint_bytes(format, content);
  const auto behind_the_head = lostopos::run::unsealed(bytes);
  write_text(file_in(corpus, harness, name), {behind_the_head.begin(), behind_the_head.end()});
}

void write_checkpoints(const fs::path& corpus) {
  const auto file = lostopos::run::checkpoint_bytes(plain_checkpoint, {{"n", 1}, {"list", {0.5, "a", nullptr}}});
  write_text(file_in(corpus, "checkpoint_file", "checkpoint"), {file.begin(), file.end()});
  const std::pair<const char*, foamsim::Scene> kinds[] = {
      {"checkpoint", small_scene("sphere", {"n=0", "dynamics=conservative"})},
      {"vortex_sheet", small_scene("sphere", {"n=0", "topology.enabled=true", "effects+=burst,volumes"})},
      {"wire", small_scene("tworingspinching", {"n=12", "resolution=0.4", "wires=held: pull 0.05"})},
      {"rod", small_scene("sheet", {"n=1", "dynamics=conservative"})}};
  for (const auto& [name, kind] : kinds) {
    foamsim::SceneMotion motion(foamsim::SceneMotion::beginning_of(kind));
    motion.step();
    write_checkpoint(corpus, "checkpoint", name, motion, foamsim::checkpoint_format());
  }
  const auto& scene = multitracker::scene_by_name("rotation");
  multitracker::Origin origin{.scene = &scene, .options = multitracker::options_of(scene)};
  origin.options.set_assignment("subdivisions=0", "corpus");
  multitracker::Tracking tracking(std::move(origin));
  tracking.step();
  write_checkpoint(corpus, "tracker_checkpoint", "checkpoint", tracking, multitracker::checkpoint_format());
}

}  // namespace

void write_corpus(const fs::path& folder) {
  write_meshes(folder);
  write_texts(folder);
  write_checkpoints(folder);
}

}  // namespace fuzz

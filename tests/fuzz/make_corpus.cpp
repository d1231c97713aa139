// Writes small files for every harness to begin with: make_fuzz_corpus FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/run/scene_motion.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/pvd.h"
#include "LosTopos/run/sealed_bytes.h"
#include "MultiTracker/run/tracking.h"

namespace {

namespace fs = std::filesystem;

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

void write_meshes(const fs::path& corpus) {
  const auto mesh = foamsim::build_surface(small_scene("doublebubble", {"n=8"}));
  for (const lostopos::MeshFormat& format : lostopos::mesh_formats()) {
    const std::string kind(format.extension.substr(1));
    write_surface(file_in(corpus, "fuzz_" + kind, "bubbles" + std::string(format.extension)), from_mesh(mesh));
  }
  write_text(file_in(corpus, "fuzz_ply", "ascii.ply"),
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
             "face 1\nproperty list uchar int vertex_indices\nproperty int region_a\nproperty int "
             "region_b\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0\n");
  lostopos::write_pvd(file_in(corpus, "fuzz_pvd", "two.pvd"), {{0, "a.vtp"}, {0.5, "b.vtp"}});
}

void write_texts(const fs::path& corpus) {
  write_text(
      file_in(corpus, "fuzz_toml", "scene.toml"),
      "scene = \"tworingspinching\"\ndt = 0.01\n[remeshing]\nenabled = false\n[[wire]]\nselection = \"held and x "
      "< 0\"\nmotion = \"move 0.1 0 0\"\nfrom = 0.5\nuntil = 1\n");
  write_text(file_in(corpus, "fuzz_options", "options.txt"),
             "# reference\nscene doublebubble\ntime-step 0.01\nmesh-size-n 8\nsigma 1.0\n");
  write_text(file_in(corpus, "fuzz_tracker_options", "options.txt"), "scene normal-flow\ntime-step 0.01\n");
  write_text(file_in(corpus, "fuzz_grid", "grid.toml"),
             "scene = \"doublebubble\"\nsteps = 10\n[options]\ndt = 0.01\n[sweep]\nn = [8, 12]\narea = [\"naive\", "
             "\"averaged\"]\n");
}

void write_checkpoint(const fs::path& corpus, const std::string& harness, const lostopos::run::Motion& motion,
                      const lostopos::run::CheckpointFormat& format) {
  nlohmann::json content;
  motion.save(content);
  const auto bytes = lostopos::run::checkpoint_bytes(format, content);
  const auto behind_the_head = lostopos::run::unsealed(bytes);
  write_text(file_in(corpus, harness, "checkpoint"), {behind_the_head.begin(), behind_the_head.end()});
  write_text(file_in(corpus, "fuzz_checkpoint_file", harness), {bytes.begin(), bytes.end()});
}

void write_checkpoints(const fs::path& corpus) {
  foamsim::SceneMotion bubble(
      foamsim::SceneMotion::beginning_of(small_scene("sphere", {"n=0", "dynamics=conservative"})));
  bubble.step();
  write_checkpoint(corpus, "fuzz_checkpoint", bubble, foamsim::checkpoint_format());
  const auto& scene = multitracker::scene_by_name("rotation");
  multitracker::Origin origin{.scene = &scene, .options = multitracker::options_of(scene)};
  origin.options.set_assignment("subdivisions=0", "corpus");
  multitracker::Tracking tracking(std::move(origin));
  tracking.step();
  write_checkpoint(corpus, "fuzz_tracker_checkpoint", tracking, multitracker::checkpoint_format());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    write_meshes(argv[1]);
    write_texts(argv[1]);
    write_checkpoints(argv[1]);
  } catch (const base::Error& error) {
    std::fprintf(stderr, "make_fuzz_corpus: %s\n", error.what());
    return 2;
  }
  return 0;
}

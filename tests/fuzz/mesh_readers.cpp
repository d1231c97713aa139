#include <nlohmann/json.hpp>

#include "LosTopos/io/fe.h"
#include "LosTopos/io/obj.h"
#include "LosTopos/io/ply.h"
#include "LosTopos/io/pvd.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/vtk_surface.h"
#include "LosTopos/run/checkpoint.h"
#include "tests/fuzz/harnesses.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {
namespace {

bool feed_mesh(std::span<const std::uint8_t> bytes, lostopos::SurfaceData (*read)(const std::filesystem::path&)) {
  return read_file(bytes, [read](const auto& file) { lostopos::to_mesh(read(file)); });
}

}  // namespace

bool feed_ply(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_ply);
}
bool feed_obj(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_obj);
}
bool feed_rec(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_rec);
}
bool feed_arec(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_arec);
}
bool feed_vtp(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_vtp);
}
bool feed_vtu(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_vtu);
}
bool feed_fe(std::span<const std::uint8_t> bytes) {
  return feed_mesh(bytes, lostopos::read_fe);
}
bool feed_pvd(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) { lostopos::read_pvd(file); });
}

bool feed_checkpoint_file(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) {
    lostopos::run::read_checkpoint(file, plain_checkpoint, [](const nlohmann::json&) {});
  });
}

}  // namespace fuzz

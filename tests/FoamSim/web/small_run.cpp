#include "small_run.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <fstream>

#include "LosTopos/io/base64.h"
#include "LosTopos/io/ply.h"
#include "LosTopos/io/vtk_surface.h"

namespace foamsim::web::test {

namespace fs = std::filesystem;
using lostopos::Labels;
using lostopos::Region;

namespace {

std::string numbered(const std::string& folder, long step, const std::string& ending) {
  std::string digits = std::to_string(step);
  digits.insert(0, 6 - digits.size(), '0');
  return folder + "/frame_" + digits + ending;
}

std::string opening(const std::string& name) {
  return "<script type=\"application/gzip\" data-name=\"" + name + "\">";
}

}  // namespace

lostopos::SurfaceData SmallRun::surface(long step) {
  const double size = 1 + 0.1 * static_cast<double>(step);
  lostopos::SurfaceData data;
  data.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {0, 0, -size}};
  const Labels one{Region{1}, lostopos::air}, two{Region{2}, lostopos::air}, wall{Region{1}, Region{2}};
  data.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  data.labels = {wall, one, one, one, two, two, two};
  return data;
}

SmallRun::SmallRun(bool with_fields) {
  fs::create_directory(path() / "frames");
  if (with_fields) fs::create_directory(path() / "vtp");
  write("run.json", R"({"command": "foamsim run <two>", "scene": "two", "dt": 0.5, "ended": "finished",
                        "options": {"frame_every": 2}})");
  write("metrics.csv", "step,time,area,empty\n0,0,1.5,\n2,1,1.75,\n4,2,2,\n6,3,2.25,\n");
  write("volumes.csv", "step,region,volume\n0,0,-2\n0,1,1\n0,2,1\n6,0,-3\n6,1,1.5\n6,2,1.5\n");
  write("events.csv", "step,time,kind,regions,x,y,z\n3,1.5,snap,1 2,0,0,0\n");
  for (long step = 0; step <= 6; step += 2) {
    lostopos::SurfaceData data = surface(step);
    lostopos::write_ply(frame(step), data);
    if (!with_fields) continue;
    data.vertex_arrays.push_back({"height", 1, {0, 1, 2, 3, 4}});
    data.triangle_arrays.push_back({"flow", 2, {3, 4, 0, 0, 0, 1, 6, 8, 0, 0, 0, 0, 0, 0}});
    lostopos::write_vtp(fields(step), data);
  }
}

fs::path SmallRun::frame(long step) const {
  return path() / numbered("frames", step, ".ply");
}

fs::path SmallRun::fields(long step) const {
  return path() / numbered("vtp", step, ".vtp");
}

void SmallRun::write(const std::string& name, const std::string& text) const {
  std::ofstream(path() / name) << text;
}

std::string gunzip(const std::string& bytes) {
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string result;
  std::array<Bytef, 4096> piece;
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = piece.data();
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(reinterpret_cast<const char*>(piece.data()), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  EXPECT_EQ(state, Z_STREAM_END);
  return result;
}

std::string element(const std::string& page, const std::string& name) {
  const std::string open = opening(name);
  const std::size_t begin = page.find(open);
  if (begin == std::string::npos) return {};
  const std::size_t text = begin + open.size();
  return gunzip(lostopos::base64_decode(page.substr(text, page.find("</script>", text) - text)).value_or(""));
}

std::vector<std::string> element_names(const std::string& page) {
  const std::string before = "data-name=\"";
  std::vector<std::string> names;
  for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at + 1)) {
    const std::size_t begin = at + before.size();
    names.push_back(page.substr(begin, page.find('"', begin) - begin));
  }
  return names;
}

}  // namespace foamsim::web::test

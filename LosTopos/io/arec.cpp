#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/surface_checks.h"
#include "LosTopos/io/text_reader.h"

namespace lostopos {
namespace {

std::uint64_t read_count(TextReader& text, std::uint64_t words_each, const char* what) {
  const std::string name = std::string("the number of ") + what;
  const std::int64_t count = text.integer(name.c_str());
  if (count < 0) text.fail(name + " is " + std::to_string(count) + "; it cannot be negative");
  text.require_records(static_cast<std::uint64_t>(count), words_each, what);
  return static_cast<std::uint64_t>(count);
}

void reject(const TextReader& text, const std::string& problem) {
  if (!problem.empty()) text.fail(problem);
}

void append_integer(std::string& line, std::uint64_t value) {
  base::append_number(line, static_cast<std::int64_t>(value));
}

}  // namespace

SurfaceData read_arec(const std::filesystem::path& path) {
  TextReader text = TextReader::of_file(path);
  SurfaceData data;
  const std::uint64_t vertices = read_count(text, 3, "vertices");
  reject(text, vertex_count_problem(vertices));
  data.positions.reserve(vertices);
  for (std::uint64_t v = 0; v < vertices; ++v) {
    Vec3 position;
    for (int i = 0; i < 3; ++i) position[i] = text.number("a coordinate");
    reject(text, position_problem(position));
    data.positions.push_back(position);
  }
  const std::uint64_t triangles = read_count(text, 5, "triangles");
  reject(text, triangle_count_problem(triangles));
  data.triangles.reserve(triangles);
  data.labels.reserve(triangles);
  for (std::uint64_t t = 0; t < triangles; ++t) {
    std::array<std::int64_t, 3> corners{};
    for (std::int64_t& corner : corners) corner = text.integer("a vertex number");
    const std::int64_t p = text.integer("a label"), q = text.integer("a label");
    reject(text, corner_problem(corners, vertices));
    reject(text, label_problem(p, q));
    data.triangles.push_back(checked_corners(corners));
    data.labels.push_back(checked_labels(p, q));
  }
  if (const std::string_view word = text.next_word(); !word.empty())
    text.fail(in_quotes(word) + " follows the last triangle; a count is too small");
  require_edges_in_range(data, path.string());
  return data;
}

void write_arec(const std::filesystem::path& path, const SurfaceData& data) {
  validate(data);
  base::AtomicFile file(path);
  file.stream() << data.positions.size() << '\n';
  std::string line;
  for (const Vec3& position : data.positions) {
    line.clear();
    for (int i = 0; i < 3; ++i) {
      base::append_number(line, position[i]);
      line += i < 2 ? ' ' : '\n';
    }
    file.stream() << line;
  }
  file.stream() << data.triangles.size() << '\n';
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    line.clear();
    for (const std::uint32_t corner : data.triangles[t]) append_integer(line, corner), line += ' ';
    append_integer(line, data.labels[t].p.index());
    append_integer(line += ' ', data.labels[t].q.index());
    file.stream() << (line += '\n');
  }
  file.commit();
}

}  // namespace lostopos

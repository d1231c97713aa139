#include "FoamSim/studies/reproduce/table1_csv.h"

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/csv_table.h"
#include "Base/options/option_value.h"

namespace foamsim {
namespace {

constexpr const char* header =
    "area,n,triangles_start,triangles,angle_rms_deg,angle_rms_film_deg,published_deg,difference_deg,"
    "angle_outer_mean_deg,angle_outer_mean_film_deg,exact_facets_deg,border_height,volume_drift_max,centroid_drift,"
    "steps,time,cpu_"
    "seconds,"
    "wall_seconds,ended";

std::string text(const std::optional<double>& value) {
  return value ? base::to_text(*value) : "";
}

std::string line_of(const Table1Row& r) {
  std::string line = r.area;
  for (const std::string& cell :
       {std::to_string(r.n), std::to_string(r.triangles_start), std::to_string(r.triangles), text(r.angle_rms_deg),
        text(r.angle_rms_film_deg), text(r.published_deg), text(r.difference_deg()), text(r.angle_outer_mean_deg),
        text(r.angle_outer_mean_film_deg), text(r.exact_facets_deg), text(r.border_height), text(r.volume_drift_max),
        text(r.centroid_drift), std::to_string(r.steps), text(r.time), text(r.cpu_seconds), text(r.wall_seconds),
        r.ended})
    line += ',' + cell;
  return line;
}

Table1Row parse(const std::vector<std::string>& cells) {
  auto number = [&](std::size_t i) { return std::get<double>(base::parse_option(cells[i], 0.0)); };
  auto whole = [&](std::size_t i) { return std::get<long>(base::parse_option(cells[i], 0L)); };
  auto optional = [&](std::size_t i) { return cells[i].empty() ? std::optional<double>() : number(i); };
  Table1Row r;
  r.area = cells[0];
  r.n = whole(1);
  r.triangles_start = whole(2);
  r.triangles = whole(3);
  r.angle_rms_deg = optional(4);
  r.angle_rms_film_deg = optional(5);
  r.published_deg = optional(6);
  r.angle_outer_mean_deg = optional(8);
  r.angle_outer_mean_film_deg = optional(9);
  r.exact_facets_deg = number(10);
  r.border_height = number(11);
  r.volume_drift_max = number(12);
  r.centroid_drift = number(13);
  r.steps = whole(14);
  r.time = number(15);
  r.cpu_seconds = number(16);
  r.wall_seconds = number(17);
  r.ended = cells[18];
  return r;
}

}  // namespace

void write_table1(const std::filesystem::path& file, const std::vector<Table1Row>& rows) {
  base::AtomicFile out(file);
  out.stream() << header << '\n';
  for (const Table1Row& row : rows) out.stream() << line_of(row) << '\n';
  out.commit();
}

std::vector<Table1Row> read_table1(const std::filesystem::path& file) {
  std::vector<Table1Row> rows;
  base::read_csv(file, header, [&](const std::vector<std::string>& cells) { rows.push_back(parse(cells)); });
  return rows;
}

}  // namespace foamsim

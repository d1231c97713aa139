#include "FoamSim/statistics/statistics_tables.h"

#include <array>
#include <cmath>
#include <map>

#include "Base/io/csv_columns.h"

namespace foamsim {
namespace {

using base::cell_text;

std::optional<double> rate(const FrameStatistics& frame, long EventCounts::*kind) {
  if (!frame.events || !(frame.time > frame.since)) return std::nullopt;
  return static_cast<double>((*frame.events).*kind) / (frame.time - frame.since);
}

std::string count(const FrameStatistics& frame, long EventCounts::*kind) {
  return frame.events ? cell_text((*frame.events).*kind) : std::string();
}

using FoamColumn = base::CsvColumn<FrameStatistics>;
using F = FrameStatistics;

constexpr auto foam_columns = std::to_array<FoamColumn>({
    {"step", [](const F& f) { return cell_text(f.step); }},
    {"time", [](const F& f) { return cell_text(f.time); }},
    {"bubbles", [](const F& f) { return cell_text(f.foam.bubbles.size()); }},
    {"inner_bubbles", [](const F& f) { return cell_text(f.foam.inner_bubbles()); }},
    {"films", [](const F& f) { return cell_text(f.foam.network.films.size()); }},
    {"borders", [](const F& f) { return cell_text(f.foam.network.borders.size()); }},
    {"vertices", [](const F& f) { return cell_text(f.foam.network.vertices.size()); }},
    {"film_area", [](const F& f) { return cell_text(f.foam.film_area()); }},
    {"border_length", [](const F& f) { return cell_text(f.foam.border_length()); }},
    {"volume_mean", [](const F& f) { return cell_text(f.foam.volumes().mean); }},
    {"volume_deviation", [](const F& f) { return cell_text(f.foam.volumes().deviation); }},
    {"polydispersity", [](const F& f) { return cell_text(f.foam.polydispersity()); }},
    {"faces_mean", [](const F& f) { return cell_text(f.foam.faces().mean); }},
    {"faces_deviation", [](const F& f) { return cell_text(f.foam.faces().deviation); }},
    {"inner_faces_mean", [](const F& f) { return cell_text(f.foam.inner_faces().mean); }},
    {"film_edges_mean", [](const F& f) { return cell_text(f.foam.film_edges().mean); }},
    {"film_edges_deviation", [](const F& f) { return cell_text(f.foam.film_edges().deviation); }},
    {"neighbours_mean", [](const F& f) { return cell_text(f.foam.neighbours().mean); }},
    {"pressure_mean", [](const F& f) { return cell_text(f.foam.pressures().mean); }},
    {"pressure_deviation", [](const F& f) { return cell_text(f.foam.pressures().deviation); }},
    {"t1", [](const F& f) { return count(f, &EventCounts::t1); }},
    {"bursts", [](const F& f) { return count(f, &EventCounts::bursts); }},
    {"vanished", [](const F& f) { return count(f, &EventCounts::vanished); }},
    {"t1_rate", [](const F& f) { return cell_text(rate(f, &EventCounts::t1)); }},
    {"burst_rate", [](const F& f) { return cell_text(rate(f, &EventCounts::bursts)); }},
    {"vanished_rate", [](const F& f) { return cell_text(rate(f, &EventCounts::vanished)); }},
});

template <class Counted>
struct Item {
  const FrameStatistics& frame;
  const Counted& counted;
};
using Bubble = Item<BubbleStatistics>;
using Sheet = Item<Film>;

constexpr auto bubble_columns = std::to_array<base::CsvColumn<Bubble>>({
    {"step", [](const Bubble& b) { return cell_text(b.frame.step); }},
    {"time", [](const Bubble& b) { return cell_text(b.frame.time); }},
    {"region", [](const Bubble& b) { return cell_text(std::size_t{b.counted.region.index()}); }},
    {"volume", [](const Bubble& b) { return cell_text(b.counted.volume); }},
    {"area", [](const Bubble& b) { return cell_text(b.counted.area); }},
    {"air_area", [](const Bubble& b) { return cell_text(b.counted.air_area); }},
    {"faces", [](const Bubble& b) { return cell_text(b.counted.faces); }},
    {"edges", [](const Bubble& b) { return cell_text(b.counted.edges); }},
    {"loops", [](const Bubble& b) { return cell_text(b.counted.loops); }},
    {"vertices", [](const Bubble& b) { return cell_text(b.counted.vertices); }},
    {"neighbours", [](const Bubble& b) { return cell_text(b.counted.neighbours); }},
    {"pressure", [](const Bubble& b) { return cell_text(b.counted.pressure); }},
});

constexpr auto film_columns = std::to_array<base::CsvColumn<Sheet>>({
    {"step", [](const Sheet& f) { return cell_text(f.frame.step); }},
    {"time", [](const Sheet& f) { return cell_text(f.frame.time); }},
    {"region_a", [](const Sheet& f) { return cell_text(std::size_t{f.counted.regions.low.index()}); }},
    {"region_b", [](const Sheet& f) { return cell_text(std::size_t{f.counted.regions.high.index()}); }},
    {"area", [](const Sheet& f) { return cell_text(f.counted.area); }},
    {"edges", [](const Sheet& f) { return cell_text(f.counted.borders.size()); }},
    {"vertices", [](const Sheet& f) { return cell_text(f.counted.vertices.size()); }},
});

template <class Counted, class Columns>
std::string rows_of(const FrameStatistics& frame, const std::vector<Counted>& list, const Columns& columns) {
  std::string rows;
  for (const Counted& counted : list)
    rows += base::csv_row(std::span<const base::CsvColumn<Item<Counted>>>(columns), {frame, counted});
  return rows;
}

std::string histogram_rows(const FrameStatistics& frame, const std::string& quantity,
                           const std::map<double, std::size_t>& counts) {
  std::string rows;
  for (const auto& [value, number] : counts)
    rows += cell_text(frame.step) + "," + cell_text(frame.time) + "," + quantity + "," + cell_text(value) + "," +
            cell_text(number) + "\n";
  return rows;
}

// Bubbles by volume over the mean.
std::map<double, std::size_t> volume_histogram(const FoamStatistics& foam) {
  constexpr double bins_per_mean = 5;
  std::map<double, std::size_t> counts;
  const std::optional<double> mean = foam.volumes().mean;
  if (!mean || !(*mean > 0)) return counts;
  for (const BubbleStatistics& bubble : foam.bubbles)
    if (bubble.volume) ++counts[(std::floor(bins_per_mean * *bubble.volume / *mean) + 0.5) / bins_per_mean];
  return counts;
}

}  // namespace

std::string foam_table_header() {
  return base::csv_header(std::span<const FoamColumn>(foam_columns)) + "\n";
}
std::string foam_table_row(const FrameStatistics& frame) {
  return base::csv_row(std::span<const FoamColumn>(foam_columns), frame);
}
std::string bubble_table_header() {
  return base::csv_header(std::span<const base::CsvColumn<Bubble>>(bubble_columns)) + "\n";
}
std::string bubble_table_rows(const FrameStatistics& frame) {
  return rows_of(frame, frame.foam.bubbles, bubble_columns);
}
std::string film_table_header() {
  return base::csv_header(std::span<const base::CsvColumn<Sheet>>(film_columns)) + "\n";
}
std::string film_table_rows(const FrameStatistics& frame) {
  return rows_of(frame, frame.foam.network.films, film_columns);
}

std::string distribution_table_header() {
  return "step,time,quantity,value,count\n";
}
std::string distribution_table_rows(const FrameStatistics& frame) {
  std::map<double, std::size_t> faces, neighbours, edges;
  for (const BubbleStatistics& bubble : frame.foam.bubbles) {
    ++faces[static_cast<double>(bubble.faces)];
    ++neighbours[static_cast<double>(bubble.neighbours)];
  }
  for (const Film& film : frame.foam.network.films) ++edges[static_cast<double>(film.borders.size())];
  return histogram_rows(frame, "faces", faces) + histogram_rows(frame, "neighbours", neighbours) +
         histogram_rows(frame, "film_edges", edges) + histogram_rows(frame, "volume", volume_histogram(frame.foam));
}

}  // namespace foamsim

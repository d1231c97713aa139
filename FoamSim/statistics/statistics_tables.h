#pragma once

#include <optional>
#include <string>

#include "FoamSim/statistics/event_counts.h"
#include "FoamSim/statistics/foam_statistics.h"

namespace foamsim {

/// A frame of a run and what was counted on it.
struct FrameStatistics {
  long step = 0;
  double time = 0;  ///< T
  FoamStatistics foam;
  /// Since the frame before; none for the first, and where no events were recorded.
  std::optional<EventCounts> events = {};
  double since = 0;  ///< the frame before, T
};

/// Tables as docs/output.md describes them ("Statistics"): a header line, and of a frame its rows, each with a newline.
///@{
std::string foam_table_header();
std::string foam_table_row(const FrameStatistics& frame);
/// A row a bubble.
std::string bubble_table_header();
std::string bubble_table_rows(const FrameStatistics& frame);
/// A row a film.
std::string film_table_header();
std::string film_table_rows(const FrameStatistics& frame);
/// A row for each value that occurs: bubbles by faces, by neighbours, and by volume over the mean in bins a fifth wide,
/// of which the row has the middle; films by Plateau borders.
std::string distribution_table_header();
std::string distribution_table_rows(const FrameStatistics& frame);
///@}

}  // namespace foamsim

// docs/output.md names every column of the tables, in the order in which they are written; CITATION.cff the version.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "FoamSim/metrics/metrics_csv.h"
#include "FoamSim/statistics/statistics_tables.h"
#include "FoamSim/version.h"
#include "MultiTracker/run/metrics_csv.h"

namespace {

// First cells of the table below a heading, joined by commas.
std::string columns_below(const std::string& heading) {
  std::ifstream file(FOAMSIM_DOCS "/output.md");
  std::string line, columns;
  while (std::getline(file, line) && line != heading) {
  }
  while (std::getline(file, line) && !line.starts_with("## "))
    if (line.starts_with("| `")) columns += (columns.empty() ? "" : ",") + line.substr(3, line.find('`', 3) - 3);
  return columns;
}

TEST(OutputDocument, NamesTheColumnsOfFoamsim) {
  EXPECT_EQ(columns_below("## metrics.csv"), foamsim::metrics_header());
}

TEST(OutputDocument, NamesTheColumnsOfMultitracker) {
  EXPECT_EQ(columns_below("## multitracker's metrics.csv"), multitracker::metrics_header());
}

TEST(OutputDocument, NamesTheColumnsOfStatistics) {
  EXPECT_EQ(columns_below("## foam.csv") + "\n", foamsim::foam_table_header());
  EXPECT_EQ(columns_below("## bubbles.csv") + "\n", foamsim::bubble_table_header());
  EXPECT_EQ(columns_below("## films.csv") + "\n", foamsim::film_table_header());
  EXPECT_EQ(columns_below("## distributions.csv") + "\n", foamsim::distribution_table_header());
}

// What is cited is what this is.
TEST(CitationFile, HasTheVersion) {
  std::ifstream file(FOAMSIM_DOCS "/../CITATION.cff");
  std::string line;
  while (std::getline(file, line) && !line.starts_with("version: ")) {
  }
  EXPECT_EQ(line, "version: " + std::string(foamsim::version));
}

}  // namespace

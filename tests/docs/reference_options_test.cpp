// docs/reference-options.md holds the tables of keys as the programs read them.
#include "FoamSim/scenes/reference_options.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "MultiTracker/scenes/reference_options.h"

namespace {

std::string document() {
  std::ostringstream text;
  text << std::ifstream(FOAMSIM_DOCS "/reference-options.md").rdbuf();
  return text.str();
}

TEST(ReferenceOptionsDocument, HoldsTheKeysOfFoamsim) {
  const std::string rows = lostopos::reference_key_rows(foamsim::reference_keys());
  EXPECT_NE(document().find(rows), std::string::npos) << "it should have these rows:\n" << rows;
}

TEST(ReferenceOptionsDocument, HoldsTheKeysOfMultitracker) {
  const std::string rows = lostopos::reference_key_rows(multitracker::reference_keys());
  EXPECT_NE(document().find(rows), std::string::npos) << "it should have these rows:\n" << rows;
}

}  // namespace

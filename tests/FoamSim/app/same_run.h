#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tables.h"
#include "tests/support/run_program.h"

namespace foamsim::test {

/// Two folders of runs have the same files with the same bits, wall times, machines and the column `but_for`
/// of metrics.csv left out.
inline void expect_same_files(const std::filesystem::path& one, const std::filesystem::path& other,
                              const std::string& but_for = "") {
  std::vector<std::filesystem::path> names;
  for (const std::filesystem::path& folder : {one, other})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder));
  for (const std::filesystem::path& name : names) {
    ASSERT_TRUE(std::filesystem::exists(one / name) && std::filesystem::exists(other / name)) << name;
    const std::string a = ::test::read_file(one / name), b = ::test::read_file(other / name);
    if (name == "run.json") {
      for (const char* key : {"ended", "last_step", "time", "options", "last_frame"})
        EXPECT_EQ(nlohmann::json::parse(a)[key], nlohmann::json::parse(b)[key]) << key;
    } else if (name == "metrics.csv") {
      EXPECT_EQ(without_seconds(a, but_for), without_seconds(b, but_for));
    } else if (name != "checkpoint.cbor") {  // which holds seconds, too
      EXPECT_TRUE(a == b) << name;
    }
  }
}

}  // namespace foamsim::test

#include "tests/regression/reference_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "Base/io/atomic_file.h"
#include "Base/io/csv_table.h"
#include "Base/options/option_value.h"

namespace foamsim::test {
namespace {

constexpr const char* header = "quantity,value,tolerance,published";

struct Stored {
  std::string quantity;
  double value, tolerance;
  std::string published;  // for the reader of a failure
};

std::vector<Stored> read_all() {
  std::vector<Stored> all;
  base::read_csv(FOAMSIM_REFERENCE_FILE, header, [&](const std::vector<std::string>& cells) {
    all.push_back({cells[0], std::get<double>(base::parse_option(cells[1], 0.0)),
                   std::get<double>(base::parse_option(cells[2], 0.0)), cells[3]});
  });
  return all;
}

void write_all(const std::vector<Stored>& all) {
  base::AtomicFile out(FOAMSIM_REFERENCE_FILE);
  out.stream() << header << '\n';
  for (const Stored& s : all)
    out.stream() << s.quantity << ',' << base::to_text(s.value) << ',' << base::to_text(s.tolerance) << ','
                 << s.published << '\n';
  out.commit();
}

}  // namespace

void expect_stored(const std::string& quantity, double measured) {
  std::vector<Stored> all = read_all();
  for (Stored& s : all) {
    if (s.quantity != quantity) continue;
    if (std::getenv("FOAMSIM_REFRESH_REFERENCE") != nullptr) {
      s.value = measured;
      write_all(all);
    } else {
      EXPECT_LE(std::abs(measured - s.value), s.tolerance)
          << quantity << ": stored " << s.value << ", now " << measured << ", tolerance " << s.tolerance
          << (s.published.empty() ? "" : ", published " + s.published)
          << "\nIf that is meant, store it: FOAMSIM_REFRESH_REFERENCE=1 build/bin/test_regression";
    }
    return;
  }
  ADD_FAILURE() << "no stored value of " << quantity << " (measured: " << measured
                << "); add a row with a tolerance to " << FOAMSIM_REFERENCE_FILE;
}

}  // namespace foamsim::test

#include "Base/io/csv_table.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "tests/support/run_program.h"

namespace base {
namespace {

using ::test::read_file;
using ::test::ScratchFolder;

TEST(CsvTable, IsCutBackToAStep) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "a.csv") << "step,x\n0,1\n5,2\n10,3\n";
  keep_rows_until(scratch / "a.csv", 5);
  EXPECT_EQ(read_file(scratch / "a.csv"), "step,x\n0,1\n5,2\n");
}

// "10" may be the beginning of the row of step 101.
TEST(CsvTable, LosesARowThatWasNotWrittenToItsEnd) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "a.csv") << "step,x\n99,1\n100,2\n10";
  keep_rows_until(scratch / "a.csv", 100);
  EXPECT_EQ(read_file(scratch / "a.csv"), "step,x\n99,1\n100,2\n");
}

TEST(CsvTable, TellsAFullDiskFromAPlaceThatCannotBe) {
  const ScratchFolder scratch;
  try {
    CsvTable nowhere(scratch / "none/a.csv", "step");
    FAIL();
  } catch (const DiskError&) {
    FAIL();
  } catch (const FileError&) {
  }
  EXPECT_THROW(CsvTable("/dev/full", "step"), DiskError);
}

}  // namespace
}  // namespace base

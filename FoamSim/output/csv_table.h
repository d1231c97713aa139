#pragma once

#include "LosTopos/io/csv_table.h"

namespace foamsim {

using lostopos::CsvTable;
using lostopos::keep_rows_until;
using lostopos::read_csv;

}  // namespace foamsim

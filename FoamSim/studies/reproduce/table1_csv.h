#pragma once

#include <filesystem>
#include <vector>

#include "FoamSim/studies/reproduce/table1.h"

namespace foamsim {

/// Writes all rows at once: the file is whole or as it was. Throws base::FileError.
void write_table1(const std::filesystem::path& file, const std::vector<Table1Row>& rows);
/// Throws base::InputError with file and line when it is malformed.
std::vector<Table1Row> read_table1(const std::filesystem::path& file);

}  // namespace foamsim

#include "FoamSim/web/read_text.h"

#include <fstream>
#include <iterator>

#include "Base/error.h"

namespace foamsim::web {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw base::FileError("cannot read '" + file.string() + "'");
  return text;
}

}  // namespace foamsim::web

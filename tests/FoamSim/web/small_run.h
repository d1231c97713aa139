#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"
#include "tests/support/scratch_folder.h"

namespace foamsim::web::test {

/// A page that has a place for a title and a run.
inline const std::string stub_page = "<title><!-- title --></title>\n<!-- run -->\n<p>end</p>\n";

/// The folder of a run of two tetrahedra that share a face (regions 1 and 2), a frame every 2 steps up to step 6,
/// larger from frame to frame.
class SmallRun {
 public:
  explicit SmallRun(bool with_fields = false);

  std::filesystem::path path() const { return scratch_.path(); }
  std::filesystem::path frame(long step) const;
  std::filesystem::path fields(long step) const;
  void write(const std::string& name, const std::string& text) const;
  static lostopos::SurfaceData surface(long step);

 private:
  ::test::ScratchFolder scratch_;
};

/// The content of the elements of an exported page, by name, decompressed.
std::string element(const std::string& page, const std::string& name);
std::vector<std::string> element_names(const std::string& page);

/// What gzip made of some bytes.
std::string gunzip(const std::string& bytes);

}  // namespace foamsim::web::test

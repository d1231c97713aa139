// Files that were cut short or whose bytes were changed: every reader gives an InputError or a valid surface, and asks
// for no more memory than the file can justify.

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <random>

#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/pvd.h"
#include "LosTopos/io/rec.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace {
std::atomic<std::size_t> largest_request{0};
}  // namespace

// Notes the largest single request of the program. Not inlined: GCC would then see the `new` of one and the `free` of
// the other, and warn. The form that does not throw (std::stable_sort asks by it) is replaced as well: the address
// sanitizer's own would not come here, and its memory would meet the `free` below.
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  std::size_t seen = largest_request;
  while (bytes > seen && !largest_request.compare_exchange_weak(seen, bytes)) {
  }
  return std::malloc(bytes);
}
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  if (void* memory = operator new(bytes, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace lostopos {
namespace {

// The files here have a few kilobytes; buffers of a fixed size are larger than what they hold.
constexpr std::size_t justified_bytes = std::size_t{1} << 20U;

struct Sample {
  std::string name;
  std::string content;
  std::function<void(const std::filesystem::path&)> read;
};

void read_and_make_mesh(const std::filesystem::path& path) {
  to_mesh(read_surface(path));
}

class DamagedFileTest : public IoTest {
 protected:
  std::vector<Sample> samples() {
    SurfaceData data = two_tetrahedra_with_circulation();
    data.vertex_arrays = {{"speed", 1, std::vector<double>(6, 0.1)}};
    std::vector<Sample> all;
    for (const MeshFormat& format : mesh_formats()) {
      const std::string name = "sample" + std::string(format.extension);
      write_surface(path(name), data);
      all.push_back({name, content_of(path(name)), read_and_make_mesh});
    }
    write_rec(path("tracker.rec"), data, RecFlavour::Tracker);
    all.push_back({"tracker.rec", content_of(path("tracker.rec")), read_and_make_mesh});
    all.push_back({"ascii.ply", ascii_ply(), read_and_make_mesh});
    write_pvd(path("sample.pvd"), {{0, "a.vtp"}, {0.5, "b.vtp"}});
    all.push_back({"sample.pvd", content_of(path("sample.pvd")), [](const auto& file) { read_pvd(file); }});
    return all;
  }

  static std::string ascii_ply() {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty list uchar int l\nproperty float y\n"
           "property float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty int region_a\n"
           "property int region_b\nend_header\n0 1 5 0 0\n1 0 0 0\n0 0 1 0\n0 2 7 8 1 1\n3 0 1 2 1 0\n3 1 2 3 2 0\n";
  }

  // True when the file was read, false for an InputError; anything else fails the test.
  bool read_damaged(const Sample& sample, const std::string& content, const std::string& what) {
    const auto file = path("damaged-" + sample.name);
    std::filesystem::remove(file);  // some file systems wait for the disk when a file's content is replaced
    write(file.filename(), content);
    largest_request = 0;
    bool good = false;
    try {
      sample.read(file);
      good = true;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged-"), std::string::npos) << what << ": " << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << sample.name << ", " << what << ": " << error.what();
    }
    EXPECT_LE(largest_request, justified_bytes) << sample.name << ", " << what;
    return good;
  }
};

TEST_F(DamagedFileTest, UndamagedFilesAreRead) {
  for (const Sample& sample : samples()) EXPECT_TRUE(read_damaged(sample, sample.content, "whole")) << sample.name;
}

TEST_F(DamagedFileTest, CutShortAtEveryByte) {
  for (const Sample& sample : samples()) {
    const bool text = sample.name.ends_with("obj") || sample.name.ends_with("arec") || sample.name.ends_with("fe") ||
                      sample.name == "ascii.ply";
    std::size_t read = 0;
    for (std::size_t size = 0; size < sample.content.size(); ++size)
      read += read_damaged(sample, sample.content.substr(0, size), "cut to " + std::to_string(size)) ? 1 : 0;
    // A text may lose its last digits and an OBJ its last lines unnoticed; all else has to be noticed but for the
    // newline at the end.
    if (!text) {
      EXPECT_LE(read, 1U) << sample.name;
    }
    EXPECT_LT(read, sample.content.size()) << sample.name;
  }
}

TEST_F(DamagedFileTest, BytesChangedAtRandom) {
  std::mt19937_64 random(20240229);
  constexpr int files = 500;
  for (const Sample& sample : samples()) {
    for (int i = 0; i < files; ++i) {
      std::string content = sample.content;
      const std::uint64_t changes = 1 + random() % 8;
      for (std::uint64_t k = 0; k < changes; ++k) {
        char& byte = content[random() % content.size()];
        // Bits turned over hit binary numbers, other digits hit text.
        byte = random() % 2 == 0 ? static_cast<char>(byte ^ (1 << (random() % 8)))
                                 : "0123456789-.eE \n/<>\"\0\xff"[random() % 23];
      }
      read_damaged(sample, content, "changed, file " + std::to_string(i));
    }
  }
}

// Whole counts replaced: the numbers that overflow a product, a sum, or memory.
TEST_F(DamagedFileTest, AbsurdNumbersInEveryPlaceOfABinaryFile) {
  const std::uint64_t numbers[] = {0,
                                   1,
                                   0x7fffffff,
                                   0x80000000,
                                   0xffffffff,
                                   std::uint64_t{1} << 32U,
                                   std::uint64_t{1} << 60U,
                                   0x0aaaaaaaaaaaaaab,
                                   0x7fffffffffffffff,
                                   0x8000000000000000,
                                   ~std::uint64_t{0}};
  for (const Sample& sample : samples()) {
    if (!sample.name.ends_with(".rec")) continue;
    for (std::size_t place = 0; place + 8 <= sample.content.size(); place += 8) {
      for (const std::uint64_t number : numbers) {
        std::string raw;
        append_bytes(raw, number);
        read_damaged(sample, std::string(sample.content).replace(place, 8, raw), "number at " + std::to_string(place));
      }
    }
  }
}

TEST_F(DamagedFileTest, PiecesExchangedAtRandom) {
  std::mt19937_64 random(7);
  const std::vector<Sample> all = samples();
  for (const Sample& sample : all) {
    for (int i = 0; i < 200; ++i) {
      std::string content = sample.content;
      const std::string& other = all[random() % all.size()].content;
      const std::size_t from = random() % other.size(), to = random() % content.size();
      content.replace(to, random() % 40, other, from, random() % 40);
      read_damaged(sample, content, "exchanged, file " + std::to_string(i));
    }
  }
}

}  // namespace
}  // namespace lostopos

#include "LosTopos/io/rec_layout.h"

#include <optional>

#include "LosTopos/io/read_error.h"

namespace lostopos {
namespace {

constexpr std::uint64_t word = sizeof(std::uint64_t);
constexpr std::uint64_t position_bytes = 3 * sizeof(double);
constexpr std::uint64_t triangle_bytes = 3 * word + 2 * sizeof(std::int32_t);
constexpr std::uint64_t held_bytes = word + position_bytes;

// Goes through the counts of a file as if it had one flavour; stops at the first that cannot be.
class LayoutTrial {
 public:
  LayoutTrial(ByteReader& bytes, RecFlavour flavour) : bytes_(bytes) {
    bytes_.seek(0);
    layout_.flavour = flavour;
    good_ = flavour == RecFlavour::SoapFilm ? try_soap_film() : try_tracker();
    if (good_ && bytes_.remaining() > 0) {
      good_ = false;
      problem_ = std::to_string(bytes_.remaining()) + " bytes are left over";
    }
    stopped_at_ = bytes_.position();
  }

  bool good() const { return good_; }
  const RecLayout& layout() const { return layout_; }
  const std::string& problem() const { return problem_; }
  std::uint64_t stopped_at() const { return stopped_at_; }

 private:
  bool try_soap_film() {
    constexpr std::uint64_t most_regions = std::uint64_t{1} << 28U;  // n² numbers are then still counted in 64 bits
    const auto regions = read_count("regions");
    if (!regions) return false;
    if (*regions > most_regions) return stop("a count of " + std::to_string(*regions) + " regions");
    layout_.regions = *regions;
    const std::uint64_t vertex_bytes = position_bytes + *regions * *regions * sizeof(double);
    return records("vertices", vertex_bytes, layout_.vertices, layout_.vertices_at) &&
           records("triangles", triangle_bytes, layout_.triangles, layout_.triangles_at) &&
           records("held vertices", held_bytes, layout_.held, layout_.held_at);
  }

  bool try_tracker() {
    return records("vertices", position_bytes, layout_.vertices, layout_.vertices_at) &&
           records("triangles", triangle_bytes, layout_.triangles, layout_.triangles_at);
  }

  // A count and that many records, which are passed over.
  bool records(const char* what, std::uint64_t bytes_each, std::uint64_t& count, std::uint64_t& first_at) {
    const auto number = read_count(what);
    if (!number) return false;
    if (*number > bytes_.remaining() / bytes_each)
      return stop(std::to_string(*number) + " " + what + " of " + std::to_string(bytes_each) +
                  " bytes each should follow, but only " + std::to_string(bytes_.remaining()) + " bytes do");
    count = *number;
    first_at = bytes_.position();
    bytes_.skip(*number * bytes_each);
    return true;
  }

  std::optional<std::uint64_t> read_count(const char* what) {
    if (bytes_.remaining() >= word) return bytes_.read<std::uint64_t>();
    stop(std::string("the file ends where the number of ") + what + " should follow");
    return std::nullopt;
  }

  bool stop(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  ByteReader& bytes_;
  RecLayout layout_;
  bool good_ = false;
  std::string problem_;
  std::uint64_t stopped_at_ = 0;
};

}  // namespace

RecLayout find_rec_layout(ByteReader& bytes) {
  const LayoutTrial soap_film(bytes, RecFlavour::SoapFilm);
  if (soap_film.good()) return soap_film.layout();
  const LayoutTrial tracker(bytes, RecFlavour::Tracker);
  if (tracker.good()) return tracker.layout();
  throw_at_byte(bytes.name(), std::max(soap_film.stopped_at(), tracker.stopped_at()),
                "no flavour of .rec fits the file. Read as a soap-film record, at byte " +
                    std::to_string(soap_film.stopped_at()) + ": " + soap_film.problem() +
                    ". Read as a tracker record, at byte " + std::to_string(tracker.stopped_at()) + ": " +
                    tracker.problem());
}

bool is_rec(ByteReader& bytes) {
  return LayoutTrial(bytes, RecFlavour::SoapFilm).good() || LayoutTrial(bytes, RecFlavour::Tracker).good();
}

}  // namespace lostopos

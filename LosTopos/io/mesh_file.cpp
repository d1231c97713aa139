#include "LosTopos/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "Base/error.h"
#include "Base/io/number_text.h"
#include "Base/machine/memory.h"
#include "LosTopos/io/fe.h"
#include "LosTopos/io/obj.h"
#include "LosTopos/io/ply.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/rec_layout.h"
#include "LosTopos/io/text_reader.h"
#include "LosTopos/io/vtk_surface.h"

namespace lostopos {
namespace {

void write_soap_film_rec(const std::filesystem::path& path, const SurfaceData& data) {
  write_rec(path, data);
}

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 2> moving{velocity_array, vertex_id_array};
constexpr std::array<std::string_view, 1> solids{solid_array};
constexpr std::array<std::string_view, 1> tensions{tension_array};

constexpr std::array<MeshFormat, 7> formats{
    {{".ply", "PLY, the frames of a run (read: ascii or binary; written: binary)", false, false, false, moving, solids,
      read_ply, write_ply, 4},
     {".obj", "Wavefront OBJ, a group region_P_Q a film", false, false, false, moving, Names(), read_obj, write_obj, 5},
     {".vtp", "ParaView XML PolyData, with arrays", false, false, true, Names(), Names(), read_vtp, write_vtp, 12},
     {".vtu", "VTK XML UnstructuredGrid, with arrays", false, false, true, Names(), Names(), read_vtu, write_vtu, 12},
     {".fe", "datafile of Surface Evolver, with bodies, tensions and fixed vertices", false, true, false, Names(),
      tensions, read_fe, write_fe, 16},
     {".rec", "binary record of the soap-film program, with circulation (read: the tracker program's too)", true, true,
      false, Names(), Names(), read_rec, write_soap_film_rec, 1.5},
     {".arec", "text record of the tracker program", false, false, false, Names(), Names(), read_arec, write_arec, 4}}};

const MeshFormat* format_named(std::string_view extension) {
  const auto found = std::ranges::find(formats, extension, &MeshFormat::extension);
  return found == formats.end() ? nullptr : &*found;
}

// By the first word of the file, and the second where that is not enough.
const MeshFormat* sniff_text(std::string_view start) {
  const std::string_view all = start;
  const std::string_view first = take_word(start);
  if (first == "ply") return format_named(".ply");
  if (all.find("<VTKFile") != std::string_view::npos) {
    if (all.find("\"PolyData\"") != std::string_view::npos) return format_named(".vtp");
    if (all.find("\"UnstructuredGrid\"") != std::string_view::npos) return format_named(".vtu");
  }
  if (all.find('\0') != std::string_view::npos) return nullptr;  // no text: what starts like a number is chance
  if (starts_like_fe(all)) return format_named(".fe");
  constexpr std::array<std::string_view, 5> obj_words{"v", "vn", "vt", "g", "mtllib"};
  std::string_view rest = all;
  for (int line = 0; line < 100 && !rest.empty(); ++line) {  // past the comments
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view words = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string_view word = take_word(words);
    if (word.empty() || word[0] == '#') continue;
    if (std::ranges::find(obj_words, word) != obj_words.end()) return format_named(".obj");
    break;
  }
  return base::parse_integer(first) ? format_named(".arec") : nullptr;
}

// Looked at before the file is read: its text is held as a whole.
void require_memory(const std::filesystem::path& path, const MeshFormat& format) {
  constexpr double share_of_free = 0.8;
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  const auto available = base::available_memory();
  if (failed || !available) return;  // reading says what is wrong with the file
  const double needed = format.memory_of_byte * static_cast<double>(size);
  if (needed <= share_of_free * *available) return;
  throw base::InputError("'" + path.string() + "' has " + base::bytes_in_words(static_cast<double>(size)) +
                         ", and reading it may take " + base::bytes_in_words(needed) + " of memory; " +
                         base::bytes_in_words(share_of_free * *available) + " can be taken here");
}

[[noreturn]] void throw_unknown(const std::filesystem::path& path, const std::string& problem) {
  throw base::InputError("'" + path.string() + "': " + problem + "; known are " + mesh_extensions());
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
  return formats;
}

std::string mesh_extensions() {
  std::string list;
  for (const MeshFormat& format : formats) list.append(list.empty() ? "" : ", ").append(format.extension);
  return list;
}

const MeshFormat* find_mesh_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return format_named(extension);
}

const MeshFormat& require_mesh_format(const std::filesystem::path& path) {
  const MeshFormat* format = find_mesh_format(path);
  if (!format) throw_unknown(path, "no surface format has the extension " + in_quotes(path.extension().string()));
  return *format;
}

const MeshFormat* sniff_mesh_format(const std::filesystem::path& path) {
  ByteReader bytes(path);
  std::string start;
  const std::uint64_t length = std::min<std::uint64_t>(bytes.size(), 4096);
  while (start.size() < length) start += bytes.read<char>();
  if (const MeshFormat* format = sniff_text(start)) return format;
  return is_rec(bytes) ? format_named(".rec") : nullptr;
}

SurfaceData read_surface(const std::filesystem::path& path) {
  const MeshFormat* shown = sniff_mesh_format(path);
  const MeshFormat* named = find_mesh_format(path);
  if (!named && !shown) throw_unknown(path, "neither the extension nor the content is that of a known surface format");
  if (named && shown && named != shown)
    throw base::InputError("'" + path.string() + "' has the content of a " + std::string(shown->extension) +
                           " file; rename it");
  const MeshFormat& format = named ? *named : *shown;
  require_memory(path, format);
  return format.read(path);
}

void write_surface(const std::filesystem::path& path, const SurfaceData& data) {
  require_mesh_format(path).write(path, data);
}

}  // namespace lostopos

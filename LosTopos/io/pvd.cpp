#include "LosTopos/io/pvd.h"

#include <cmath>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/vtk_array.h"
#include "LosTopos/io/xml_reader.h"

namespace lostopos {
namespace {

PvdFrame read_frame(const XmlReader& xml) {
  const std::string time_text = xml.attribute("timestep");
  const auto time = base::parse_double(time_text);
  if (!time || !std::isfinite(*time)) xml.fail("timestep is " + in_quotes(time_text) + "; a number would be right");
  PvdFrame frame{*time, xml.attribute("file")};
  if (frame.file.empty()) xml.fail("a frame's attribute 'file' is empty");
  return frame;
}

}  // namespace

std::vector<PvdFrame> read_pvd(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const std::string text = bytes.read_text();
  XmlReader xml(text, bytes.name());
  std::vector<PvdFrame> frames;
  if (xml.next() == XmlReader::Event::Start) read_vtk_root(xml, "Collection");
  bool has_collection = false;
  for (auto event = xml.next(); event != XmlReader::Event::Finished; event = xml.next()) {  // every turn passes a tag
    if (event != XmlReader::Event::Start) continue;
    if (xml.tag() == "Collection") {
      has_collection = true;
    } else if (xml.tag() == "DataSet" && has_collection) {
      frames.push_back(read_frame(xml));
    } else {
      xml.skip_element();
    }
  }
  if (!has_collection) xml.fail("no element 'Collection' in the file");
  return frames;
}

void write_pvd(const std::filesystem::path& path, const std::vector<PvdFrame>& frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const PvdFrame& frame : frames) {
    if (!std::isfinite(frame.time)) throw base::InputError("frame '" + frame.file + "' has a time that is not finite");
    if (frame.file.empty()) throw base::InputError("a frame has no file");
    base::append_number(text += "<DataSet timestep=\"", frame.time);
    text += "\" part=\"0\" file=\"" + xml_escape(frame.file) + "\"/>\n";
  }
  base::AtomicFile file(path);
  file.stream() << text << "</Collection>\n</VTKFile>\n";
  file.commit();
}

void PvdWriter::add(double time, const std::string& file) {
  std::vector<PvdFrame> frames = frames_;
  std::erase_if(frames, [&file](const PvdFrame& frame) { return frame.file == file; });
  frames.push_back({time, file});
  write_pvd(path_, frames);
  frames_ = std::move(frames);
}

}  // namespace lostopos

#include "LosTopos/io/vtk_array.h"

#include <bit>

#include "Base/io/number_text.h"
#include "Base/machine/memory.h"
#include "LosTopos/io/base64.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/text_reader.h"
#include "LosTopos/io/vtk_compression.h"

namespace lostopos {
namespace {

template <class T>
std::vector<double> convert(std::string_view bytes, std::endian order) {
  std::vector<double> values;
  values.reserve(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T))
    values.push_back(static_cast<double>(number_from_bytes<T>(bytes.data() + i, order)));
  return values;
}

struct NumberType {
  std::string_view name;
  std::size_t size;
  std::vector<double> (*convert)(std::string_view, std::endian);
};

constexpr std::array<NumberType, 10> number_types{{{"Float64", 8, convert<double>},
                                                   {"Float32", 4, convert<float>},
                                                   {"Int64", 8, convert<std::int64_t>},
                                                   {"UInt64", 8, convert<std::uint64_t>},
                                                   {"Int32", 4, convert<std::int32_t>},
                                                   {"UInt32", 4, convert<std::uint32_t>},
                                                   {"Int16", 2, convert<std::int16_t>},
                                                   {"UInt16", 2, convert<std::uint16_t>},
                                                   {"Int8", 1, convert<std::int8_t>},
                                                   {"UInt8", 1, convert<std::uint8_t>}}};

[[noreturn]] void fail(const XmlReader& xml, const DataArray& array, const std::string& problem) {
  xml.fail("array " + in_quotes(array.name) + ": " + problem);
}

std::vector<double> decode_text(const XmlReader& xml, const DataArray& array) {
  std::vector<double> values;
  std::string_view rest = xml.text();
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const auto value = base::parse_double(word);
    if (!value) fail(xml, array, in_quotes(word) + " is no number");
    values.push_back(*value);
  }
  return values;
}

// What the file stands for may be a thousand times of what it takes.
void require_memory_for(const XmlReader& xml, const DataArray& array, std::uint64_t bytes, std::size_t width) {
  constexpr double share_of_free = 0.8;
  const double needed = static_cast<double>(bytes) * (1 + sizeof(double) / static_cast<double>(width));
  const auto available = base::available_memory();
  if (available && needed > share_of_free * *available)
    fail(xml, array,
         "reading it takes " + base::bytes_in_words(needed) + " of memory; " +
             base::bytes_in_words(share_of_free * *available) + " can be taken here");
}

std::vector<double> decode_compressed(const XmlReader& xml, const DataArray& array, const VtkEncoding& encoding,
                                      const NumberType& type, std::string_view decoded) {
  const std::endian order = encoding.little_endian ? std::endian::little : std::endian::big;
  const auto size = vtk_decompressed_size(decoded, order, encoding.wide_header);
  if (!size || *size % type.size != 0) fail(xml, array, "its compressed blocks are damaged");
  require_memory_for(xml, array, *size, type.size);
  const auto bytes = vtk_decompress(decoded, order, encoding.wide_header);
  if (!bytes) fail(xml, array, "its compressed blocks are damaged");
  return type.convert(*bytes, order);
}

std::vector<double> decode_binary(const XmlReader& xml, const DataArray& array, const VtkEncoding& encoding,
                                  const NumberType& type) {
  const auto decoded = base64_decode(xml.text());
  if (!decoded) fail(xml, array, "its content is not base64");
  const std::endian order = encoding.little_endian ? std::endian::little : std::endian::big;
  const std::size_t header = encoding.wide_header ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
  // ParaView leaves out the header of an array without numbers.
  if (decoded->empty()) return {};
  if (encoding.compressed) return decode_compressed(xml, array, encoding, type, *decoded);
  if (decoded->size() < header) fail(xml, array, "its content is shorter than its byte count");
  const std::uint64_t count = encoding.wide_header ? number_from_bytes<std::uint64_t>(decoded->data(), order)
                                                   : number_from_bytes<std::uint32_t>(decoded->data(), order);
  const std::string_view bytes = std::string_view(*decoded).substr(header);
  if (count != bytes.size() || count % type.size != 0)
    fail(xml, array,
         "it announces " + std::to_string(count) + " bytes of " + std::string(type.name) + " and holds " +
             std::to_string(bytes.size()));
  return type.convert(bytes, order);
}

}  // namespace

VtkEncoding read_vtk_root(const XmlReader& xml, const char* wanted_type) {
  if (xml.tag() != "VTKFile")
    xml.fail("not a VTK file: its root element is " + in_quotes(xml.tag()) + ", not 'VTKFile'");
  if (const std::string type = xml.attribute("type"); type != wanted_type)
    xml.fail("a VTK file of type " + in_quotes(type) + "; '" + wanted_type + "' is wanted");
  const std::string compressor = xml.attribute("compressor", "");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    xml.fail("arrays compressed by " + in_quotes(compressor) + " are not read; save the file with zlib, or without");
  VtkEncoding encoding;
  encoding.compressed = !compressor.empty();
  const std::string byte_order = xml.attribute("byte_order", "LittleEndian");
  if (byte_order != "LittleEndian" && byte_order != "BigEndian")
    xml.fail("byte_order is " + in_quotes(byte_order) + "; LittleEndian and BigEndian are known");
  encoding.little_endian = byte_order == "LittleEndian";
  const std::string header_type = xml.attribute("header_type", "UInt32");
  if (header_type != "UInt32" && header_type != "UInt64")
    xml.fail("header_type is " + in_quotes(header_type) + "; UInt32 and UInt64 are known");
  encoding.wide_header = header_type == "UInt64";
  return encoding;
}

DataArray read_vtk_array(XmlReader& xml, const VtkEncoding& encoding) {
  DataArray array{xml.attribute("Name", ""), 1, {}};
  const auto components = base::parse_integer(xml.attribute("NumberOfComponents", "1"));
  if (!components || *components < 1 || *components > 1000)
    fail(xml, array, "NumberOfComponents is " + in_quotes(xml.attribute("NumberOfComponents", "")));
  array.components = static_cast<int>(*components);
  const std::string type_name = xml.attribute("type"), format = xml.attribute("format", "ascii");
  const auto type = std::ranges::find(number_types, type_name, &NumberType::name);
  if (type == number_types.end()) fail(xml, array, "its type " + in_quotes(type_name) + " is no number type of VTK");
  if (format == "ascii") {
    array.values = decode_text(xml, array);
  } else if (format == "binary") {
    array.values = decode_binary(xml, array, encoding, *type);
  } else {
    fail(xml, array, "its format is " + in_quotes(format) + "; ascii and binary (inline, not appended) are read");
  }
  while (xml.next() == XmlReader::Event::Start) {  // ends with the array, or throws
    if (xml.tag() == "InformationKey" && xml.attribute("name", "") == "UNITS_LABEL") {
      std::string_view rest = xml.text();
      array.unit = take_word(rest);
    }
    xml.skip_element();
  }
  return array;
}

}  // namespace lostopos

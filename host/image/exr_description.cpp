#include "morphcl/exr.hpp"

#include <ImfBoxAttribute.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfLineOrderAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfTimeCodeAttribute.h>
#include <ImfVecAttribute.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <set>

#include "host/image/exr_compression.hpp"
#include "host/image/exr_header_check.hpp"
#include "host/image/exr_stream.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {
const std::set<std::string> shown_by_fields = {"channels", "compression", "dataWindow", "displayWindow"};

const char* type_name(Imf::PixelType type) {
  constexpr std::array<const char*, 3> names = {"uint", "half", "float"};
  return type < names.size() ? names[type] : "unknown";
}

ExrWindow window(const Imath::Box2i& box) { return {{box.min.x, box.min.y}, {box.max.x, box.max.y}}; }

std::string matrix_text(const Imath::M44f& matrix) {
  std::vector<std::string> rows;
  for (int row = 0; row < 4; ++row) rows.push_back(fmt::format("({})", fmt::join(matrix[row], matrix[row] + 4, " ")));
  return fmt::format("{}", fmt::join(rows, " "));
}

std::string time_code_text(const Imf::TimeCode& code) {
  return fmt::format("{:02}:{:02}:{:02}{}{:02}", code.hours(), code.minutes(), code.seconds(),
                     code.dropFrame() ? ';' : ':', code.frame());
}

std::string chromaticities_text(const Imf::Chromaticities& c) {
  return fmt::format("red ({} {}) green ({} {}) blue ({} {}) white ({} {})", c.red.x, c.red.y, c.green.x, c.green.y,
                     c.blue.x, c.blue.y, c.white.x, c.white.y);
}

std::string value_text(const Imf::Attribute& attribute) {
  if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute)) return text->value();
  if (const auto* number = dynamic_cast<const Imf::IntAttribute*>(&attribute)) return std::to_string(number->value());
  if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&attribute)) return fmt::to_string(number->value());
  if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute))
    return fmt::to_string(number->value());
  if (const auto* ratio = dynamic_cast<const Imf::RationalAttribute*>(&attribute))
    return fmt::format("{}/{}", ratio->value().n, ratio->value().d);
  if (const auto* v = dynamic_cast<const Imf::V2fAttribute*>(&attribute))
    return fmt::format("({} {})", v->value().x, v->value().y);
  if (const auto* order = dynamic_cast<const Imf::LineOrderAttribute*>(&attribute))
    return order->value() == Imf::INCREASING_Y   ? "increasing y"
           : order->value() == Imf::DECREASING_Y ? "decreasing y"
                                                 : "random y";
  if (const auto* code = dynamic_cast<const Imf::TimeCodeAttribute*>(&attribute)) return time_code_text(code->value());
  if (const auto* matrix = dynamic_cast<const Imf::M44fAttribute*>(&attribute)) return matrix_text(matrix->value());
  if (const auto* c = dynamic_cast<const Imf::ChromaticitiesAttribute*>(&attribute))
    return chromaticities_text(c->value());
  return "";
}

ExrDescription describe(const Imf::MultiPartInputFile& file) {
  const Imf::Header& header = file.header(0);
  ExrDescription result;
  result.parts = file.parts();
  result.data_window = window(header.dataWindow());
  result.display_window = window(header.displayWindow());
  result.compression = compression_name(header.compression());
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    result.channels.push_back({channel.name(), type_name(channel.channel().type)});
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
    if (shown_by_fields.count(attribute.name()) == 0)
      result.attributes.push_back(
          {attribute.name(), attribute.attribute().typeName(), value_text(attribute.attribute())});
  return result;
}
}  // namespace

ExrDescription describe_exr(const std::string& path) {
  try {
    FileInput input(path);
    check_exr_header(input);
    return describe(Imf::MultiPartInputFile(input, 0, false));
  } catch (const Error& error) {
    throw error.at(path);
  } catch (const std::exception& error) {
    throw Error(ErrorKind::bad_input, path, fmt::format("not a readable EXR file: {}", error.what()));
  }
}

}  // namespace morphcl
